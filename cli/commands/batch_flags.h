// SPDX-License-Identifier: GPL-3.0-or-later
// Which batch, and where it is, as a person says it; for all that `flair batch` does.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "cli/batch/batch_input.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/collector.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/session/session.h"

namespace flair::cli {

// Where jobs wait.
struct BatchPlaceFlags : Options {
  using Options::Options;
  std::string& orchestrator = Text("--orchestrator HOST:PORT", "Use this orchestrator instead of the built-in one");
  EngineFlags engine{command()};
  // The local store; that of all commands when empty.
  std::string store;
};

// Who runs jobs in this process.
struct BatchRunFlags : Options {
  using Options::Options;
  std::optional<int>& parallel = Whole(
      "--parallel N", 1, 256, "Jobs at once in this process, 1 to 256 (cores; with --engine none: others run them)");
  StageFlags stages{command()};
  LlmFlags llm{command()};
};

// What becomes of the results of a batch.
struct CollectFlags : Options {
  using Options::Options;
  absl::StatusOr<KeptFiles> Kept() const { return KeptFiles::Parse(kept.empty() ? KeptFiles::kDefault : kept); }

  std::string& kept =
      Text("--keep A,B",
           "Files of each job: brief, room, ..., graph, layout, pictures, report, report.md, all, none; NAME.json "
           "for JSON (layout,pictures,report)");
  int& shard_size = Whole("--shards JOBS", 1, 1000000, 0,
                          "Tar files of this many jobs, 1 to 1000000, instead of a folder for each job");
};

// An open way to the batches, alive while the command is.
struct BatchWay {
  std::unique_ptr<Session> session;
  // What to do when nobody takes jobs; empty when this process does.
  std::string remedy;
};

// Opens it; with `runs`, jobs run here and `llm` is their model. UNAVAILABLE and so on as Session; INVALID_ARGUMENT for
// flags that do not go together.
absl::StatusOr<BatchWay> OpenBatchWay(const BatchPlaceFlags& flags, const BatchRunFlags* runs, const OptionalLlm& llm,
                                      Interruption& interruption);

// What a person calls a batch: its id, the beginning of it, or the folder of an earlier run.
struct NamedBatch {
  v1::Batch batch;
  // The folder; empty when it was named by its id.
  std::filesystem::path folder;
};

// What of the flags a folder remembers.
void FillPlace(const BatchPlaceFlags& flags, BatchPlace& place);

// Where the folder `name` says that its batch is, unless flags say otherwise.
absl::Status TakePlaceOf(const std::string& name, BatchPlaceFlags& flags);

// NOT_FOUND when there is none, INVALID_ARGUMENT when several ids begin so.
absl::StatusOr<NamedBatch> FindBatch(const std::string& name, Session& session);

// What is done with a batch that is there: status, watch, pause, resume, cancel, retry, delete, report, list.
void AddBatchActions(const Commands& batch);

}  // namespace flair::cli
