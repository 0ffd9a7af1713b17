// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/client/llm_client.h"

#include <gtest/gtest.h>

namespace flair::llm {
namespace {

TEST(RetryHint, IsWhatWasSet) {
  absl::Status status = absl::UnavailableError("HTTP 429");
  EXPECT_EQ(RetryAfter(status), std::nullopt);
  SetRetryAfter(status, absl::Milliseconds(1500));
  EXPECT_EQ(RetryAfter(status), absl::Milliseconds(1500));
  EXPECT_EQ(status.message(), "HTTP 429");
}

TEST(RetryHint, StaysBetweenZeroAndADay) {
  absl::Status status = absl::UnavailableError("");
  SetRetryAfter(status, absl::Seconds(-5));
  EXPECT_EQ(RetryAfter(status), absl::ZeroDuration());
  SetRetryAfter(status, absl::InfiniteDuration());
  EXPECT_EQ(RetryAfter(status), absl::Hours(24));
}

TEST(RetryHint, IsNeverOnSuccess) {
  absl::Status status;
  SetRetryAfter(status, absl::Seconds(1));
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(RetryAfter(status), std::nullopt);
}

}  // namespace
}  // namespace flair::llm
