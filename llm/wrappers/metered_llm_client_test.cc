// SPDX-License-Identifier: GPL-3.0-or-later
#include "gtest/gtest.h"
#include "llm/testing/test_llm_client.h"
#include "llm/wrappers/llm_wrappers.h"

namespace flair::llm {
namespace {

config::v1::LlmPrice Price(const std::string& model, double input_usd, double output_usd) {
  config::v1::LlmPrice price;
  price.set_model(model);
  price.set_input_usd(input_usd);
  price.set_output_usd(output_usd);
  return price;
}

Usage Tokens(int64_t input, int64_t output, int64_t cached = 0) { return {input, output, cached, false}; }

TEST(CostUsd, IsPerMillionTokens) {
  EXPECT_DOUBLE_EQ(CostUsd({Price("m", 2.5, 10)}, "m", Tokens(1'000'000, 100'000)), 3.5);
}

TEST(CostUsd, CachedTokensHaveTheirOwnPriceWhereThereIsOne) {
  config::v1::LlmPrice price = Price("m", 2, 10);
  EXPECT_DOUBLE_EQ(CostUsd({price}, "m", Tokens(1'000'000, 0, 500'000)), 2);
  price.set_cached_input_usd(1);
  EXPECT_DOUBLE_EQ(CostUsd({price}, "m", Tokens(1'000'000, 0, 500'000)), 1.5);
}

TEST(CostUsd, TheExactNameCountsBeforeTheLongestPrefixBeforeAShorter) {
  const std::vector<config::v1::LlmPrice> prices = {Price("*", 1, 0), Price("gpt-4o*", 2, 0), Price("gpt-4o", 3, 0),
                                                    Price("gpt-*", 4, 0)};
  EXPECT_DOUBLE_EQ(CostUsd(prices, "gpt-4o", Tokens(1'000'000, 0)), 3);
  EXPECT_DOUBLE_EQ(CostUsd(prices, "gpt-4o-mini", Tokens(1'000'000, 0)), 2);
  EXPECT_DOUBLE_EQ(CostUsd(prices, "gpt-5", Tokens(1'000'000, 0)), 4);
  EXPECT_DOUBLE_EQ(CostUsd(prices, "llama", Tokens(1'000'000, 0)), 1);
  EXPECT_DOUBLE_EQ(CostUsd({Price("gpt-4o", 3, 0)}, "llama", Tokens(1'000'000, 0)), 0);
}

TEST(PricedLlmClient, PricesByTheServersNameAndElseByTheConfiguredOne) {
  auto* model = new TestLlmClient();
  model->answer = [](size_t) {
    ChatAnswer answer;
    answer.model = "/models/some.gguf";
    answer.usage = Tokens(2'000'000, 0);
    return answer;
  };
  PricedLlmClient client(std::unique_ptr<LlmClient>(model), {Price("mine", 1, 0)}, "mine");
  runtime::CallContext call;
  EXPECT_DOUBLE_EQ(client.Ask(AskFor("a"), call)->cost_usd, 2);
}

}  // namespace
}  // namespace flair::llm
