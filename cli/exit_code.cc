// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_code.h"

namespace flair::cli {

namespace {
// Marks a status that is no failure.
constexpr char kDiffers[] = "flair.cli/differs";
// Marks a status that is a server's failure.
constexpr char kBroken[] = "flair.cli/broken";
}  // namespace

int ExitCodeOf(const absl::Status& status) {
  if (status.GetPayload(kDiffers).has_value()) return kExitDiffers;
  if (status.GetPayload(kBroken).has_value()) return kExitBroken;
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
    case absl::StatusCode::kUnimplemented:
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

absl::Status DiffersStatus() {
  absl::Status status = absl::UnknownError("");
  status.SetPayload(kDiffers, absl::Cord());
  return status;
}

absl::Status BrokenPromises(const std::string& message) {
  absl::Status status = absl::UnknownError(message);
  status.SetPayload(kBroken, absl::Cord());
  return status;
}

absl::Status ModelError(const std::string& message) { return absl::AbortedError(message); }

}  // namespace flair::cli
