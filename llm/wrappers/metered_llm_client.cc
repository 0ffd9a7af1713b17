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

}  // namespace

MeteredLlmClient::MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics,
                                   const runtime::Clock& clock)
    : metrics_(metrics),
      input_tokens_(metrics.GetCounter(kTokens, {"input"})),
      cached_input_tokens_(metrics.GetCounter(kTokens, {"cached_input"})),
      output_tokens_(metrics.GetCounter(kTokens, {"output"})),
      cost_dollars_(metrics.GetCounter(kCost)),
      duration_(metrics.GetHistogram(kDuration)),
      clock_(clock),
      inner_(std::move(inner)) {
  metrics.Declare(kCalls);
}

void MeteredLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  const absl::Duration start = clock_.Elapsed();
  inner_->Ask(request, call, [this, start, done = std::move(done)](absl::StatusOr<ChatAnswer> answer) {
    metrics_.GetCounter(kCalls, {absl::StatusCodeToString(answer.status().code())}).Add();
    duration_.Observe(absl::ToDoubleSeconds(clock_.Elapsed() - start));
    if (answer.ok()) {
      input_tokens_.Add(static_cast<double>(answer->usage.input_token_count));
      cached_input_tokens_.Add(static_cast<double>(answer->usage.cached_input_token_count));
      output_tokens_.Add(static_cast<double>(answer->usage.output_token_count));
      cost_dollars_.Add(answer->cost_usd);
    }
    done(std::move(answer));
  });
}

}  // namespace flair::llm
