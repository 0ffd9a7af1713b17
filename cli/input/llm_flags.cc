// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/llm_flags.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "cli/input/command_line.h"
#include "fmt/format.h"
#include "llm/config/check_llm_config.h"
#include "llm/wrappers/metered_llm_client.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using config::v1::LlmConfig;

constexpr char kFileVariable[] = "FLAIR_LLM";

// A flag and the field that it sets.
struct FlagField {
  std::string_view flag;
  std::string_view field;
  std::string LlmFlags::*value;
  void (*set)(LlmConfig& config, const std::string& value);
};

constexpr std::array<FlagField, 7> kFlagFields = {{
    {"--model", "model", &LlmFlags::model, [](LlmConfig& config, const std::string& v) { config.set_model(v); }},
    {"--base-url", "base_url", &LlmFlags::base_url,
     [](LlmConfig& config, const std::string& v) { config.set_base_url(v); }},
    {"--api-key-env", "api_key_env", &LlmFlags::api_key_env,
     [](LlmConfig& config, const std::string& v) {
       config.set_api_key_env(v);
       config.clear_api_key_path();
     }},
    {"--record", "record_path", &LlmFlags::record,
     [](LlmConfig& config, const std::string& v) {
       config.set_record_path(v);
       config.clear_replay_path();
     }},
    {"--replay", "replay_path", &LlmFlags::replay,
     [](LlmConfig& config, const std::string& v) {
       config.set_replay_path(v);
       config.clear_record_path();
     }},
    {"--cache", "cache_path", &LlmFlags::cache,
     [](LlmConfig& config, const std::string& v) { config.set_cache_path(v); }},
    {"--prompts", "prompts_path", &LlmFlags::prompts,
     [](LlmConfig& config, const std::string& v) { config.set_prompts_path(v); }},
}};

void Apply(const LlmFlags& flags, LlmConfig& config) {
  for (const FlagField& entry : kFlagFields) {
    if (const std::string& value = flags.*entry.value; !value.empty()) entry.set(config, value);
  }
}

// The flag that decided the field, or that could; empty for fields without one.
std::string_view FlagFor(std::string_view field) {
  const auto found = std::ranges::find(kFlagFields, field, &FlagField::field);
  return found == kFlagFields.end() ? std::string_view() : found->flag;
}

bool IsGiven(const LlmFlags& flags, std::string_view field) {
  const auto found = std::ranges::find(kFlagFields, field, &FlagField::field);
  return found != kFlagFields.end() && !(flags.*found->value).empty();
}

// Variables that hold secrets must be there; what they hold is read later.
void CheckVariables(const LlmConfig& config, const llm::ConfigReport& report) {
  if (!config.replay_path().empty()) return;
  const auto check = [&report](std::string_view field, const std::string& name) {
    const char* value = std::getenv(name.c_str());
    if (name.empty() || (value != nullptr && *value != '\0')) return;
    report(field, fmt::format("{}: this variable of the environment is not set", name));
  };
  check("api_key_env", config.api_key_env());
  for (int i = 0; i < config.headers_size(); ++i) {
    check(fmt::format("headers[{}].value_env", i), config.headers(i).value_env());
  }
}

void CheckAll(const LlmConfig& config, const llm::ConfigReport& report) {
  llm::CheckLlmConfig(config, report);
  CheckVariables(config, report);
}

// Errors of this program are one line.
absl::Status OneLine(const absl::Status& status) {
  std::string text(status.message());
  for (size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) text.replace(end, 1, "; ");
  return absl::Status(status.code(), text);
}

absl::StatusOr<LlmConfig> ReadFileAndFlags(const std::string& path, const LlmFlags& flags) {
  LlmConfig config;
  const absl::Status status = runtime::ReadConfigFile(path, config, [&](runtime::ConfigChecker& checker) {
    Apply(flags, config);
    CheckAll(config, [&](std::string_view field, std::string_view problem) {
      // What a flag said stands on no line of the file.
      checker.Report(IsGiven(flags, field) ? FlagFor(field) : field, problem);
    });
  });
  if (!status.ok()) return OneLine(status);
  return config;
}

absl::StatusOr<LlmConfig> ReadFlagsAlone(const LlmFlags& flags) {
  LlmConfig config;
  Apply(flags, config);
  std::string problems;
  CheckAll(config, [&problems](std::string_view field, std::string_view problem) {
    const std::string_view flag = FlagFor(field);
    problems += fmt::format("{}{}: {}", problems.empty() ? "" : "; ", flag.empty() ? field : flag, problem);
  });
  if (!problems.empty()) return absl::InvalidArgumentError(problems);
  return config;
}

}  // namespace

std::string LlmFlags::Given() const {
  if (!file.empty()) return "--llm";
  for (const FlagField& entry : kFlagFields) {
    if (!(this->*entry.value).empty()) return std::string(entry.flag);
  }
  return "";
}

