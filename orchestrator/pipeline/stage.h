// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/model_call.pb.h"
#include "orchestrator/pipeline/catalog_cache.h"
#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {

// What a stage is given. Valid during the stage only.
struct StageRun {
  const std::string& job_id;
  const v1::JobSpec& spec;
  // By kind, see Input(); a stage sees only its own inputs.
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

// The stages in order; a stage's inputs are outputs of stages before it. Stages of which none needs another run at the
// same time.
std::span<const Stage> Stages();

// The input of that kind; it is there because the stage's table entry says so.
const v1::Artifact& Input(const StageRun& run, v1::ArtifactKind kind);

// Key of the stage's request, the same whenever the stage is run again for the same job.
std::string RequestId(const StageRun& run, std::string_view stage);

// Its place in Stages(); -1 when there is no stage of that name.
int StageIndex(std::string_view name);

// "brief, room, zones, ...", for messages that say what there is.
std::string StageNames();

// Most pictures that a job may ask for beside its preview, each a stage "view_1", "view_2", ...
inline constexpr int kFurtherViewLimit = 4;

// What specs ask of the stages that take something from them.
std::string AskedBrief(const v1::JobSpec& spec);
std::string AskedOfModels(const v1::JobSpec& spec);
std::string AskedOfSolver(const v1::JobSpec& spec);
std::string AskedOfRenderer(const v1::JobSpec& spec);

// The stages' functions, one file each for the worker they ask.
absl::StatusOr<v1::Artifact> RunBrief(const StageRun& run);
absl::StatusOr<v1::Artifact> RunRoom(const StageRun& run);
absl::StatusOr<v1::Artifact> RunZones(const StageRun& run);
absl::StatusOr<v1::Artifact> RunObjects(const StageRun& run);
absl::StatusOr<v1::Artifact> RunStyle(const StageRun& run);
absl::StatusOr<v1::Artifact> RunConstraints(const StageRun& run);
absl::StatusOr<v1::Artifact> RunCleaning(const StageRun& run);
absl::StatusOr<StageOptions> TranslationOptions(const StageRun& run);
absl::StatusOr<v1::Artifact> RunTranslation(const StageRun& run);
absl::StatusOr<v1::Artifact> RunSolve(const StageRun& run);
absl::StatusOr<v1::Artifact> RunRender(const StageRun& run);
absl::StatusOr<StageOptions> ReportOptions(const StageRun& run);
absl::StatusOr<v1::Artifact> RunReport(const StageRun& run);

// A stage that draws a further view; `number` counts from 0.
Stage FurtherViewStage(int number);

}  // namespace flair::orchestrator
