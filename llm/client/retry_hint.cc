// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/client/retry_hint.h"

#include <algorithm>
#include <string>

#include "absl/strings/cord.h"
#include "absl/strings/numbers.h"

namespace flair::llm {
namespace {

constexpr char kPayload[] = "flair.llm/retry_after_ms";

}  // namespace

void SetRetryAfter(absl::Status& status, absl::Duration delay) {
  const absl::Duration kept = std::clamp(delay, absl::ZeroDuration(), absl::Hours(24));
  const std::string milliseconds = std::to_string(absl::ToInt64Milliseconds(kept));
  // Not of a std::string: clang and GCC spell that constructor differently, and the library has GCC's.
  status.SetPayload(kPayload, absl::Cord(absl::string_view(milliseconds)));
}

std::optional<absl::Duration> RetryAfter(const absl::Status& status) {
  const auto payload = status.GetPayload(kPayload);
  int64_t milliseconds = 0;
  if (!payload.has_value() || !absl::SimpleAtoi(std::string(*payload), &milliseconds)) return std::nullopt;
  return absl::Milliseconds(milliseconds);
}

}  // namespace flair::llm
