// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/make_llm_client.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "fmt/format.h"
#include "llm/config/check_llm_config.h"
#include "llm/openai/openai_client.h"
#include "llm/wrappers/llm_wrappers.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

using config::v1::LlmConfig;

absl::Status Check(const LlmConfig& config) {
  std::string problems;
  CheckLlmConfig(config, [&problems](std::string_view field, std::string_view problem) {
    problems += fmt::format("{}llm.{}: {}", problems.empty() ? "" : "; ", field, problem);
  });
  return problems.empty() ? absl::OkStatus() : absl::InvalidArgumentError(problems);
}

absl::StatusOr<std::string> ReadVariable(const char* field, const std::string& name) {
  const char* value = std::getenv(name.c_str());
  if (value != nullptr && *value != '\0') return std::string(value);
  return FailedPrecondition("llm.{}: the environment variable {} is not set", field, name);
}

absl::StatusOr<std::string> ReadKey(const LlmConfig& config) {
  if (!config.api_key_env().empty()) return ReadVariable("api_key_env", config.api_key_env());
  if (config.api_key_path().empty()) return std::string();
  std::ifstream file(config.api_key_path(), std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  absl::StripAsciiWhitespace(&text);
  if (!text.empty() && text.size() <= 10000) return text;
  return FailedPrecondition("llm.api_key_path: {}: holds no key, or cannot be read", config.api_key_path());
}

absl::StatusOr<OpenAiOptions> MakeOpenAiOptions(const LlmConfig& config) {
  OpenAiOptions options{.config = config, .api_key = {}, .headers = {}};
  ASSIGN_OR_RETURN(options.api_key, ReadKey(config));
  for (const config::v1::LlmHeader& header : config.headers()) {
    std::string value = header.value();
    if (!header.value_env().empty()) {
      ASSIGN_OR_RETURN(value, ReadVariable("headers.value_env", header.value_env()));
    }
    options.headers.push_back({header.name(), std::move(value)});
  }
  return options;
}

HttpOptions MakeHttpOptions(const LlmConfig& config) {
  HttpOptions options;
  const config::v1::LlmTimeouts& timeouts = config.timeouts();
  if (timeouts.has_connect_seconds()) options.timeouts.connect = absl::Seconds(timeouts.connect_seconds());
  if (timeouts.has_first_byte_seconds()) options.timeouts.first_byte = absl::Seconds(timeouts.first_byte_seconds());
  if (timeouts.has_total_seconds()) options.timeouts.total = absl::Seconds(timeouts.total_seconds());
  options.ca_path = config.ca_path();
  options.proxy = config.proxy();
  return options;
}

RetryPolicy MakeRetryPolicy(const config::v1::LlmRetry& retry) {
  RetryPolicy policy;
  if (retry.attempt_limit() > 0) policy.attempt_limit = retry.attempt_limit();
  if (retry.has_first_delay_seconds()) policy.first_delay = absl::Seconds(retry.first_delay_seconds());
  if (retry.has_longest_delay_seconds()) policy.longest_delay = absl::Seconds(retry.longest_delay_seconds());
  return policy;
}

CallLimits MakeCallLimits(const LlmConfig& config) {
  CallLimits limits;
  if (config.in_flight_limit() > 0) limits.in_flight = config.in_flight_limit();
  limits.tokens_per_minute = config.token_per_minute_limit();
  return limits;
}

// For a model with a seed of its own: those of requests decide nothing and are in no key.
class SeedlessLlmClient final : public LlmClientWrapper {
 public:
  using LlmClientWrapper::LlmClientWrapper;

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override {
    ChatRequest seedless = request;
    seedless.seed = 0;
    return inner_->Ask(seedless, call);
  }
};

}  // namespace

absl::StatusOr<std::unique_ptr<LlmClient>> MakeLlmClient(const LlmConfig& config, runtime::WorkerContext& worker) {
  RETURN_IF_ERROR(Check(config));
  if (!config.replay_path().empty()) {
    ASSIGN_OR_RETURN(std::unique_ptr<LlmClient> replay, MakeReplayingClient(config.replay_path()));
    return std::make_unique<MeteredLlmClient>(std::move(replay), worker.metrics, worker.clock);
  }
  ASSIGN_OR_RETURN(OpenAiOptions options, MakeOpenAiOptions(config));

  // From the innermost to the outermost.
  std::unique_ptr<LlmClient> client =
      std::make_unique<OpenAiClient>(std::move(options), MakeHttpOptions(config), worker.clock);
  client = std::make_unique<LimitingLlmClient>(std::move(client), MakeCallLimits(config), worker.clock);
  client = std::make_unique<RetryingLlmClient>(std::move(client), MakeRetryPolicy(config.retry()), worker.clock);
  client = std::make_unique<PricedLlmClient>(
      std::move(client), std::vector<config::v1::LlmPrice>(config.prices().begin(), config.prices().end()),
      config.model());
  if (!config.cache_path().empty()) client = MakeCachingClient(std::move(client), config.cache_path());
  if (!config.record_path().empty()) {
    ASSIGN_OR_RETURN(client, MakeRecordingClient(std::move(client), config.record_path()));
  }
  client = std::make_unique<MeteredLlmClient>(std::move(client), worker.metrics, worker.clock);
  if (config.has_seed()) client = std::make_unique<SeedlessLlmClient>(std::move(client));
  return client;
}

}  // namespace flair::llm
