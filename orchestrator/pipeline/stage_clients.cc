// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage_clients.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace flair::orchestrator {
namespace {

// FNV-1a, to [0, 1).
double Fraction(const std::string& key, int attempt) {
  uint64_t hash = 14695981039346656037u + static_cast<uint64_t>(attempt);
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

}  // namespace

bool IsMessageTooLarge(const absl::Status& status) {
  return absl::IsResourceExhausted(status) &&
         std::string(status.message()).find("message larger than max") != std::string::npos;
}

std::optional<absl::Duration> BackoffPolicy::DelayAfter(const absl::Status& failure, int attempt,
                                                        const std::string& key) const {
  const bool down = failure.code() == absl::StatusCode::kUnavailable;
  const bool full = absl::IsResourceExhausted(failure) && !IsMessageTooLarge(failure);
  if (!down && !full) return std::nullopt;
  if (down && attempt + 1 >= unavailable_attempt_limit) return std::nullopt;
  const absl::Duration grown = first_delay * std::pow(growth, std::min(attempt, 30));
  return std::min(grown, longest_delay) * (1.0 - 0.5 * Fraction(key, attempt));
}

void WaitUnlessCancelled(absl::Duration duration, runtime::CallContext& call) {
  std::mutex mutex;
  std::condition_variable wake;
  bool cancelled = false;
  runtime::OnCancel guard(call.cancellation(), [&] {
    std::lock_guard lock(mutex);
    cancelled = true;
    wake.notify_all();
  });
  std::unique_lock lock(mutex);
  wake.wait_for(lock, absl::ToChronoMicroseconds(duration), [&] { return cancelled; });
}

}  // namespace flair::orchestrator
