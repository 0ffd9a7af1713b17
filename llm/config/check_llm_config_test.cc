// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/config/check_llm_config.h"

#include <string>

#include "gmock/gmock.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"

namespace flair::llm {
namespace {

using ::testing::HasSubstr;

std::string Problems(const std::string& text) {
  config::v1::LlmConfig config;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &config)) << text;
  std::string problems;
  CheckLlmConfig(config, [&problems](std::string_view field, std::string_view problem) {
    problems += std::string(field) + ": " + std::string(problem) + "\n";
  });
  return problems;
}

const char kGood[] = R"(base_url: "https://api.openai.com/v1" model: "gpt-4o" )";

TEST(CheckLlmConfig, TakesWhatIsRight) {
  EXPECT_EQ(Problems(kGood), "");
  EXPECT_EQ(Problems(R"(replay_path: "recorded")"), "");
  EXPECT_EQ(Problems(std::string(kGood) + R"(
      api_key_env: "KEY" azure { deployment: "d" api_version: "2024-10-21" } headers { name: "X-Team" value: "rooms" }
      temperature: 0 max_output_token_count: 8000 timeouts { connect_seconds: 0.5 first_byte_seconds: 60 total_seconds: 3600 }
      retry { attempt_limit: 1 first_delay_seconds: 0.1 longest_delay_seconds: 600 } in_flight_limit: 500
      token_per_minute_limit: 200000 prices { model: "gpt-4o*" input_usd: 2.5 cached_input_usd: 1.25 output_usd: 10 })"),
            "");
}

TEST(CheckLlmConfig, NamesEveryFieldThatIsWrongWithItsValue) {
  struct Case {
    const char* text;
    const char* expected;
  };
  const Case cases[] = {
      {"temperature: 2.1", "temperature: is 2.1; expected 0 to 2"},
      {"temperature: nan", "temperature: is nan"},
      {"max_output_token_count: -1", "max_output_token_count: is -1"},
      {"answer_form: 77", "answer_form"},
      {"timeouts { connect_seconds: 0 }", "timeouts.connect_seconds: is 0; expected more than 0"},
      {"timeouts { first_byte_seconds: inf }", "timeouts.first_byte_seconds: is inf"},
      {"timeouts { total_seconds: 3601 }", "timeouts.total_seconds: is 3601"},
      {"retry { attempt_limit: 21 }", "retry.attempt_limit: is 21; expected 1 to 20"},
      {"retry { first_delay_seconds: 61 }", "retry.first_delay_seconds"},
      {"retry { longest_delay_seconds: -1 }", "retry.longest_delay_seconds"},
      {"in_flight_limit: 10001", "in_flight_limit: is 10001; expected 1 to 10000"},
      {"token_per_minute_limit: -5", "token_per_minute_limit: is -5"},
      {"prices { input_usd: 1 }", "prices[0].model: missing"},
      {"prices { model: 'm' output_usd: -1 }", "prices[0].output_usd: is -1"},
      {"api_key_env: 'A' api_key_path: 'b'", "api_key_path: set as well as api_key_env"},
      {"azure { }", "azure.deployment: missing"},
      {"azure { deployment: 'd' }", "azure.api_version: missing"},
      {"headers { value: 'x' }", "headers[0].name: missing"},
      {"headers { name: 'X-Team:' value: 'x' }", "headers[0]: header 'X-Team:': not a name"},
      {"headers { name: 'X-Team' value: 'a\\nb' }", "headers[0]: header 'X-Team': its value holds a line break"},
      {"headers { name: 'x' }", "headers[0]: expected either value or value_env"},
      {"headers { name: 'x' value: 'a' value_env: 'b' }", "headers[0]: expected either value or value_env"},
      {"replay_path: 'a' record_path: 'b'", "record_path: set as well as replay_path"}};
  for (const Case& one : cases) {
    EXPECT_THAT(Problems(std::string(kGood) + one.text), HasSubstr(one.expected)) << one.text;
  }
  EXPECT_THAT(Problems("model: 'm'"), HasSubstr("base_url: missing"));
  EXPECT_THAT(Problems("model: 'm' base_url: 'ftp://x'"), HasSubstr("base_url: "));
  EXPECT_THAT(Problems("base_url: 'http://x/v1'"), HasSubstr("model: missing"));
}

TEST(CheckLlmConfig, ShowsNoSecretThatIsPartOfAnAddress) {
  EXPECT_EQ(Problems("model: 'm' base_url: 'ftp://user:hunter2@x'").find("hunter2"), std::string::npos);
}

}  // namespace
}  // namespace flair::llm
