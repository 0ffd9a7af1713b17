// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/verdict.h"

#include "orchestrator/pipeline/backoff_policy.h"

namespace flair::orchestrator {

Verdict VerdictOf(const absl::Status& status) {
  switch (status.code()) {
    case absl::StatusCode::kResourceExhausted:
      // The request cannot be carried to any worker.
      return IsMessageTooLarge(status) ? Verdict::kGood : Verdict::kFull;
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kUnimplemented:
      return Verdict::kLost;
    case absl::StatusCode::kInternal:
    case absl::StatusCode::kUnknown:
    case absl::StatusCode::kDataLoss:
      return Verdict::kFailed;
    case absl::StatusCode::kDeadlineExceeded:
      return Verdict::kLate;
    case absl::StatusCode::kCancelled:
      return Verdict::kNone;
    default:
      return Verdict::kGood;
  }
}

}  // namespace flair::orchestrator
