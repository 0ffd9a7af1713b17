// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage_clients.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "absl/strings/cord.h"
#include "orchestrator/pipeline/stage.h"

namespace flair::orchestrator {
namespace {

// FNV-1a, to [0, 1).
double Fraction(const std::string& key, int attempt) {
  uint64_t hash = 14695981039346656037u + static_cast<uint64_t>(attempt);
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

constexpr char kStorePayload[] = "flair/of-store";
constexpr char kOutagePayload[] = "flair/outage";

bool IsOfStore(const absl::Status& status) { return status.GetPayload(kStorePayload).has_value(); }

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

absl::Status OfStore(absl::Status status) {
  // A lost lease is no fault of the store.
  if (!status.ok() && !absl::IsAborted(status)) status.SetPayload(kStorePayload, absl::Cord());
  return absl::IsUnavailable(status) ? OfOutage(std::move(status)) : status;
}

absl::Status OfOutage(absl::Status status) {
  status.SetPayload(kOutagePayload, absl::Cord());
  return status;
}

bool IsOutage(const absl::Status& status) { return status.GetPayload(kOutagePayload).has_value(); }

v1::FailureKind KindOfFailure(const absl::Status& failure, std::string_view stage) {
  if (IsOfStore(failure)) return v1::FAILURE_KIND_STORE;
  switch (failure.code()) {
    case absl::StatusCode::kDeadlineExceeded:
      return v1::FAILURE_KIND_TIMEOUT;
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kResourceExhausted:
    case absl::StatusCode::kInternal:
    case absl::StatusCode::kUnknown:
    case absl::StatusCode::kDataLoss:
    case absl::StatusCode::kUnimplemented:
    case absl::StatusCode::kUnauthenticated:
    case absl::StatusCode::kPermissionDenied:
      return v1::FAILURE_KIND_WORKER;
    default:
      break;
  }
  const int index = StageIndex(stage);
  if (index < 0 || index == 0) return v1::FAILURE_KIND_INPUT;
  if (index < StageIndex("translation")) {
    return absl::IsInvalidArgument(failure) ? v1::FAILURE_KIND_INPUT : v1::FAILURE_KIND_LANGUAGE;
  }
  if (stage == "translation") return v1::FAILURE_KIND_TRANSLATION;
  if (stage == "solve") return v1::FAILURE_KIND_INFEASIBLE;
  return absl::IsInvalidArgument(failure) ? v1::FAILURE_KIND_INPUT : v1::FAILURE_KIND_WORKER;
}

bool MayPass(const absl::Status& failure, v1::FailureKind kind) {
  switch (kind) {
    case v1::FAILURE_KIND_WORKER:
      return failure.code() != absl::StatusCode::kUnimplemented &&
             failure.code() != absl::StatusCode::kUnauthenticated &&
             failure.code() != absl::StatusCode::kPermissionDenied;
    case v1::FAILURE_KIND_TIMEOUT:
    case v1::FAILURE_KIND_STORE:
      return true;
    // A model that could not be reached; see decision 14.
    case v1::FAILURE_KIND_LANGUAGE:
    case v1::FAILURE_KIND_TRANSLATION:
      return absl::IsAborted(failure);
    default:
      return false;
  }
}

absl::Duration DelayAfterFailure(int failure_count, const std::string& key) {
  BackoffPolicy policy;
  policy.unavailable_attempt_limit = failure_count + 2;
  policy.first_delay = absl::Seconds(1);
  policy.growth = 4.0;
  policy.longest_delay = absl::Minutes(1);
  return policy.DelayAfter(absl::UnavailableError(""), failure_count, key).value_or(policy.longest_delay);
}

}  // namespace flair::orchestrator
