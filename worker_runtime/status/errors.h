// SPDX-License-Identifier: GPL-3.0-or-later
// Errors whose message is put together as fmt::format does it:
//   return InvalidArgument("{}: has {} bytes; at most {}", path, size, kMost);
// Messages of other statuses are arguments as they are: NotFound("{}: {}", path, status.message()).
// Header only; every folder may include it.
#pragma once

#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/string_view.h"
#include "fmt/format.h"

template <>
struct fmt::formatter<absl::string_view> : fmt::formatter<std::string_view> {
  auto format(absl::string_view text, fmt::format_context& context) const {
    return fmt::formatter<std::string_view>::format({text.data(), text.size()}, context);
  }
};

namespace flair {

// absl::StatusOr takes it as it takes an absl::Status.
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
