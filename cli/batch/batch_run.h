// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "cli/batch/batch_folder.h"
#include "cli/batch/batch_report.h"
#include "cli/batch/interruption.h"
#include "cli/batch/submission.h"
#include "cli/session/batch_session.h"

namespace flair::cli {

// How a batch is followed to its end.
struct BatchRunOptions {
  // What to do when nobody takes jobs; empty when this process does.
  std::string remedy;
  // Submits and does not wait for results.
  bool submit_only = false;
  bool quiet = false;
  // The summary as JSON on standard output instead of text on standard error.
  bool json = false;
};

// Submits the lines of `input`, when there is one, and meanwhile collects into `folder`, which remembers the batch,
// what ends. Returns when all has ended: OK when every line became a job that succeeded, otherwise a status with the
// exit code of docs/batches.md. After an interruption or an error the same call goes on where this one was.
absl::Status RunBatch(const v1::Batch& batch, BatchSession& session, BatchFolder& folder, Submission* submission,
                      Interruption& interruption, const BatchRunOptions& options);

// How a batch ended, as an exit code; OK when all succeeded. `name` is how people call it in the next command.
absl::Status EndOf(const BatchReport& report, const std::string& name);

}  // namespace flair::cli
