// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "cli/input/service_flags.h"
#include "fmt/format.h"
#include "llm/config/check_llm_config.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using config::v1::LlmConfig;

// A flag and the field that it sets.
struct FlagField {
  std::string_view field;
  // The field that a file may hold and that then does not count.
  const char* clears;
  const char* flag;
  const char* help;
};

constexpr FlagField kFlagFields[] = {
    {"model", nullptr, "--model NAME", "The model's name, such as gpt-4o"},
    {"base_url", nullptr, "--base-url URL",
     "Its server, such as https://api.openai.com/v1 or http://127.0.0.1:11434/v1"},
    {"api_key_env", "api_key_path", "--api-key-env VAR", "Environment variable that holds the key (none)"},
    {"record_path", "replay_path", "--record DIR", "Record all questions and answers in this folder"},
    {"replay_path", "record_path", "--replay DIR", "Take all answers from this folder, without a network"},
    {"cache_path", nullptr, "--cache DIR", "Cache answers in this folder, so that no question is asked twice"},
    {"prompts_path", nullptr, "--prompts DIR", "Your own prompts, which replace ours of the same name (flair prompts)"},
};

// The flag that decides the field; the field itself where there is none.
std::string_view FlagFor(std::string_view field) {
  const auto* const found = std::ranges::find(kFlagFields, field, &FlagField::field);
  if (found == std::end(kFlagFields)) return field;
  const std::string_view flag = found->flag;
  return flag.substr(0, flag.find(' '));
}

void Apply(const LlmFlags& flags, LlmConfig& config) {
  const auto field_of = [](std::string_view name) {
    return LlmConfig::descriptor()->FindFieldByName(std::string(name));
  };
  for (const FlagField& entry : kFlagFields) {
    const std::string* const value = flags.ValueOf(entry.field);
    if (value == nullptr) continue;
    LlmConfig::GetReflection()->SetString(&config, field_of(entry.field), *value);
    if (entry.clears != nullptr) LlmConfig::GetReflection()->ClearField(&config, field_of(entry.clears));
  }
}

// Variables that hold secrets must be there; what they hold is read later.
void CheckVariables(const LlmConfig& config, const llm::ConfigReport& report) {
  if (!config.replay_path().empty()) return;
  const auto check = [&report](std::string_view field, const std::string& name) {
    const char* value = std::getenv(name.c_str());
    if (name.empty() || (value != nullptr && *value != '\0')) return;
    report(field, fmt::format("{}: this environment variable is not set", name));
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

// With a file, its faults have lines, and those of flags none.
absl::StatusOr<LlmConfig> ReadFileAndFlags(const std::string& path, const LlmFlags& flags) {
  LlmConfig config;
  const absl::Status status = runtime::ReadConfigFile(path, config, [&](runtime::ConfigChecker& checker) {
    Apply(flags, config);
    CheckAll(config, [&](std::string_view field, std::string_view problem) {
      checker.Report(flags.ValueOf(field) != nullptr ? FlagFor(field) : field, problem);
    });
  });
  // Errors of this program are one line.
  if (!status.ok()) return absl::Status(status.code(), absl::StrReplaceAll(status.message(), {{"\n", "; "}}));
  return config;
}

absl::StatusOr<LlmConfig> ReadFlagsAlone(const LlmFlags& flags) {
  LlmConfig config;
  Apply(flags, config);
  std::vector<std::string> problems;
  CheckAll(config, [&problems](std::string_view field, std::string_view problem) {
    problems.push_back(fmt::format("{}: {}", FlagFor(field), problem));
  });
  if (!problems.empty()) return absl::InvalidArgumentError(absl::StrJoin(problems, "; "));
  return config;
}

}  // namespace

LlmFlags::LlmFlags(CLI::App& command)
    : Options(command, "Language model"),
      file_(Text(
          "--llm FILE",
          "The model and how to reach it, as text of an LlmConfig (default $FLAIR_LLM; without either, no model)")) {
  for (const FlagField& entry : kFlagFields) {
    values_[entry.field] = &Text(entry.flag, entry.help, entry.field == "replay_path" ? Names{"--record"} : Names{});
  }
}

std::string LlmFlags::Given() const {
  if (!file_.empty()) return "--llm";
  for (const FlagField& entry : kFlagFields) {
    if (ValueOf(entry.field) != nullptr) return std::string(FlagFor(entry.field));
  }
  return "";
}

const std::string* LlmFlags::ValueOf(std::string_view field) const {
  const auto found = values_.find(field);
  return found == values_.end() || found->second->empty() ? nullptr : found->second;
}

absl::StatusOr<OptionalLlm> ReadLlmFlags(const LlmFlags& flags) {
  const char* const variable = std::getenv("FLAIR_LLM");
  const std::string path = flags.file().empty() && variable != nullptr ? variable : flags.file();
  if (path.empty() && flags.Given().empty()) return OptionalLlm();
  return path.empty() ? ReadFlagsAlone(flags) : ReadFileAndFlags(path, flags);
}

absl::Status CheckLimits(const v1::ModelOptions& limits, const LlmConfig& config) {
  if (!limits.budget().has_cost_usd() || !config.replay_path().empty()) return absl::OkStatus();
  llm::Usage usage;
  usage.input_token_count = usage.output_token_count = 1000;
  const std::vector<config::v1::LlmPrice> prices(config.prices().begin(), config.prices().end());
  if (llm::CostUsd(prices, config.model(), usage) > 0) return absl::OkStatus();
  return InvalidArgument(
      "--max-usd: {}: there is no price for the model \"{}\"; add to the --llm file: prices {{ model: "
      "\"{}\" input_usd: ... output_usd: ... }}, US dollars for a million tokens",
      limits.budget().cost_usd(), config.model(), config.model());
}

absl::StatusOr<OptionalLlm> ReadDesignModel(const LlmFlags& flags, const v1::ModelOptions& limits,
                                            const std::string& orchestrator) {
  if (!orchestrator.empty()) {
    const std::string given = flags.Given();
    if (given.empty()) return OptionalLlm();
    return InvalidArgument(
        "{}: not with --orchestrator {}: its workers have their own models, in the field llm of their "
        "configs; limits such as --max-tokens can be given",
        given, orchestrator);
  }
  ASSIGN_OR_RETURN(OptionalLlm llm, ReadLlmFlags(flags));
  if (llm.has_value()) RETURN_IF_ERROR(CheckLimits(limits, *llm));
  return llm;
}

}  // namespace flair::cli
