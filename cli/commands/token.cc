// SPDX-License-Identifier: GPL-3.0-or-later
// flair token new: makes a token for somebody who is to call an orchestrator.
#include <sys/random.h>
#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "absl/strings/escaping.h"
#include "cli/commands/commands.h"
#include "flair/config/v1/token_list.pb.h"
#include "fmt/format.h"
#include "google/protobuf/text_format.h"
#include "orchestrator/access/access_control.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr size_t kTokenBytes = 32;

struct TokenArguments : Options {
  using Options::Options;
  std::string& name = Required("NAME", "Who it is for; jobs are kept under this name");
  std::string& out =
      Text("--token-out FILE", "Write the token to a new file that only you can read, instead of the screen");
  int& open_job_limit =
      Whole("--open-jobs N", 0, 1000000, 0, "Most jobs that may wait or run at once, 0 to 1000000 (0: no limit)");
  int& calls_per_minute_limit =
      Whole("--calls-per-minute N", 0, 1000000, 0, "Most calls a minute, 0 to 1000000 (0: no limit)");
  bool& is_operator = Flag("--operator", "May see and do everything, whoever owns it");
};

absl::StatusOr<std::string> NewToken() {
  std::array<char, kTokenBytes> bytes = {};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    return absl::InternalError("the system provides no random numbers");
  }
  // What begins so is found by those who look for secrets in the wrong places.
  return "flair_" + absl::WebSafeBase64Escape(absl::string_view(bytes.data(), bytes.size()));
}

// Only its owner may read it, from the first byte on.
absl::Status WriteToken(const std::string& path, const std::string& token) {
  if (std::filesystem::exists(path)) {
    return absl::InvalidArgumentError(
        fmt::format("--token-out {}: already exists; a token is never overwritten", path));
  }
  const mode_t mask = ::umask(077);
  const absl::Status status = runtime::WriteFileAtomically(path, token + "\n");
  ::umask(mask);
  return status;
}

absl::Status New(const TokenArguments& arguments) {
  ASSIGN_OR_RETURN(const std::string token, NewToken());
  config::v1::TokenList list;
  config::v1::TokenEntry& entry = *list.add_tokens();
  entry.set_name(arguments.name);
  entry.set_sha256(runtime::Sha256Hex(token));
  if (arguments.open_job_limit != 0) entry.set_open_job_limit(arguments.open_job_limit);
  if (arguments.calls_per_minute_limit != 0) entry.set_calls_per_minute_limit(arguments.calls_per_minute_limit);
  if (arguments.is_operator) entry.set_operator_(true);
  RETURN_IF_ERROR(orchestrator::CheckTokenList(list));
  if (!arguments.out.empty()) {
    RETURN_IF_ERROR(WriteToken(arguments.out, token));
  }
  std::string text;
  google::protobuf::TextFormat::PrintToString(list, &text);
  fmt::print("{}", text);
  std::fflush(stdout);
  if (arguments.out.empty()) fmt::print(stderr, "\nThe token, which is shown only now and kept nowhere:\n{}\n", token);
  return absl::OkStatus();
}

}  // namespace

void AddToken(const Commands& program) {
  program.Group("token", "Manage tokens for callers of an orchestrator.")
      .Add("new", "Make a token, and its entry for the file in tokens_path.", New,
           "The entry goes to standard output, the token to standard error:\n"
           "  flair token new alice --token-out alice.token >> tokens.textproto\n"
           "  flair jobs --orchestrator HOST:PORT --tls --token-file alice.token\n"
           "A running orchestrator reads the file again within seconds (docs/security.md).");
}

}  // namespace flair::cli
