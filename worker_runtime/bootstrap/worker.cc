// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/worker.h"

#include <cstdio>

namespace flair::runtime {

absl::Status Worker::Start() {
  const std::string listen = config_.listen_address().empty() ? "127.0.0.1:0" : config_.listen_address();
  auto server = Server::Start({.program = resources_.program(),
                               .revision = context().revision,
                               .build = context().build,
                               .capabilities = context().capabilities,
                               .configuration_digest = ConfigurationDigest(context()),
                               .listen_address = listen,
                               .max_message_mib = config_.max_message_mib()},
                              std::move(services_));
  if (!server.ok()) return server.status();
  server_ = *std::move(server);
  std::printf("listening on %s\n", server_->address().c_str());
  std::fflush(stdout);
  context().logger->info("listening on {}, build {}", server_->address(), context().build);
  return absl::OkStatus();
}

void Worker::Stop() {
  if (server_ == nullptr) return;
  const double drain_seconds = config_.has_drain_seconds() ? config_.drain_seconds() : 10.0;
  context().logger->info("stopping; running calls have {} s", drain_seconds);
  for (const auto& callback : stop_callbacks_) callback();
  server_->Shutdown(absl::Seconds(drain_seconds));
  server_.reset();
  context().logger->info("stopped");
}

}  // namespace flair::runtime
