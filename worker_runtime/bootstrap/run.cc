// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/run.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace flair::runtime::internal {
namespace {

// Blocks the signals in this thread and in all that it starts later.
sigset_t BlockStopSignals() {
  signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void WaitForSignal(const sigset_t& signals) {
  int signal_number = 0;
  while (sigwait(&signals, &signal_number) != 0) {
  }
}

std::string Usage(const Program& program, const google::protobuf::Message& config) {
  return fmt::format(
      "{0}: {1}\n\nUsage: {0} CONFIG\n       {0} --help\n\nCONFIG is a text proto of {2} with these "
      "fields:\n{3}\nServes until SIGTERM or SIGINT, then finishes running calls. A second signal ends it at once.\n",
      program.name, program.summary, config.GetDescriptor()->full_name(), DescribeConfig(*config.GetDescriptor()));
}

// From here on a signal asks for a stop; once the stop has begun, another one ends the process at once.
void EndAtOnceOnSignal(const sigset_t& signals) {
  std::thread([signals] {
    WaitForSignal(signals);
    _exit(1);
  }).detach();
}

}  // namespace

int RunProgram(int argc, char** argv, const Program& program, google::protobuf::Message& config,
               const std::function<const config::v1::RuntimeConfig&()>& runtime,
               const std::function<void(ConfigChecker&)>& check, const std::function<absl::Status(Worker&)>& assemble) {
  const std::string argument = argc == 2 ? argv[1] : "";
  if (argument == "--help" || argument == "-h") {
    std::fputs(Usage(program, config).c_str(), stdout);
    return 0;
  }
  if (argument.empty() || argument.starts_with("-")) {
    std::fputs(Usage(program, config).c_str(), stderr);
    return 2;
  }
  if (absl::Status status = ReadConfigFile(argument, config, check); !status.ok()) {
    fmt::print(stderr, "{}: bad config\n{}\n", program.name, std::string(status.message()));
    return 2;
  }
  // Every failure is reported with its reason below; gRPC would print the same once more, for its authors.
  setenv("GRPC_VERBOSITY", "NONE", 0);
  const sigset_t signals = BlockStopSignals();
  Worker worker(program.name, runtime());
  worker.context().build = program.build;
  absl::Status status = assemble(worker);
  if (status.ok()) status = worker.Start();
  if (!status.ok()) {
    fmt::print(stderr, "{}: {}\n", program.name, std::string(status.message()));
    return status.code() == absl::StatusCode::kInvalidArgument ? 2 : 1;
  }
  WaitForSignal(signals);
  EndAtOnceOnSignal(signals);
  worker.Stop();
  return 0;
}

}  // namespace flair::runtime::internal
