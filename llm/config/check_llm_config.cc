// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/config/check_llm_config.h"

#include "fmt/format.h"
#include "llm/http/http_client.h"

namespace flair::llm {
namespace {

class Checker {
 public:
  explicit Checker(const ConfigReport& report) : report_(report) {}

  void Report(std::string_view field, std::string_view problem) { report_(field, problem); }
  // 0 stands for the default.
  void Count(std::string_view field, double value, double high) {
    if (value < 0 || value > high)
      report_(field, fmt::format("is {}; expected 1 to {}, or 0 for the default", value, high));
  }
  // (0, high].
  void Seconds(std::string_view field, double value, double high) {
    if (!(value > 0 && value <= high))
      report_(field, fmt::format("is {}; expected more than 0 and at most {}", value, high));
  }
  void Price(const std::string& field, double value) {
    if (!(value >= 0 && value <= 1e6)) report_(field, fmt::format("is {}; expected 0 to 1000000", value));
  }

 private:
  const ConfigReport& report_;
};

void CheckServer(const config::v1::LlmConfig& config, Checker& checker) {
  HttpRequest request;
  request.url = config.base_url();
  if (config.base_url().empty()) {
    checker.Report("base_url", "missing; expected an address such as \"https://api.openai.com/v1\", or replay_path");
  } else if (const absl::Status status = CheckRequest(request); !status.ok()) {
    checker.Report("base_url", std::string(status.message()));
  }
  if (config.model().empty()) checker.Report("model", "missing; expected the model's name");
  if (!config.api_key_env().empty() && !config.api_key_path().empty()) {
    checker.Report("api_key_path", "set as well as api_key_env; expected one of them");
  }
  if (config.has_azure()) {
    if (config.azure().deployment().empty()) checker.Report("azure.deployment", "missing; expected its name");
    if (config.azure().api_version().empty()) {
      checker.Report("azure.api_version", "missing; expected a version such as \"2024-10-21\"");
    }
  }
  for (int i = 0; i < config.headers_size(); ++i) {
    const config::v1::LlmHeader& header = config.headers(i);
    const std::string field = fmt::format("headers[{}]", i);
    if (header.name().empty()) {
      checker.Report(field + ".name", "missing");
    } else if (const absl::Status status = CheckHeader({header.name(), header.value()}); !status.ok()) {
      checker.Report(field, std::string(status.message()));
    }
    if (header.value().empty() == header.value_env().empty()) {
      checker.Report(field, "expected either value or value_env");
    }
  }
}

void CheckSampling(const config::v1::LlmConfig& config, Checker& checker) {
  if (config.has_temperature() && !(config.temperature() >= 0 && config.temperature() <= 2)) {
    checker.Report("temperature", fmt::format("is {}; expected 0 to 2", config.temperature()));
  }
  checker.Count("max_output_token_count", config.max_output_token_count(), 1e6);
  if (!config::v1::AnswerForm_IsValid(config.answer_form())) {
    checker.Report("answer_form", fmt::format("is {}; expected a known form", static_cast<int>(config.answer_form())));
  }
}

void CheckPatience(const config::v1::LlmConfig& config, Checker& checker) {
  const config::v1::LlmTimeouts& timeouts = config.timeouts();
  if (timeouts.has_connect_seconds()) checker.Seconds("timeouts.connect_seconds", timeouts.connect_seconds(), 3600);
  if (timeouts.has_first_byte_seconds()) {
    checker.Seconds("timeouts.first_byte_seconds", timeouts.first_byte_seconds(), 3600);
  }
  if (timeouts.has_total_seconds()) checker.Seconds("timeouts.total_seconds", timeouts.total_seconds(), 3600);
  const config::v1::LlmRetry& retry = config.retry();
  checker.Count("retry.attempt_limit", retry.attempt_limit(), 20);
  if (retry.has_first_delay_seconds()) checker.Seconds("retry.first_delay_seconds", retry.first_delay_seconds(), 60);
  if (retry.has_longest_delay_seconds()) {
    checker.Seconds("retry.longest_delay_seconds", retry.longest_delay_seconds(), 600);
  }
  checker.Count("in_flight_limit", config.in_flight_limit(), 10000);
  checker.Count("token_per_minute_limit", static_cast<double>(config.token_per_minute_limit()), 1e12);
}

void CheckPrices(const config::v1::LlmConfig& config, Checker& checker) {
  for (int i = 0; i < config.prices_size(); ++i) {
    const config::v1::LlmPrice& price = config.prices(i);
    const std::string field = fmt::format("prices[{}]", i);
    if (price.model().empty())
      checker.Report(field + ".model", "missing; expected a name, or a prefix that ends in \"*\"");
    checker.Price(field + ".input_usd", price.input_usd());
    checker.Price(field + ".cached_input_usd", price.cached_input_usd());
    checker.Price(field + ".output_usd", price.output_usd());
  }
}

// How well a price's name fits: -1 not at all, else the number of characters that agree; an exact name beats any
// prefix.
int Fit(const std::string& pattern, const std::string& model) {
  if (pattern == model) return static_cast<int>(model.size()) + 1;
  if (pattern.empty() || pattern.back() != '*') return -1;
  const size_t length = pattern.size() - 1;
  return model.compare(0, length, pattern, 0, length) == 0 ? static_cast<int>(length) : -1;
}

}  // namespace

void CheckLlmConfig(const config::v1::LlmConfig& config, const ConfigReport& report) {
  Checker checker(report);
  if (config.replay_path().empty()) {
    CheckServer(config, checker);
  } else if (!config.record_path().empty()) {
    checker.Report("record_path", "set as well as replay_path; expected one of them");
  }
  CheckSampling(config, checker);
  CheckPatience(config, checker);
  CheckPrices(config, checker);
}

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
