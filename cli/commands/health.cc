// SPDX-License-Identifier: GPL-3.0-or-later
// flair health: asks a server whether it serves, for people, containers and their orchestrators.

#include "cli/commands/commands.h"
#include "cli/contract/target.h"
#include "cli/input/service_flags.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct HealthArguments : Options {
  using Options::Options;
  std::string& address = Required("ADDRESS", "The server, HOST:PORT or unix:PATH");
  std::string& service =
      Text("--service", "One service of it in full, such as flair.v1.OptimizerService; otherwise the whole server");
  double& patience_s = Decimal("--patience S", 0.1, 600, 3, "Seconds to wait for an answer, 0.1 to 600 (3)");
};

absl::Status Health(const HealthArguments& arguments) {
  ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
  ASSIGN_OR_RETURN(const auto channel, runtime::MakeChannel(arguments.address, arguments.service, options));
  const std::string what =
      arguments.service.empty() ? arguments.address : fmt::format("{} at {}", arguments.service, arguments.address);
  const auto health = contract::HealthOf(channel, arguments.service, absl::Seconds(arguments.patience_s));
  if (absl::IsNotFound(health.status())) {
    return absl::NotFoundError(
        fmt::format("{}: the server there has no such service; is this another stage's port?", what));
  }
  if (!health.ok()) {
    return absl::Status(health.status().code(), fmt::format("{}: {}", what, std::string(health.status().message())));
  }
  if (*health != "SERVING") return absl::UnavailableError(fmt::format("{}: {}", what, *health));
  fmt::print("{}: {}\n", what, *health);
  return absl::OkStatus();
}

}  // namespace

void AddHealth(const Commands& program) {
  program.Add("health", "Ask whether a server is serving, by the gRPC health protocol.", Health,
              "Exits with 0 when it serves, with 3 when it does not or cannot be reached, with 2 when it has no such "
              "service. Any gRPC server that has grpc.health.v1.Health can be asked. Made for health checks: reads "
              "no files, quick.");
}

}  // namespace flair::cli
