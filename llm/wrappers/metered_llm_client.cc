// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/metered_llm_client.h"

#include <utility>

namespace flair::llm {
namespace {

using runtime::MetricFamily;
using runtime::MetricKind;

constexpr MetricFamily kCalls{.kind = MetricKind::kCounter,
                              .name = "flair_llm_calls_total",
                              .help = "Questions to the language model, by the status code of the outcome.",
                              .labels = {"code"}};
constexpr MetricFamily kTokens{.kind = MetricKind::kCounter,
                               .name = "flair_llm_tokens_total",
                               .help = "Tokens of answered questions: input, cached_input (a part of it), output.",
                               .labels = {"direction"}};
constexpr MetricFamily kCost{.kind = MetricKind::kCounter,
                             .name = "flair_llm_cost_dollars_total",
                             .help = "US dollars for answered questions, by the configured prices."};
constexpr MetricFamily kDuration{.kind = MetricKind::kHistogram,
                                 .name = "flair_llm_call_duration_seconds",
                                 .help = "Time from a question to its answer, with waiting and repeats.",
                                 .buckets = runtime::kSecondsBuckets};

// How well a price's name fits: -1 not at all, else the number of characters that agree; an exact name beats any
// prefix.
int Fit(const std::string& pattern, const std::string& model) {
  if (pattern == model) return static_cast<int>(model.size()) + 1;
  if (pattern.empty() || pattern.back() != '*') return -1;
  const size_t length = pattern.size() - 1;
  return model.compare(0, length, pattern, 0, length) == 0 ? static_cast<int>(length) : -1;
}

const config::v1::LlmPrice* FindPrice(const std::vector<config::v1::LlmPrice>& prices, const std::string& model) {
  const config::v1::LlmPrice* best = nullptr;
  int best_fit = -1;
  for (const config::v1::LlmPrice& price : prices) {
    const int fit = Fit(price.model(), model);
    if (fit <= best_fit) continue;
    best_fit = fit;
    best = &price;
  }
  return best;
}

}  // namespace

MeteredLlmClient::MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics,
                                   const runtime::Clock& clock)
    : LlmClientWrapper(std::move(inner)),
      metrics_(metrics),
      input_tokens_(metrics.GetCounter(kTokens, {"input"})),
      cached_input_tokens_(metrics.GetCounter(kTokens, {"cached_input"})),
      output_tokens_(metrics.GetCounter(kTokens, {"output"})),
      cost_dollars_(metrics.GetCounter(kCost)),
      duration_(metrics.GetHistogram(kDuration)),
      clock_(clock) {
  metrics.Declare(kCalls);
}

absl::StatusOr<ChatAnswer> MeteredLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  const absl::Duration start = clock_.Elapsed();
  absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, call);
  metrics_.GetCounter(kCalls, {absl::StatusCodeToString(answer.status().code())}).Add();
  duration_.Observe(absl::ToDoubleSeconds(clock_.Elapsed() - start));
  if (answer.ok()) {
    input_tokens_.Add(static_cast<double>(answer->usage.input_token_count));
    cached_input_tokens_.Add(static_cast<double>(answer->usage.cached_input_token_count));
    output_tokens_.Add(static_cast<double>(answer->usage.output_token_count));
    cost_dollars_.Add(answer->cost_usd);
  }
  return answer;
}

double CostUsd(const std::vector<config::v1::LlmPrice>& prices, const std::string& model, const Usage& usage) {
  const config::v1::LlmPrice* price = FindPrice(prices, model);
  if (price == nullptr) return 0;
  const double cached_usd = price->has_cached_input_usd() ? price->cached_input_usd() : price->input_usd();
  const auto fresh = static_cast<double>(usage.input_token_count - usage.cached_input_token_count);
  return (fresh * price->input_usd() + static_cast<double>(usage.cached_input_token_count) * cached_usd +
          static_cast<double>(usage.output_token_count) * price->output_usd()) /
         1e6;
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

}  // namespace flair::llm
