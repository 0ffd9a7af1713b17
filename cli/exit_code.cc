// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_code.h"

namespace flair::cli {

int ExitCodeOf(const absl::Status& status) {
  switch (status.code()) {
    case absl::StatusCode::kOk:
      return kExitDone;
    case absl::StatusCode::kInvalidArgument:
    case absl::StatusCode::kNotFound:
    case absl::StatusCode::kAlreadyExists:
    case absl::StatusCode::kOutOfRange:
      return kExitBadInput;
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kDeadlineExceeded:
    case absl::StatusCode::kResourceExhausted:
      return kExitUnreachable;
    case absl::StatusCode::kFailedPrecondition:
    case absl::StatusCode::kPermissionDenied:
      return kExitFiles;
    case absl::StatusCode::kDataLoss:
      return kExitCorrupt;
    case absl::StatusCode::kAborted:
    case absl::StatusCode::kUnauthenticated:
      return kExitModel;
    default:
      return kExitFailed;
  }
}

absl::Status FileError(const std::string& message) { return absl::FailedPreconditionError(message); }

absl::Status ModelError(const std::string& message) { return absl::AbortedError(message); }

}  // namespace flair::cli
