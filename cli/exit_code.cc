// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_code.h"

#include <cstdlib>

namespace flair::cli {
namespace {
// Marks a status that stands for an exit code of its own.
constexpr char kCode[] = "flair.cli/exit_code";
}  // namespace

int ExitCodeOf(const absl::Status& status) {
  if (const auto code = status.GetPayload(kCode); code.has_value()) return std::atoi(std::string(*code).c_str());
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

absl::Status About(const std::string& subject, const absl::Status& status) {
  return absl::Status(status.code(), subject + ": " + std::string(status.message()));
}

absl::Status EndWith(ExitCode code, const std::string& message) {
  absl::Status status = absl::UnknownError(message);
  // By a view: clang names the constructor from a string otherwise than the GCC that built the library.
  const std::string digits = std::to_string(code);
  status.SetPayload(kCode, absl::Cord(absl::string_view(digits)));
  return status;
}

absl::Status DiffersStatus() { return EndWith(kExitDiffers, ""); }

absl::Status BrokenPromises(const std::string& message) { return EndWith(kExitBroken, message); }

absl::Status ModelError(const std::string& message) { return absl::AbortedError(message); }

}  // namespace flair::cli
