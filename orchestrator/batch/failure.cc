// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/failure.h"

#include "absl/strings/cord.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {
namespace {
constexpr char kStorePayload[] = "flair/of-store";
}  // namespace

absl::Status OfStore(absl::Status status) {
  // A lost lease is no fault of the store.
  if (!status.ok() && !absl::IsAborted(status)) status.SetPayload(kStorePayload, absl::Cord());
  return status;
}

bool IsOfStore(const absl::Status& status) { return status.GetPayload(kStorePayload).has_value(); }

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
