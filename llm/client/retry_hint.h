// SPDX-License-Identifier: GPL-3.0-or-later
// What a server said about asking again, carried inside the error.
#pragma once

#include <optional>

#include "absl/status/status.h"
#include "absl/time/time.h"

namespace flair::llm {

// Notes in an error that the server wants no new attempt before `delay` has passed (Retry-After); negative counts as 0,
// at most a day. Does nothing to OK.
void SetRetryAfter(absl::Status& status, absl::Duration delay);

// The delay that was noted, if any.
std::optional<absl::Duration> RetryAfter(const absl::Status& status);

}  // namespace flair::llm
