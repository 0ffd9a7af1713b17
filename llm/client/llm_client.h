// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::llm {

// One question to a language model and its answer, whatever speaks to the model.

enum class Role { kSystem, kUser, kAssistant };

struct Message {
  Role role = Role::kUser;
  // UTF-8.
  std::string text;
};

// What is asked. Everything in it but `step` decides the answer; sampling and the model's name are the client's.
struct ChatRequest {
  // What it is for, such as "zones" or "objects.floor/repair": names the call in records, logs and meters.
  std::string step;
  std::vector<Message> messages;
  // JSON schema that the answer must follow, as compact JSON text, and its name ([a-zA-Z0-9_-]{1,64}); both empty when
  // the answer is free text.
  std::string schema;
  std::string schema_name;
  // 0 means the client's own limit.
  int max_output_token_count = 0;
  // Chooses among equally good answers, as a brief's seed does; sent where the server can repeat an answer. A client
  // that is configured with a seed sends its own.
  int64_t seed = 0;
};

// Tokens of one call.
struct Usage {
  int64_t input_token_count = 0;
  int64_t output_token_count = 0;
  // Part of the input that the server had cached.
  int64_t cached_input_token_count = 0;
  // The server did not say; counted from the lengths of the texts.
  bool estimated = false;
};

enum class FinishReason { kStop, kLength, kRefused, kOther };

struct ChatAnswer {
  // As received; with a schema it should be JSON, but a model may write anything.
  std::string text;
  FinishReason finish = FinishReason::kStop;
  Usage usage;
  // As the server named it; the configured name when it did not.
  std::string model;
  // US dollars, by the configured prices; 0 where there is none.
  double cost_usd = 0;
};

// About as many tokens as the text has: a quarter of its bytes, rounded up.
int64_t EstimateTokens(const std::string& text);

// Of all that is sent with a question.
int64_t EstimateTokens(const ChatRequest& request);

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
