// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/service_flags.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "CLI/CLI.hpp"
#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/string_view.h"
#include "absl/time/clock.h"
#include "cli/input/command_line.h"
#include "fmt/format.h"
#include "llm/config/check_llm_config.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr size_t kTokenLength = 1000;

struct ConnectionFlags {
  bool tls = false;
  std::string authority;
  std::string certificate;
  std::string key;
  std::string token_file;
  bool allow_insecure = false;

  bool WantTls() const { return tls || !authority.empty() || !certificate.empty() || !key.empty(); }
};

// Of the one command that this process runs.
ConnectionFlags& Flags() {
  static ConnectionFlags& flags = *new ConnectionFlags();
  return flags;
}

std::string Variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// `where` it is from; the token itself is in no message.
absl::StatusOr<std::string> CheckedToken(std::string token, const std::string& where) {
  absl::StripAsciiWhitespace(&token);
  if (token.empty()) return InvalidArgument("{}: holds no token", where);
  const bool printable = std::ranges::all_of(token, [](char c) { return c > ' ' && c <= '~'; });
  if (printable && token.size() <= kTokenLength) return token;
  return InvalidArgument("{}: not a token; expected at most {} letters, digits and signs without spaces", where,
                         kTokenLength);
}

absl::StatusOr<std::string> TokenOf(const std::string& file, const std::string& flag) {
  const std::string where = fmt::format("{} {}", flag, file);
  std::ifstream stream(file, std::ios::binary);
  // No more of it than shows that it is too long.
  std::string content(kTokenLength + 100, '\0');
  if (stream) stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!stream.is_open() || stream.bad()) return InvalidArgument("{}: cannot be read", where);
  content.resize(static_cast<size_t>(stream.gcount()));
  return CheckedToken(std::move(content), where);
}

// Empty when none is given.
absl::StatusOr<std::string> GivenToken() {
  if (!Flags().token_file.empty()) return TokenOf(Flags().token_file, "--token-file");
  if (const std::string file = Variable("FLAIR_TOKEN_FILE"); !file.empty()) return TokenOf(file, "FLAIR_TOKEN_FILE");
  if (const std::string token = Variable("FLAIR_TOKEN"); !token.empty()) return CheckedToken(token, "FLAIR_TOKEN");
  return "";
}

void AddTo(CLI::App& command, bool calls_orchestrator) {
  ConnectionFlags& flags = Flags();
  const auto flag = [&](const char* name, bool& value, const char* help) {
    command.add_flag(name, value, help)->group("Connection");
  };
  const auto file = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->type_name("FILE")->group("Connection");
  };
  flag("--tls", flags.tls, "Use TLS; trusts the system's certificate authorities unless others are given");
  file("--tls-authority", flags.authority, "PEM file with the certificate authorities to trust; implies --tls")
      ->envname("FLAIR_TLS_AUTHORITY");
  file("--tls-certificate", flags.certificate, "PEM file with a client certificate, for servers that require one")
      ->envname("FLAIR_TLS_CERTIFICATE");
  file("--tls-key", flags.key, "PEM file with its key")->envname("FLAIR_TLS_KEY");
  if (!calls_orchestrator) return;
  file("--token-file", flags.token_file,
       "File with the token that the orchestrator requires; otherwise FLAIR_TOKEN_FILE or FLAIR_TOKEN");
  flag("--allow-insecure", flags.allow_insecure, "Send the token in plain text, even to other machines");
}

bool Has(const CLI::App& command, std::initializer_list<const char*> options) {
  return std::ranges::any_of(options, [&](const char* name) { return command.get_option_no_throw(name) != nullptr; });
}

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

void AddConnectionFlags(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
    const bool calls_orchestrator = Has(*command, {"--orchestrator", "--target"});
    const bool calls_stage = Has(*command, {"--language", "--translator", "--optimizer", "--renderer", "ADDRESS"});
    if (calls_orchestrator || calls_stage) AddTo(*command, calls_orchestrator);
    AddConnectionFlags(*command);
  }
}

absl::StatusOr<runtime::ChannelOptions> StageConnection() {
  const ConnectionFlags& flags = Flags();
  runtime::ChannelOptions options;
  options.allow_insecure = true;
  if (!flags.WantTls()) return options;
  if (flags.certificate.empty() != flags.key.empty()) {
    return absl::InvalidArgumentError(flags.key.empty()
                                          ? fmt::format("--tls-certificate {}: needs --tls-key too", flags.certificate)
                                          : fmt::format("--tls-key {}: needs --tls-certificate too", flags.key));
  }
  config::v1::TlsConfig& tls = options.tls.emplace();
  tls.set_authority_path(flags.authority);
  tls.set_certificate_path(flags.certificate);
  tls.set_key_path(flags.key);
  RETURN_IF_ERROR(runtime::CheckTlsFiles(
      tls, absl::Now(), {.certificate = "--tls-certificate", .key = "--tls-key", .authority = "--tls-authority"}));
  return options;
}

