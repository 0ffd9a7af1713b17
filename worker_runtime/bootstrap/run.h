// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "absl/status/status.h"
#include "worker_runtime/bootstrap/worker.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::runtime {

// What a program says about itself.
struct Program {
  // Such as "flair-optimizer".
  std::string name;
  // One sentence, such as "Serves flair.v1.OptimizerService: places objects."
  std::string summary;
  // BuildName(), for all but tests.
  std::string build = "";
};

namespace internal {
int RunProgram(int argc, char** argv, const Program& program, google::protobuf::Message& config,
               const std::function<const config::v1::RuntimeConfig&()>& runtime,
               const std::function<void(ConfigChecker&)>& check, const std::function<absl::Status(Worker&)>& assemble);
}  // namespace internal

// The whole main of a program: reads the config file that is its one argument, calls
//   absl::Status assemble(const Config&, Worker&)
// serves until SIGTERM or SIGINT, then stops in order; a second signal ends it at once. `check`, when given, is
//   void check(const Config&, ConfigChecker&)
// and reports bad fields of the program's own. Exit codes: 0 stopped when told to, 1 could not serve, 2 bad arguments
// or config.
template <typename Config, typename Assemble, typename Check>
int Run(int argc, char** argv, const Program& program, const Assemble& assemble, const Check& check) {
  Config config;
  return internal::RunProgram(
      argc, argv, program, config, [&]() -> const config::v1::RuntimeConfig& { return config.runtime(); },
      [&](ConfigChecker& checker) { check(config, checker); },
      [&](Worker& worker) -> absl::Status { return assemble(config, worker); });
}

template <typename Config, typename Assemble>
int Run(int argc, char** argv, const Program& program, const Assemble& assemble) {
  return Run<Config>(argc, argv, program, assemble, [](const Config&, ConfigChecker&) {});
}

}  // namespace flair::runtime
