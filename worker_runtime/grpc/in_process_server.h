// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/server.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {

// One service with its own resources, reached without a port: what a worker program is, inside another program.
//   auto optimizer = runtime::InProcessServer::Start("flair-optimizer", runtime_config,
//       v1::OptimizerService::service_full_name(),
//       [&](runtime::WorkerContext& context) { return optimizer::MakeOptimizerService(config, context); });
//   channels.optimizer = (*optimizer)->channel();
// Destroy the clients before the servers, and a server before those that its service calls... in short: in the reverse
// order of making them.
class InProcessServer {
 public:
  // `make` is called once with the context and returns absl::StatusOr<std::unique_ptr<grpc::Service>>.
  template <typename MakeService>
  static absl::StatusOr<std::unique_ptr<InProcessServer>> Start(const std::string& program,
                                                                const config::v1::RuntimeConfig& config,
                                                                const std::string& service_name,
                                                                const MakeService& make) {
    std::unique_ptr<InProcessServer> result(new InProcessServer(program, config));
    ASSIGN_OR_RETURN(std::unique_ptr<grpc::Service> service, make(result->resources_.context()));
    std::vector<NamedService> services;
    services.push_back({service_name, std::move(service)});
    ASSIGN_OR_RETURN(result->server_,
                     Server::Start({.program = program,
                                    .revision = result->resources_.context().revision,
                                    .build = result->resources_.context().build,
                                    .capabilities = result->resources_.context().capabilities,
                                    .configuration_digest = ConfigurationDigest(result->resources_.context()),
                                    .listen_address = "",
                                    .max_message_mib = config.max_message_mib()},
                                   std::move(services)));
    return result;
  }

  std::shared_ptr<grpc::Channel> channel() { return server_->InProcessChannel(); }

 private:
  InProcessServer(const std::string& program, const config::v1::RuntimeConfig& config) : resources_(program, config) {}

  // The order matters: the server stops before the resources go.
  WorkerResources resources_;
  std::unique_ptr<Server> server_;
};

}  // namespace flair::runtime