absl::StatusOr<runtime::ChannelOptions> OrchestratorConnection() {
  absl::StatusOr<runtime::ChannelOptions> options = StageConnection();
  if (!options.ok()) return options;
  ASSIGN_OR_RETURN(std::string token, GivenToken());
  options->token = std::move(token);
  options->allow_insecure = options->token.empty() || Flags().allow_insecure;
  return options;
}

EngineFlags::EngineFlags(CLI::App& command) : Options(command, "Queue on other machines") {
  Bind("--replicas N", replica_count, "Replicas when the queue is created: 1, 3 or 5 (1)")
      ->check(OneOf({"1", "3", "5"}));
}

absl::Status CheckEngineFlags(const EngineFlags& flags, const std::string& orchestrator) {
  if (!flags.address.empty() && !orchestrator.empty()) {
    return InvalidArgument(
        "--engine: not with --orchestrator {}, which uses the queue of its own config; set queue.address there",
        orchestrator);
  }
  if (!flags.address.empty()) return absl::OkStatus();
  const char* const flag = flags.replica_count > 0    ? "--replicas"
                           : !flags.artifacts.empty() ? "--artifacts"
                           : !flags.queue.empty()     ? "--queue"
                                                      : nullptr;
  if (flag == nullptr) return absl::OkStatus();
  return InvalidArgument("{}: belongs to a queue of --engine nats://HOST:PORT; give both", flag);
}

void SetEngine(const EngineFlags& flags, config::v1::OrchestratorConfig& config) {
  if (flags.address.empty()) return;
  config.mutable_queue()->set_address(flags.address);
  config.mutable_queue()->set_name(flags.queue);
  config.mutable_queue()->set_replica_count(flags.replica_count);
  config.set_artifact_store(flags.artifacts);
}

std::string DefaultStorePath() {
  if (std::string home = Variable("FLAIR_HOME"); !home.empty()) return home;
  if (std::string data = Variable("XDG_DATA_HOME"); !data.empty()) return data + "/flair";
  if (std::string home = Variable("HOME"); !home.empty()) return home + "/.local/share/flair";
  return "flair-store";
}

StageFlags::StageFlags(CLI::App& command) : Options(command, "Stages on other servers") {
  const auto add = [this](const std::string& stage, std::string* address, const std::string& more = "") {
    Bind(fmt::format("--{} HOST:PORT[,HOST:PORT...]", stage), *address,
         fmt::format("Server of the {} stage, instead of the built-in one{}", stage, more));
  };
  add("language", addresses.mutable_language());
  add("translator", addresses.mutable_translator());
  add("optimizer", addresses.mutable_optimizer(), "; its catalogue is used");
  add("renderer", addresses.mutable_renderer());
  Bind("--handbook DIR", handbooks,
       "Furniture, kinds of room and styles of your own, added to the handbook; may be repeated")
      ->allow_extra_args(false)
      ->group("Options");
}

absl::Status CheckStageFlags(const StageChoice& flags, const std::string& orchestrator, const LlmFlags& llm) {
  const struct {
    const char* stage;
    const std::string& address;
  } stages[] = {{"language", flags.addresses.language()},
                {"translator", flags.addresses.translator()},
                {"optimizer", flags.addresses.optimizer()},
                {"renderer", flags.addresses.renderer()}};
  for (const auto& [stage, address] : stages) {
    if (address.empty() || orchestrator.empty()) continue;
    return InvalidArgument(
        "--{0} {1}: not with --orchestrator {2}, which uses the stages of its own config; set there: stages "
        "{{ {0}: \"{1}\" }}",
        stage, address, orchestrator);
  }
  const std::string& language = orchestrator.empty() ? flags.addresses.language() : orchestrator;
  if (!flags.handbooks.empty() && !language.empty()) {
    return InvalidArgument(
        "--handbook {}: not with {} {}, whose language worker reads its own handbook; set in its config: "
        "handbook_overlay_paths: \"{}\"",
        flags.handbooks[0], orchestrator.empty() ? "--language" : "--orchestrator", language, flags.handbooks[0]);
  }
  const std::string& renderer = orchestrator.empty() ? flags.addresses.renderer() : orchestrator;
  if (!flags.asset_folder.empty() && !renderer.empty()) {
    return InvalidArgument(
        "--assets {}: not with {} {}, whose renderer has its own models; set in its config: asset_folder_path: \"{}\"",
        flags.asset_folder, orchestrator.empty() ? "--renderer" : "--orchestrator", renderer, flags.asset_folder);
  }
  if (flags.addresses.language().empty() || flags.addresses.translator().empty() || llm.Given().empty())
    return absl::OkStatus();
  return InvalidArgument(
      "{}: not with both --language {} and --translator {}: they have their own models, and no other stage "
      "asks one",
      llm.Given(), flags.addresses.language(), flags.addresses.translator());
}

absl::Status NoOrchestrator(const absl::Status& status, const std::string& address) {
  if (!absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status)) return status;
  const std::string_view why(status.message().data(), status.message().size());
  return Unavailable(
      "no orchestrator answers at {}: {}{} Is flair-orchestrator running there? Without --orchestrator, flair "
      "uses this machine alone",
      address, why, why.ends_with('?') ? "" : ".");
}

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
