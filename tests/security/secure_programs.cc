// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/security/secure_programs.h"

#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

#include "absl/time/clock.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::testing {
namespace {

constexpr absl::Duration kPatience = absl::Seconds(60);

// What gRPC says of handshakes that are meant to fail.
const bool kQuiet = ::setenv("GRPC_VERBOSITY", "NONE", 0) == 0;

}  // namespace

std::string TokenEntry(const std::string& name, const std::string& token, const std::string& more) {
  return fmt::format("tokens {{ name: \"{}\" sha256: \"{}\" {} }}\n", name, runtime::Sha256Hex(token), more);
}

SecureOptimizer::SecureOptimizer(const std::string& more)
    : authority_(folder_.path(), "authority"),
      identity_(authority_.Issue("optimizer")),
      friend_(authority_.Issue("friend")),
      program_("flair-optimizer", RuntimeWithTls(authority_.Tls(identity_, true), more), folder_.path()) {}

runtime::ChannelOptions SecureOptimizer::Friend() const {
  runtime::ChannelOptions options;
  options.tls = authority_.Tls(friend_, false);
  return options;
}

SecurePrograms::SecurePrograms(const std::string& tokens, const std::string& log_level)
    : authority_(folder_.path(), "authority") {
  WriteAll(tokens_path(), tokens);
  std::string stages;
  for (const std::string name : {"language", "translator", "optimizer", "renderer"}) {
    const std::string config =
        RuntimeWithTls(authority_.Tls(authority_.Issue(name), true), "log_level: \"" + log_level + "\"");
    stages_.push_back(std::make_unique<ServerProgram>("flair-" + name, config, folder_.path()));
    stages += fmt::format("{}: \"{}\" ", name, stages_.back()->address());
  }
  const std::string config =
      RuntimeWithTls(authority_.Tls(authority_.Issue("orchestrator"), false), "log_level: \"" + log_level + "\"") +
      fmt::format("store_path: \"{}\"\ntokens_path: \"{}\"\nstages {{ {} }}\n", (folder_ / "store").string(),
                  tokens_path(), stages);
  orchestrator_ = std::make_unique<ServerProgram>("flair-orchestrator", config, folder_.path());
}

runtime::ChannelOptions SecurePrograms::With(const std::string& token) const {
  runtime::ChannelOptions options;
  options.tls.emplace().set_authority_path(authority_.path());
  options.token = token;
  return options;
}

std::vector<std::string> SecurePrograms::Flags(const std::string& token_file) const {
  return {"--orchestrator", orchestrator(), "--tls-authority", authority_.path(), "--token-file", token_file};
}

std::vector<ServerProgram*> SecurePrograms::programs() {
  std::vector<ServerProgram*> all = {orchestrator_.get()};
  for (const auto& stage : stages_) all.push_back(stage.get());
  return all;
}

absl::Status AskWho(const std::string& address, const runtime::ChannelOptions& options) {
  ASSIGN_OR_RETURN(const auto channel, runtime::MakeChannel(address, v1::WorkerService::service_full_name(), options));
  const auto stub = v1::WorkerService::NewStub(channel);
  runtime::CallContext call;
  return runtime::UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call,
                               absl::Now() + kPatience)
      .status();
}

int PeakMib(const Process& process) {
  std::istringstream status(ReadAll(fmt::format("/proc/{}/status", process.pid())));
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stoi(line.substr(6)) / 1024;
  }
  return -1;
}

}  // namespace flair::testing
