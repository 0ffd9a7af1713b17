// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/config/prices.h"

namespace flair::llm {
namespace {

// How well a price's name fits: -1 not at all, else the number of characters that agree; an exact name beats any
// prefix.
int Fit(const std::string& pattern, const std::string& model) {
  if (pattern == model) return static_cast<int>(model.size()) + 1;
  if (pattern.empty() || pattern.back() != '*') return -1;
  const size_t length = pattern.size() - 1;
  return model.compare(0, length, pattern, 0, length) == 0 ? static_cast<int>(length) : -1;
}

}  // namespace

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

double CostUsd(const std::vector<config::v1::LlmPrice>& prices, const std::string& model, const Usage& usage) {
  const config::v1::LlmPrice* price = FindPrice(prices, model);
  if (price == nullptr) return 0;
  const double cached_usd = price->has_cached_input_usd() ? price->cached_input_usd() : price->input_usd();
  const auto fresh = static_cast<double>(usage.input_token_count - usage.cached_input_token_count);
  return (fresh * price->input_usd() + static_cast<double>(usage.cached_input_token_count) * cached_usd +
          static_cast<double>(usage.output_token_count) * price->output_usd()) /
         1e6;
}

}  // namespace flair::llm
