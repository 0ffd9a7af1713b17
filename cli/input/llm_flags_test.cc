// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "cli/input/job_options.h"
#include "cli/input/service_flags.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ReadLlm : public ::testing::Test {
 protected:
  ReadLlm() {
    unsetenv("FLAIR_LLM");
    setenv("FLAIR_TEST_KEY", "sk-secret", 1);
    unsetenv("FLAIR_NO_KEY");
  }
  std::string FileWith(const std::string& text) {
    std::ofstream(path_) << text;
    return path_;
  }
  static absl::StatusOr<OptionalLlm> Read(std::vector<std::string> words) {
    CLI::App app("Designs.", "design");
    const LlmFlags flags(app);
    std::reverse(words.begin(), words.end());
    app.parse(words);
    return ReadLlmFlags(flags);
  }
  // The config of flags that must be right.
  config::v1::LlmConfig Good(const std::vector<std::string>& words) {
    const auto config = Read(words);
    EXPECT_TRUE(config.ok()) << config.status();
    return config.ok() ? config->value() : config::v1::LlmConfig();
  }
  std::string ErrorOf(const std::vector<std::string>& words) {
    const auto config = Read(words);
    EXPECT_EQ(config.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(config.status().message()), Not(HasSubstr("\n")));
    return std::string(config.status().message());
  }

  const std::string path_ = fmt::format("{}/llm_{}.textproto", ::testing::TempDir(), getpid());
};

TEST_F(ReadLlm, WithoutFlagsThereIsNoModel) {
  const auto config = Read({});
  ASSERT_TRUE(config.ok());
  EXPECT_FALSE(config->has_value());
}

TEST_F(ReadLlm, TheShortFormNeedsNoFile) {
  const config::v1::LlmConfig config =
      Good({"--model", "gpt-4o", "--base-url", "https://api.openai.com/v1", "--api-key-env", "FLAIR_TEST_KEY"});
  EXPECT_EQ(config.ShortDebugString(),
            "base_url: \"https://api.openai.com/v1\" model: \"gpt-4o\" api_key_env: \"FLAIR_TEST_KEY\"");
}

TEST_F(ReadLlm, AReplayNeedsNeitherServerNorModelNorKey) {
  EXPECT_EQ(Good({"--replay", "answers"}).replay_path(), "answers");
  EXPECT_EQ(Good({"--llm", FileWith("model: \"m\" base_url: \"http://h/v1\" api_key_env: \"FLAIR_NO_KEY\""), "--replay",
                  "answers"})
                .replay_path(),
            "answers");
}

TEST_F(ReadLlm, FlagsGoBeforeTheFile) {
  const config::v1::LlmConfig config =
      Good({"--llm", FileWith("base_url: \"http://h/v1\" model: \"old\" api_key_path: \"key\" replay_path: \"r\""),
            "--model", "new", "--api-key-env", "FLAIR_TEST_KEY", "--record", "answers"});
  EXPECT_EQ(config.model(), "new");
  EXPECT_EQ(config.base_url(), "http://h/v1");
  EXPECT_EQ(config.api_key_env(), "FLAIR_TEST_KEY");
  EXPECT_EQ(config.api_key_path(), "");
  EXPECT_EQ(config.record_path(), "answers");
  EXPECT_EQ(config.replay_path(), "");
}

TEST_F(ReadLlm, TheVariableNamesTheFileUnlessAFlagDoes) {
  setenv("FLAIR_LLM", FileWith("base_url: \"http://h/v1\" model: \"of the variable\"").c_str(), 1);
  EXPECT_EQ(Good({}).model(), "of the variable");
  EXPECT_EQ(Read({"--llm", "/no/such/file"}).status().code(), absl::StatusCode::kNotFound);
}

TEST_F(ReadLlm, ErrorsNameFileLineFieldValueAndWhatIsRight) {
  const std::string path = FileWith("base_url: \"http://h/v1\"\nmodel: \"m\"\ntemperature: 3\n");
  EXPECT_EQ(ErrorOf({"--llm", path}), path + ":3: temperature: is 3; expected 0 to 2");
  FileWith("base_url: \"http://h/v1\"\nmodle: \"m\"\nstream: 7\n");
  EXPECT_THAT(ErrorOf({"--llm", path}), StartsWith(path + ":2: Message type"));
}

TEST_F(ReadLlm, ErrorsOfFlagsNameTheFlag) {
  EXPECT_THAT(ErrorOf({"--model", "gpt-4o"}), StartsWith("--base-url: missing; expected an address such as"));
  EXPECT_THAT(ErrorOf({"--model", "m", "--base-url", "localhost:80"}),
              StartsWith("--base-url: 'localhost:80' is not an address"));
  EXPECT_EQ(ErrorOf({"--model", "m", "--base-url", "http://h/v1", "--api-key-env", "FLAIR_NO_KEY"}),
            "--api-key-env: FLAIR_NO_KEY: this environment variable is not set");
  const std::string path = FileWith("model: \"m\"\n");
  EXPECT_THAT(ErrorOf({"--llm", path, "--base-url", "ftp://h"}),
              StartsWith(path + ": --base-url: 'ftp://h' is not an address"));
}

TEST_F(ReadLlm, WhatMayBeSecretIsInNoError) {
  const std::string path =
      FileWith("base_url: \"ftp://user:sk-secret@h\"\nmodel: \"m\"\nheaders { value: \"sk-secret\" }\n");
  EXPECT_THAT(ErrorOf({"--llm", path}), Not(HasSubstr("sk-secret")));
  FileWith("api_key: \"sk-secret\"\n");
  EXPECT_THAT(ErrorOf({"--llm", path}), Not(HasSubstr("sk-secret")));
}

TEST_F(ReadLlm, TheConfigsOfTheDocumentationAreRight) {
  for (const char* name : {"OPENAI_API_KEY", "GATEWAY_KEY"}) setenv(name, "sk-secret", 1);
  std::ifstream file(std::string(FLAIR_SOURCE_DIR) + "/docs/models.md");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string fence = "```textproto\n";
  int count = 0;
  for (size_t begin = text.find(fence); begin != std::string::npos; begin = text.find(fence, begin + 1)) {
    const size_t start = begin + fence.size();
    EXPECT_FALSE(Good({"--llm", FileWith(text.substr(start, text.find("```", start) - start))}).model().empty());
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST_F(ReadLlm, ALimitInDollarsWantsAPrice) {
  config::v1::LlmConfig config;
  config.set_model("gpt-4o-mini");
  v1::ModelOptions limits;
  limits.mutable_budget()->set_call_count(3);
  EXPECT_TRUE(CheckLimits(limits, config).ok());
  limits.mutable_budget()->set_cost_usd(0.5);
  const absl::Status status = CheckLimits(limits, config);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("--max-usd: 0.5: there is no price for the model \"gpt-4o-mini\""));
  config::v1::LlmPrice& price = *config.add_prices();
  price.set_model("gpt-4o*");
  price.set_output_usd(10);
  EXPECT_TRUE(CheckLimits(limits, config).ok());
}

TEST_F(ReadLlm, OptionsHoldOnlyTheLimitsThatWereGiven) {
  CLI::App app("Designs.", "design");
  const ModelFlags flags(app);
  app.parse("--max-calls 0 --max-tokens 20000 --stand-in");
  v1::JobSpec spec;
  ASSERT_TRUE(flags.Set(spec).ok());
  EXPECT_EQ(spec.ShortDebugString(),
            "model_options { budget { call_count: 0 token_count: 20000 } stand_in_allowed: true }");
}

}  // namespace
}  // namespace flair::cli
