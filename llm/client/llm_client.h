// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "llm/client/chat.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::llm {

// A language model, or a wrapper around one (retrying, metering, recording ...). Thread-safe.
//
// Errors: UNAVAILABLE when the model cannot be reached or is overloaded, after all attempts; DEADLINE_EXCEEDED and
// CANCELLED as the call's; INVALID_ARGUMENT when the server does not accept the request; UNAUTHENTICATED and
// PERMISSION_DENIED when it does not accept the key; NOT_FOUND for an unknown model or address, or an answer that a
// replay does not have; FAILED_PRECONDITION when a budget is spent (waiting would not help); DATA_LOSS when the reply
// is not what the protocol says. No message holds a key or a prompt.
class LlmClient {
 public:
  virtual ~LlmClient() = default;

  // Asks and waits for the answer. Cancelling `call`, or its deadline, ends the request within a second and closes its
  // connection.
  virtual absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) = 0;

  // Names what decides the answers beyond the request: model, address, sampling. Never secret. Goes into the keys under
  // which results are used again.
  virtual std::string identity() const = 0;

  // How many calls gain from being made at the same time; 1 for those that answer at once, such as a replay.
  virtual int concurrency() const { return 1; }
};

// What wrappers have in common: unless they say otherwise they pass for the client that they wrap.
class LlmClientWrapper : public LlmClient {
 public:
  explicit LlmClientWrapper(std::unique_ptr<LlmClient> inner) : inner_(std::move(inner)) {}
  std::string identity() const override { return inner_->identity(); }
  int concurrency() const override { return inner_->concurrency(); }

 protected:
  const std::unique_ptr<LlmClient> inner_;
};

// Asks all, as many at once as the client gains from, and waits for all; answers in the order of the requests.
std::vector<absl::StatusOr<ChatAnswer>> AskAll(LlmClient& client, std::span<const ChatRequest> requests,
                                               runtime::CallContext& call);

// Notes in an error that the server wants no new attempt before `delay` has passed (Retry-After); negative counts as 0,
// at most a day. Does nothing to OK.
void SetRetryAfter(absl::Status& status, absl::Duration delay);

// The delay that was noted, if any.
std::optional<absl::Duration> RetryAfter(const absl::Status& status);

}  // namespace flair::llm
