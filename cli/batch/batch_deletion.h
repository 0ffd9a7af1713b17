// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a batch's memory, as a person sees it.
#pragma once

#include <string>

#include "absl/status/status.h"
#include "cli/session/batch_session.h"
#include "flair/v1/orchestrator_service.pb.h"

namespace flair::cli {

struct DeletionOptions {
  // Does not ask.
  bool yes = false;
  // One JSON object on standard output instead of text.
  bool json = false;
};

// Why the batch cannot be deleted yet, and what to do; OK when it can.
absl::Status CheckHasEnded(const v1::Batch& batch);

// Deletes the batch with its jobs and what only they have, step by step, and says so: how far it came, when it takes
// long, and what was freed. Asks the person at the terminal first; where none is, `yes` must be set. What it cannot do,
// and being stopped in the middle, end with the exit codes of exit_code.h.
absl::Status DeleteWholeBatch(const v1::Batch& batch, BatchSession& batches, const DeletionOptions& options);

}  // namespace flair::cli
