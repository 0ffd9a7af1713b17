// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"
#include "llm/config/check_llm_config.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::llm {

struct CallLimits {
  // At most so many calls at once.
  int in_flight = 16;
  // At most so many tokens a minute, questions and answers; 0 means any number.
  int64_t tokens_per_minute = 0;
};

// Lets calls through in the order in which they came, as the limits allow. Tokens are a bucket that holds one minute's
// worth and fills evenly: a call may begin while anything is in it, takes the estimate of its question, and settles the
// difference when the answer says what it consumed, so that the bucket can fall below 0.
class LimitingLlmClient final : public LlmClientWrapper {
 public:
  // `clock` outlives it.
  LimitingLlmClient(std::unique_ptr<LlmClient> inner, CallLimits limits, const runtime::Clock& clock);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

  // Calls that wait for their turn; for tests.
  int waiting() const;

 private:
  // OK when the call may begin.
  absl::Status WaitForTurn(int64_t estimate, runtime::CallContext& call);

  // With mutex_ held.
  void Refill();
  bool HasTokens() const { return limits_.tokens_per_minute == 0 || tokens_ > 0; }

  const CallLimits limits_;
  const runtime::Clock& clock_;

  mutable std::mutex mutex_;
  // Some call has ended or left the queue, or was cancelled.
  std::condition_variable changed_;
  // Those that wait, by number.
  std::deque<int64_t> queue_;
  int64_t next_number_ = 0;
  int in_flight_ = 0;
  double tokens_;
  absl::Duration filled_at_;
};

// What calls consume: in metrics, and in money.

// Counts calls by outcome, tokens and dollars, and measures how long answers take.
class MeteredLlmClient final : public LlmClientWrapper {
 public:
  MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics, const runtime::Clock& clock);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  runtime::Metrics& metrics_;
  runtime::Meter& input_tokens_;
  runtime::Meter& cached_input_tokens_;
  runtime::Meter& output_tokens_;
  runtime::Meter& cost_dollars_;
  runtime::Meter& duration_;
  const runtime::Clock& clock_;
};

// Writes into every answer what it cost. `model` is the configured name, used when the server's own has no price.
class PricedLlmClient final : public LlmClientWrapper {
 public:
  PricedLlmClient(std::unique_ptr<LlmClient> inner, std::vector<config::v1::LlmPrice> prices, std::string model);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  const std::vector<config::v1::LlmPrice> prices_;
  const std::string model_;
};

// When a call is made again: after UNAVAILABLE, which stands for an overloaded or unreachable server.
struct RetryPolicy {
  int attempt_limit = 5;
  // Before the second attempt; doubles from there.
  absl::Duration first_delay = absl::Milliseconds(500);
  // Most that is waited, also when the server asks for more; such an answer ends the call at once.
  absl::Duration longest_delay = absl::Seconds(60);

  // How long to wait after the failure of attempt `attempt` (1 is the first); nothing when there is no other. What the
  // server asks for counts when it is longer. Spread by up to a half of itself, upwards, by `key`: callers that failed
  // together do not come back together.
  std::optional<absl::Duration> DelayAfter(const absl::Status& failure, int attempt, const std::string& key) const;
};

// Waits so long, or until the call is cancelled.
void WaitOrCancelled(absl::Duration delay, runtime::CallContext& call);

// Asks again by a policy; between attempts it holds nothing that another call waits for. A wait that would outlast the
// call's deadline is not begun: the last failure is returned, saying how many attempts were made.
class RetryingLlmClient final : public LlmClientWrapper {
 public:
  using Wait = std::function<void(absl::Duration delay, runtime::CallContext& call)>;

  // `clock` outlives it. `wait` is another in tests.
  RetryingLlmClient(std::unique_ptr<LlmClient> inner, RetryPolicy policy, const runtime::Clock& clock,
                    Wait wait = WaitOrCancelled);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  const RetryPolicy policy_;
  const runtime::Clock& clock_;
  const Wait wait_;
};

// Clients that keep answers in folders: a cache, a recording, and a replay of a recording.

// Answers of a model in a folder, one JSON file each, found by the content of the request. The same request has one
// answer: the first that was put. Files say what was asked, so that people can read them; nothing in them is secret but
// the texts themselves. Several processes may share a folder. Thread-safe.
class AnswerFolder {
 public:
  // Uses the folder at `path`; for writing it is made when missing.
  explicit AnswerFolder(std::string path) : path_(std::move(path)) {}

  // The folder's file "identity" names the model that answered (LlmClient::identity()). FAILED_PRECONDITION when it
  // names another one: answers of two models do not mix. Writes it when there is none.
  absl::Status ClaimFor(const std::string& identity) const;
  // NOT_FOUND when the folder or its file "identity" is missing.
  absl::StatusOr<std::string> Identity() const;

  // DATA_LOSS for a file that is damaged, with its name.
  absl::StatusOr<std::optional<ChatAnswer>> Find(const ChatRequest& request) const;
  // Keeps the answer unless there is one, and returns the one that is kept.
  absl::StatusOr<ChatAnswer> Put(const ChatRequest& request, const ChatAnswer& answer) const;

  // The file of a request: "<step>-<first 16 digits of the digest of messages, schema, limit and seed>.json".
  static std::string FileName(const ChatRequest& request);

  const std::string& path() const { return path_; }

 private:
  const std::string path_;
};

// A request with its answer as JSON text, as it is kept in files, indented for people. Bytes that are not UTF-8 become
// U+FFFD.
std::string RecordJson(const ChatRequest& request, const ChatAnswer& answer);

// The answer of a record. DATA_LOSS, naming the field, for anything else.
absl::StatusOr<ChatAnswer> ReadRecordJson(const std::string& text);

// Clients that keep the answers of `inner` in a folder, or give those of one. What a folder has is not asked again.

// A cache: a folder of its own in `path` for each identity. One that cannot be read or written is as if it were empty.
std::unique_ptr<LlmClient> MakeCachingClient(std::unique_ptr<LlmClient> inner, const std::string& path);

// A recording, which MakeReplayingClient gives again. An answer that cannot be written is an error: a recording with a
// hole is none. Errors as AnswerFolder::ClaimFor.
absl::StatusOr<std::unique_ptr<LlmClient>> MakeRecordingClient(std::unique_ptr<LlmClient> inner,
                                                               const std::string& path);

// The answers of a recording, without a network; passes for the model that was recorded. What was recorded without a
// seed, or with seed 0, answers every seed. A request that the recording does not have is NOT_FOUND, naming the step
// and the file that is missing. Errors as AnswerFolder::Identity.
absl::StatusOr<std::unique_ptr<LlmClient>> MakeReplayingClient(const std::string& path);

}  // namespace flair::llm
