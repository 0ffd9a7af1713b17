// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "llm/client/llm_client.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::llm {

// Counts calls by outcome, tokens and dollars, and measures how long answers take.
class MeteredLlmClient final : public LlmClient {
 public:
  MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics, const runtime::Clock& clock);

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;
  std::string identity() const override { return inner_->identity(); }

 private:
  runtime::Metrics& metrics_;
  runtime::Counter& input_tokens_;
  runtime::Counter& cached_input_tokens_;
  runtime::Counter& output_tokens_;
  runtime::Counter& cost_dollars_;
  runtime::Histogram& duration_;
  const runtime::Clock& clock_;
  const std::unique_ptr<LlmClient> inner_;
};

}  // namespace flair::llm
