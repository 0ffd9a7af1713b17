// SPDX-License-Identifier: GPL-3.0-or-later
// Which batch, and where it is, as a person says it; for all that `flair batch` does.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "CLI/CLI.hpp"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cli/batch/batch_folder.h"
#include "cli/batch/batch_run.h"
#include "cli/input/llm_flags.h"
#include "cli/input/service_flags.h"
#include "cli/session/batch_session.h"
#include "cli/session/session.h"

namespace flair::cli {

// Where jobs wait and who runs them.
struct BatchFlags {
  std::string orchestrator;
  EngineFlags engine;
  // The local store; that of all commands when empty.
  std::string store;
  // Jobs at once in this process; nothing when not given.
  std::optional<int> parallel;
  StageFlags stages;
  LlmFlags llm;
};

// Adds --orchestrator and the flags of a queue; with `runs_jobs`, also those of what runs jobs in this process.
void AddBatchFlags(CLI::App& command, BatchFlags& flags, bool runs_jobs);

// An open way to the batches, alive while the command is.
struct BatchWay {
  std::unique_ptr<Session> session;
  std::unique_ptr<BatchSession> batches;
  // What to do when nobody takes jobs; empty when this process does.
  std::string remedy;
};

// Opens it; `llm` is the model of the jobs that run here. UNAVAILABLE and so on as Session; INVALID_ARGUMENT for flags
// that do not go together.
absl::StatusOr<BatchWay> OpenBatchWay(const BatchFlags& flags, bool runs_jobs, const OptionalLlm& llm,
                                      Interruption& interruption);

// What a person calls a batch: its id, the beginning of it, or the folder of an earlier run.
struct NamedBatch {
  v1::Batch batch;
  // The folder; empty when it was named by its id.
  std::filesystem::path folder;
};

// What of the flags a folder remembers.
void FillPlace(const BatchFlags& flags, BatchPlace& place);

// Where the folder `name` says that its batch is, unless flags say otherwise.
absl::Status TakePlaceOf(const std::string& name, BatchFlags& flags);

// NOT_FOUND when there is none, INVALID_ARGUMENT when several ids begin so.
absl::StatusOr<NamedBatch> FindBatch(const std::string& name, BatchSession& batches);

// What is done with a batch that is there: status, watch, pause, resume, cancel, retry, delete, report, list.
void AddBatchActions(CLI::App& batch, absl::Status& result);

}  // namespace flair::cli
