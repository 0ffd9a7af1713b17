// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"

namespace flair::orchestrator {

// What the end of a call says about its worker. docs/workers.md has the table.
enum class Verdict {
  // It works: it answered, or refused the request for what is in it.
  kGood,
  // It has more to do than it takes (RESOURCE_EXHAUSTED). Others may have room.
  kFull,
  // It could not be reached, is gone or serves something else (UNAVAILABLE, UNIMPLEMENTED). Others may be there.
  kLost,
  // It failed (INTERNAL, UNKNOWN, DATA_LOSS).
  kFailed,
  // It did not answer in time (DEADLINE_EXCEEDED).
  kLate,
  // Nothing: we gave the call up.
  kNone,
};

Verdict VerdictOf(const absl::Status& status);

}  // namespace flair::orchestrator
