// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"

namespace flair::llm {

// US dollars for the tokens of one call. The price of the exact name counts, else that of the longest prefix
// ("gpt-4o*"), else nothing.
double CostUsd(const std::vector<config::v1::LlmPrice>& prices, const std::string& model, const Usage& usage);

// Writes into every answer what it cost. `model` is the configured name, used when the server's own has no price.
class PricedLlmClient final : public LlmClient {
 public:
  PricedLlmClient(std::unique_ptr<LlmClient> inner, std::vector<config::v1::LlmPrice> prices, std::string model);

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;
  std::string identity() const override { return inner_->identity(); }

 private:
  const std::vector<config::v1::LlmPrice> prices_;
  const std::string model_;
  // Last, so that it ends first: its callbacks use the rest.
  const std::unique_ptr<LlmClient> inner_;
};

}  // namespace flair::llm
