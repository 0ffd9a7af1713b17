// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <utility>

#include "fmt/format.h"
#include "llm/wrappers/llm_wrappers.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

// Deadlines and tokens are looked at so often; the end of a call and a cancellation wake at once.
constexpr std::chrono::milliseconds kLookAgain(50);

using runtime::MetricFamily;

constexpr MetricFamily kCalls =
    runtime::CounterFamily("flair_llm_calls_total", "Questions to the language model, by status code.", {"code"});
constexpr MetricFamily kTokens =
    runtime::CounterFamily("flair_llm_tokens_total",
                           "Tokens of answered questions: input, cached_input (part of input), output.", {"direction"});
constexpr MetricFamily kCost = runtime::CounterFamily("flair_llm_cost_dollars_total",
                                                      "US dollars for answered questions, by the configured prices.");
constexpr MetricFamily kDuration =
    runtime::HistogramFamily("flair_llm_call_duration_seconds",
                             "Time from a question to its answer, with waiting and retries.", runtime::kSecondsBuckets);

// In [0, 1), decided by the text alone.
double Spread(const std::string& text) {
  const std::string digest = runtime::Sha256Hex(text);
  return static_cast<double>(std::stoull(digest.substr(0, 12), nullptr, 16)) / static_cast<double>(1ULL << 48);
}

absl::Status AfterAttempts(const absl::Status& failure, int attempts) {
  if (attempts == 1) return failure;
  return absl::Status(failure.code(), fmt::format("{} (after {} attempts)", std::string(failure.message()), attempts));
}

}  // namespace

LimitingLlmClient::LimitingLlmClient(std::unique_ptr<LlmClient> inner, CallLimits limits, const runtime::Clock& clock)
    : LlmClientWrapper(std::move(inner)),
      limits_(limits),
      clock_(clock),
      tokens_(static_cast<double>(limits.tokens_per_minute)),
      filled_at_(clock.Elapsed()) {}

absl::StatusOr<ChatAnswer> LimitingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  const int64_t estimate = EstimateTokens(request);
  RETURN_IF_ERROR(WaitForTurn(estimate, call));
  absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, call);
  const std::lock_guard lock(mutex_);
  --in_flight_;
  if (answer.ok()) {
    const int64_t consumed = answer->usage.input_token_count + answer->usage.output_token_count;
    tokens_ -= static_cast<double>(consumed - estimate);
  }
  changed_.notify_all();
  return answer;
}

absl::Status LimitingLlmClient::WaitForTurn(int64_t estimate, runtime::CallContext& call) {
  const runtime::OnCancel wake_up(call.cancellation(), [this] {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  });
  std::unique_lock lock(mutex_);
  const int64_t number = next_number_++;
  queue_.push_back(number);
  absl::Status status;
  while (true) {
    status = call.CheckAlive();
    Refill();
    const bool may_begin = queue_.front() == number && in_flight_ < limits_.in_flight && HasTokens();
    if (!status.ok() || may_begin) break;
    changed_.wait_for(lock, kLookAgain);
  }
  std::erase(queue_, number);
  // The next may have its turn too.
  changed_.notify_all();
  RETURN_IF_ERROR(status);
  ++in_flight_;
  tokens_ -= static_cast<double>(estimate);
  return absl::OkStatus();
}

int LimitingLlmClient::waiting() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(queue_.size());
}

void LimitingLlmClient::Refill() {
  const absl::Duration now = clock_.Elapsed();
  const auto rate = static_cast<double>(limits_.tokens_per_minute);
  tokens_ = std::min(rate, tokens_ + rate * absl::ToDoubleSeconds(now - filled_at_) / 60);
  filled_at_ = now;
}

MeteredLlmClient::MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics,
                                   const runtime::Clock& clock)
    : LlmClientWrapper(std::move(inner)),
      metrics_(metrics),
      input_tokens_(metrics.Get(kTokens, {"input"})),
      cached_input_tokens_(metrics.Get(kTokens, {"cached_input"})),
      output_tokens_(metrics.Get(kTokens, {"output"})),
      cost_dollars_(metrics.Get(kCost)),
      duration_(metrics.Get(kDuration)),
      clock_(clock) {
  metrics.Declare(kCalls);
}

