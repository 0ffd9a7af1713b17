// SPDX-License-Identifier: GPL-3.0-or-later
// Early returns for functions that return absl::Status or absl::StatusOr, and errors put together as fmt::format does
// it:
//   RETURN_IF_ERROR(store.Open(path));
//   ASSIGN_OR_RETURN(v1::Job job, store.GetJob(id));   // `auto job` where the type has a comma
//   return InvalidArgument("{}: {}; at most {} bytes", path, status.message(), kMostBytes);
// Header only; every folder may include it.
#pragma once

#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"
#include "fmt/format.h"

#define FLAIR_STATUS_JOIN_INNER(a, b) a##b
#define FLAIR_STATUS_JOIN(a, b) FLAIR_STATUS_JOIN_INNER(a, b)

// Returns the status of the expression from the surrounding function unless it is OK.
#define RETURN_IF_ERROR(...)                                             \
  do {                                                                   \
    if (absl::Status flair_status = (__VA_ARGS__); !flair_status.ok()) { \
      return flair_status;                                               \
    }                                                                    \
  } while (false)

// Assigns the value of a StatusOr to `lhs`, a declaration or an existing variable, or returns its status.
#define ASSIGN_OR_RETURN(lhs, ...) \
  FLAIR_ASSIGN_OR_RETURN(FLAIR_STATUS_JOIN(flair_status_or_, __LINE__), lhs, __VA_ARGS__)
#define FLAIR_ASSIGN_OR_RETURN(result, lhs, ...) \
  auto result = (__VA_ARGS__);                   \
  if (!result.ok()) return result.status();      \
  lhs = *std::move(result)

template <>
struct fmt::formatter<absl::string_view> : fmt::formatter<std::string_view> {
  auto format(absl::string_view text, fmt::format_context& context) const {
    return fmt::formatter<std::string_view>::format({text.data(), text.size()}, context);
  }
};

namespace flair {

#define FLAIR_ERROR_OF(code)                                                     \
  template <typename... Args>                                                    \
  absl::Status code(fmt::format_string<Args...> message, Args&&... args) {       \
    return absl::code##Error(fmt::format(message, std::forward<Args>(args)...)); \
  }

FLAIR_ERROR_OF(Aborted)
FLAIR_ERROR_OF(DataLoss)
FLAIR_ERROR_OF(DeadlineExceeded)
FLAIR_ERROR_OF(FailedPrecondition)
FLAIR_ERROR_OF(Internal)
FLAIR_ERROR_OF(InvalidArgument)
FLAIR_ERROR_OF(NotFound)
FLAIR_ERROR_OF(ResourceExhausted)
FLAIR_ERROR_OF(Unavailable)
FLAIR_ERROR_OF(Unimplemented)

#undef FLAIR_ERROR_OF

}  // namespace flair
