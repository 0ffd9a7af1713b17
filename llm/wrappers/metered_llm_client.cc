// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/metered_llm_client.h"

#include <utility>

namespace flair::llm {

MeteredLlmClient::MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics,
                                   const runtime::Clock& clock)
    : metrics_(metrics), clock_(clock), inner_(std::move(inner)) {}

void MeteredLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  const absl::Duration start = clock_.Elapsed();
  inner_->Ask(request, call, [this, start, done = std::move(done)](absl::StatusOr<ChatAnswer> answer) {
    metrics_.Count("llm_calls", absl::StatusCodeToString(answer.status().code()), 1);
    metrics_.Observe("llm_call_duration_seconds", "", absl::ToDoubleSeconds(clock_.Elapsed() - start));
    if (answer.ok()) {
      metrics_.Count("llm_tokens", "input", static_cast<double>(answer->usage.input_token_count));
      metrics_.Count("llm_tokens", "output", static_cast<double>(answer->usage.output_token_count));
      metrics_.Count("llm_cost_usd", "", answer->cost_usd);
    }
    done(std::move(answer));
  });
}

}  // namespace flair::llm