absl::StatusOr<ChatAnswer> MeteredLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  const absl::Duration start = clock_.Elapsed();
  absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, call);
  metrics_.Get(kCalls, {absl::StatusCodeToString(answer.status().code())}).Add();
  duration_.Add(absl::ToDoubleSeconds(clock_.Elapsed() - start));
  if (answer.ok()) {
    input_tokens_.Add(static_cast<double>(answer->usage.input_token_count));
    cached_input_tokens_.Add(static_cast<double>(answer->usage.cached_input_token_count));
    output_tokens_.Add(static_cast<double>(answer->usage.output_token_count));
    cost_dollars_.Add(answer->cost_usd);
  }
  return answer;
}

PricedLlmClient::PricedLlmClient(std::unique_ptr<LlmClient> inner, std::vector<config::v1::LlmPrice> prices,
                                 std::string model)
    : LlmClientWrapper(std::move(inner)), prices_(std::move(prices)), model_(std::move(model)) {}

absl::StatusOr<ChatAnswer> PricedLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, call);
  if (answer.ok()) {
    const std::string& name = FindPrice(prices_, answer->model) != nullptr ? answer->model : model_;
    answer->cost_usd = CostUsd(prices_, name, answer->usage);
  }
  return answer;
}

std::optional<absl::Duration> RetryPolicy::DelayAfter(const absl::Status& failure, int attempt,
                                                      const std::string& key) const {
  if (!absl::IsUnavailable(failure) || attempt >= attempt_limit) return std::nullopt;
  const std::optional<absl::Duration> asked = RetryAfter(failure);
  if (asked.has_value() && *asked > longest_delay) return std::nullopt;
  absl::Duration own = first_delay;
  for (int i = 1; i < attempt && own < longest_delay; ++i) own *= 2;
  const double spread = 1 + 0.5 * Spread(fmt::format("{}#{}", key, attempt));
  return std::max(asked.value_or(absl::ZeroDuration()), std::min(own, longest_delay)) * spread;
}

void WaitOrCancelled(absl::Duration delay, runtime::CallContext& call) {
  std::mutex mutex;
  std::condition_variable wake;
  const runtime::OnCancel on_cancel(call.cancellation(), [&] {
    const std::lock_guard lock(mutex);
    wake.notify_all();
  });
  std::unique_lock lock(mutex);
  wake.wait_for(lock, absl::ToChronoMilliseconds(delay), [&] { return call.cancellation().cancelled(); });
}

RetryingLlmClient::RetryingLlmClient(std::unique_ptr<LlmClient> inner, RetryPolicy policy, const runtime::Clock& clock,
                                     Wait wait)
    : LlmClientWrapper(std::move(inner)), policy_(policy), clock_(clock), wait_(std::move(wait)) {}

absl::StatusOr<ChatAnswer> RetryingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  // Unless the server itself asks for more, further attempts end within half the caller's time, which is more than the
  // first one takes (HttpTimeouts); one that hung may hang as long again.
  const absl::Time half = clock_.Now() + (call.deadline() - clock_.Now()) / 2;
  absl::Time end = call.deadline();
  absl::Status failure;
  for (int attempt = 1;; ++attempt) {
    const absl::Time begin = clock_.Now();
    runtime::CallContext within(call.request_id(), end, clock_);
    const runtime::OnCancel cancel(call.cancellation(), [&within] { within.cancellation().Cancel(); });
    absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, within);
    if (answer.ok()) return answer;
    // Such as one that waited for its turn: what failed before says more.
    if (absl::IsDeadlineExceeded(answer.status()) && attempt > 1) return AfterAttempts(failure, attempt - 1);
    failure = answer.status();
    const std::optional<absl::Duration> delay =
        policy_.DelayAfter(failure, attempt, call.request_id() + "/" + request.step);
    end = RetryAfter(failure).has_value() ? call.deadline() : half;
    if (!delay.has_value() || clock_.Now() + *delay + (clock_.Now() - begin) >= end) {
      return AfterAttempts(failure, attempt);
    }
    wait_(*delay, call);
    RETURN_IF_ERROR(call.CheckAlive());
  }
}

}  // namespace flair::llm
