// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/connection_flags.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "absl/strings/ascii.h"
#include "absl/strings/string_view.h"
#include "absl/time/clock.h"
#include "fmt/format.h"
#include "worker_runtime/security/security.h"

namespace flair::cli {
namespace {

constexpr char kGroup[] = "Connection";
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
  if (token.empty()) return absl::InvalidArgumentError(fmt::format("{}: holds no token", where));
  const bool printable = std::ranges::all_of(token, [](char c) { return c > ' ' && c <= '~'; });
  if (printable && token.size() <= kTokenLength) return token;
  return absl::InvalidArgumentError(fmt::format(
      "{}: that is no token; expected at most {} letters, digits and signs without spaces", where, kTokenLength));
}

absl::StatusOr<std::string> TokenOf(const std::string& file, const std::string& flag) {
  const std::string where = fmt::format("{} {}", flag, file);
  std::ifstream stream(file, std::ios::binary);
  // No more of it than shows that it is too long.
  std::string content(kTokenLength + 100, '\0');
  if (stream) stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!stream.is_open() || stream.bad()) return absl::InvalidArgumentError(fmt::format("{}: cannot be read", where));
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
  command.add_flag("--tls", flags.tls, "TLS; believes the machine's authorities unless others are given")
      ->group(kGroup);
  command.add_option("--tls-authority", flags.authority, "PEM file of the authorities to believe; means --tls")
      ->type_name("FILE")
      ->envname("FLAIR_TLS_AUTHORITY")
      ->group(kGroup);
  command.add_option("--tls-certificate", flags.certificate, "PEM file with an own certificate, for servers that ask")
      ->type_name("FILE")
      ->envname("FLAIR_TLS_CERTIFICATE")
      ->group(kGroup);
  command.add_option("--tls-key", flags.key, "PEM file with its key")
      ->type_name("FILE")
      ->envname("FLAIR_TLS_KEY")
      ->group(kGroup);
  if (!calls_orchestrator) return;
  command
      .add_option("--token-file", flags.token_file,
                  "File with the token that the orchestrator asks for; otherwise FLAIR_TOKEN_FILE or FLAIR_TOKEN")
      ->type_name("FILE")
      ->group(kGroup);
  command.add_flag("--allow-insecure", flags.allow_insecure, "Send the token in plain text, to other machines too")
      ->group(kGroup);
}

bool Has(const CLI::App& command, std::initializer_list<const char*> options) {
  return std::ranges::any_of(options, [&](const char* name) { return command.get_option_no_throw(name) != nullptr; });
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
  const absl::Status status = runtime::CheckTlsFiles(
      tls, absl::Now(), {.certificate = "--tls-certificate", .key = "--tls-key", .authority = "--tls-authority"});
  if (!status.ok()) return status;
  return options;
}

absl::StatusOr<runtime::ChannelOptions> OrchestratorConnection() {
  absl::StatusOr<runtime::ChannelOptions> options = StageConnection();
  if (!options.ok()) return options;
  absl::StatusOr<std::string> token = GivenToken();
  if (!token.ok()) return token.status();
  options->token = *std::move(token);
  options->allow_insecure = options->token.empty() || Flags().allow_insecure;
  return options;
}

}  // namespace flair::cli
