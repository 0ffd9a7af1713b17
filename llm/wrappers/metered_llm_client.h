// SPDX-License-Identifier: GPL-3.0-or-later
// What calls consume: in metrics, and in money.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::llm {

// Counts calls by outcome, tokens and dollars, and measures how long answers take.
class MeteredLlmClient final : public LlmClientWrapper {
 public:
  MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics, const runtime::Clock& clock);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  runtime::Metrics& metrics_;
  runtime::Counter& input_tokens_;
  runtime::Counter& cached_input_tokens_;
  runtime::Counter& output_tokens_;
  runtime::Counter& cost_dollars_;
  runtime::Histogram& duration_;
  const runtime::Clock& clock_;
};

// US dollars for the tokens of one call. The price of the exact name counts, else that of the longest prefix
// ("gpt-4o*"), else nothing.
double CostUsd(const std::vector<config::v1::LlmPrice>& prices, const std::string& model, const Usage& usage);

// Writes into every answer what it cost. `model` is the configured name, used when the server's own has no price.
class PricedLlmClient final : public LlmClientWrapper {
 public:
  PricedLlmClient(std::unique_ptr<LlmClient> inner, std::vector<config::v1::LlmPrice> prices, std::string model);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  const std::vector<config::v1::LlmPrice> prices_;
  const std::string model_;
};

}  // namespace flair::llm
