// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "llm/client/chat.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::llm {

using AnswerCallback = std::function<void(absl::StatusOr<ChatAnswer>)>;

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

  // Asks and returns at once. `done` is called exactly once, from any thread, also from within this call; it must not
  // block. `call` lives until then; cancelling it, or its deadline, ends the request and closes its connection.
  virtual void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) = 0;

  // Names what decides the answers beyond the request: model, address, sampling. Never secret. Goes into the keys under
  // which results are used again.
  virtual std::string identity() const = 0;
};

// Asks and waits.
absl::StatusOr<ChatAnswer> AskAndWait(LlmClient& client, const ChatRequest& request, runtime::CallContext& call);

// Asks all at once and waits for all; answers in the order of the requests.
std::vector<absl::StatusOr<ChatAnswer>> AskAllAndWait(LlmClient& client, std::span<const ChatRequest> requests,
                                                      runtime::CallContext& call);

}  // namespace flair::llm
