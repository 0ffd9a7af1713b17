// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a job: what each needs, makes and asks for, and which of them a replay runs.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/model_call.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {

// What an optimizer understands, the same for all jobs.
struct SharedCatalog {
  v1::ConstraintCatalog catalog;
  // SHA-256 of its canonical bytes, in hex.
  std::string digest;
};

// The catalogue of each optimizer that was asked: every job wants it, and an optimizer of one revision has one.
// Thread-safe.
class CatalogCache {
 public:
  // Asks the optimizer unless one of its revision was asked before. Errors as StageClients.
  absl::StatusOr<std::shared_ptr<const SharedCatalog>> Get(StageClients& clients, StageCall& call);

 private:
  std::mutex mutex_;
  // By revision.
  std::map<std::string, std::shared_ptr<const SharedCatalog>> catalogs_;
};

// What a stage is given. Valid during the stage only.
struct StageRun {
  // Stage::name.
  std::string_view stage;
  const std::string& job_id;
  const v1::JobSpec& spec;
  // In no order; a stage sees only its own inputs.
  std::span<const v1::Artifact* const> inputs;
  // What the stage's `options` or `asked` function returned, and its digest; both empty while that function runs.
  std::string_view options;
  std::string_view options_digest;
  // What this program was built from; for the artifacts that it makes itself.
  const std::string& build;
  // What the stages before it took; for the report.
  std::span<const v1::StageTiming> timings;
  // What models consumed in them.
  const v1::ModelUsage& model_usage;
  StageClients& clients;
  CatalogCache& catalogs;
  StageClients::Call& call;
  // What the stage's `options` function found; null while that runs and where there is none.
  const SharedCatalog* catalog = nullptr;
};

// What decides a stage's result besides its inputs.
struct StageOptions {
  // Canonical.
  std::string bytes;
  // Null where none is needed.
  std::shared_ptr<const SharedCatalog> catalog;
};

// One step of the way from a brief to a report: a pure function of its inputs and options, made by one RPC, so that it
// can be made again after a failure and its result used again.
struct Stage {
  // As in JobEvent.stage.
  std::string_view name;
  v1::ArtifactKind output;
  // What it is made from, in the order of Artifact.made_from_ids.
  std::vector<v1::ArtifactKind> inputs;
  // Canonical bytes of the part of a job's spec that decides the result; null when none does.
  std::string (*asked)(const v1::JobSpec&);
  // All options that decide the result; null when they are what is asked.
  absl::StatusOr<StageOptions> (*options)(const StageRun&);
  // The artifact with content and producer.
  absl::StatusOr<v1::Artifact> (*run)(const StageRun&);
  // Whether a job has the stage; null when every job has.
  bool (*wanted)(const v1::JobSpec&) = nullptr;
};

// OK for what a stage can have made. A worker may be anybody's program; an answer that no stage could go on with ends
// the job here, not somewhere later. INTERNAL says whose it was.
absl::Status CheckAnswer(const Stage& stage, const v1::Artifact& artifact);

// The stages in order, see stages.cc; a stage's inputs are outputs of stages before it. Stages of which none needs
// another run at the same time.
std::span<const Stage> Stages();

// The stage that makes layouts.
inline constexpr std::string_view kSolve = "solve";

// Its place in Stages(); -1 when there is no stage of that name.
int StageIndex(std::string_view name);

// "brief, room, zones, ...", for messages that say what there is.
std::string StageNames();

// Most pictures that a job may ask for beside its preview, each a stage "view_1", "view_2", ...
inline constexpr int kFurtherViewLimit = 4;

// What a spec asks of the first stage.
std::string AskedBrief(const v1::JobSpec& spec);

// The layout that a job had from its beginning on, which is one without the graph that it would have been solved from;
// null when it had none.
const v1::ArtifactRef* GivenLayout(const v1::Job& job);

// Index of the first stage that a replay runs. The stage must be known (CheckReplay).
int FirstStageOf(const v1::Replay& replay);

// Says whether a job can replay `earlier`, the job that it names: INVALID_ARGUMENT for a stage that there is not and
// for another brief than that job's where its brief is taken, FAILED_PRECONDITION when that job did not come so far.
absl::Status CheckReplay(const v1::JobSpec& spec, const v1::Job& earlier);

// Names the earlier job's artifact of a stage. FAILED_PRECONDITION when it has none.
absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, WorkQueue& queue);
absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, const v1::Job& earlier);

// For each stage whether the specs ask for another result of it, of itself or because one of its inputs is another.
std::vector<bool> StagesAskedToDiffer(const v1::JobSpec& first, const v1::JobSpec& second);

// What was found and what models used, in numbers and in words for people.

// What was found, in one line for people: "3 zones: sleeping, storage, work".
std::string Summarize(const v1::Artifact& artifact);

// What models did for it: "3 calls of gpt-4o, 1 repair, 5012 tokens, 0.0213 USD"; empty when none was asked.
std::string SummarizeModels(const v1::Artifact& artifact);

// "5012 tokens, 0.0213 USD", "about 5012 tokens" where they were not counted; no price where there is none.
std::string SummarizeUsage(const v1::ModelUsage& usage);

// A step of a model call that asked for a better answer.
bool IsRepair(const v1::ModelCall& call);

// Adds what the calls behind an artifact consumed.
void AddUsage(const v1::Artifact& artifact, v1::ModelUsage& usage);

// The options of a request: those of the job with what is left of its budget, never below 0.
v1::ModelOptions OptionsLeft(const v1::ModelOptions& job_options, const v1::ModelUsage& spent);

}  // namespace flair::orchestrator