void AddLlmFlags(CLI::App& command, LlmFlags& flags) {
  const std::string group = "Language model";
  const auto add = [&](const char* flag, std::string& value, const char* help, const char* type) {
    return command.add_option(flag, value, help)->type_name(type)->group(group);
  };
  add("--llm", flags.file,
      "The model and how to reach it, as text of an LlmConfig (default $FLAIR_LLM; without either, no model)", "FILE");
  add("--model", flags.model, "The model's name, such as gpt-4o", "NAME");
  add("--base-url", flags.base_url, "Its server, such as https://api.openai.com/v1 or http://127.0.0.1:11434/v1",
      "URL");
  add("--api-key-env", flags.api_key_env, "Variable of the environment that holds the key; none when not given", "VAR");
  CLI::Option* record = add("--record", flags.record, "Write all questions and answers to this folder", "DIR");
  add("--replay", flags.replay, "Take all answers from this folder; no network", "DIR")->excludes(record);
  add("--cache", flags.cache, "Keep answers in this folder and ask nothing twice", "DIR");
  add("--prompts", flags.prompts, "Your own prompts, in place of ours of the same name (flair prompts)", "DIR");
}

void AddModelFlags(CLI::App& command, ModelFlags& flags) {
  const std::string group = "Language model";
  command.add_option("--max-calls", flags.calls, "Most calls of the model, 0 to 100000; beyond that the design fails")
      ->type_name("N")
      ->check(WholeNumber(0, 100000))
      ->group(group);
  command.add_option("--max-tokens", flags.tokens, "Most tokens of questions and answers, 0 to 10^9")
      ->type_name("N")
      ->check(WholeNumber(0, 1000000000))
      ->group(group);
  command.add_option("--max-usd", flags.usd, "Most US dollars, 0 to 1000000, by the prices of the --llm file")
      ->type_name("USD")
      ->check(Number(0.0, 1e6))
      ->group(group);
  command
      .add_flag("--stand-in", flags.stand_in,
                "Where the model fails, the handbook or the grammar answers, and the report says so")
      ->group(group);
  command.add_flag("--omit-texts", flags.texts_omitted, "Keep questions and answers out of what is stored")
      ->group(group);
}

absl::StatusOr<std::optional<LlmConfig>> ReadLlmFlags(const LlmFlags& flags) {
  std::string path = flags.file;
  if (path.empty()) {
    const char* variable = std::getenv(kFileVariable);
    if (variable != nullptr) path = variable;
  }
  if (path.empty() && flags.Given().empty()) return std::optional<LlmConfig>();
  ASSIGN_OR_RETURN(LlmConfig config, path.empty() ? ReadFlagsAlone(flags) : ReadFileAndFlags(path, flags));
  return std::optional<LlmConfig>(std::move(config));
}

absl::Status CheckLimits(const ModelFlags& flags, const LlmConfig& config) {
  if (!flags.usd.has_value() || !config.replay_path().empty()) return absl::OkStatus();
  llm::Usage usage;
  usage.input_token_count = usage.output_token_count = 1000;
  const std::vector<config::v1::LlmPrice> prices(config.prices().begin(), config.prices().end());
  if (llm::CostUsd(prices, config.model(), usage) > 0) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("--max-usd: {}: there is no price for the model \"{}\"; add to the --llm file: prices {{ model: "
                  "\"{}\" input_usd: ... output_usd: ... }}, US dollars for a million tokens",
                  *flags.usd, config.model(), config.model()));
}

absl::StatusOr<std::optional<LlmConfig>> ReadDesignModel(const LlmFlags& flags, const ModelFlags& limits,
                                                         const std::string& orchestrator) {
  if (!orchestrator.empty()) {
    const std::string given = flags.Given();
    if (given.empty()) return std::optional<LlmConfig>();
    return absl::InvalidArgumentError(
        fmt::format("{}: not with --orchestrator {}: its workers have their own models, in the field llm of their "
                    "configs; limits such as --max-tokens can be given",
                    given, orchestrator));
  }
  absl::StatusOr<std::optional<LlmConfig>> llm = ReadLlmFlags(flags);
  if (!llm.ok() || !llm->has_value()) return llm;
  RETURN_IF_ERROR(CheckLimits(limits, **llm));
  return llm;
}

v1::ModelOptions MakeModelOptions(const ModelFlags& flags) {
  v1::ModelOptions options;
  if (flags.calls) options.mutable_budget()->set_call_count(*flags.calls);
  if (flags.tokens) options.mutable_budget()->set_token_count(*flags.tokens);
  if (flags.usd) options.mutable_budget()->set_cost_usd(*flags.usd);
  options.set_stand_in_allowed(flags.stand_in);
  options.set_texts_omitted(flags.texts_omitted);
  return options;
}

}  // namespace flair::cli
