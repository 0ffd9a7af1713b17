// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/channel.h"

#include <fmt/format.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/support/channel_arguments.h>

#include <charconv>

namespace flair::runtime {
namespace {

bool EndsInPort(const std::string& address) {
  const size_t colon = address.rfind(':');
  if (colon == std::string::npos || colon == 0) return false;
  int port = 0;
  const char* end = address.data() + address.size();
  const auto [rest, error] = std::from_chars(address.data() + colon + 1, end, port);
  return error == std::errc() && rest == end && port >= 1 && port <= 65535;
}

}  // namespace

int MaxMessageBytes(int max_message_mib) { return (max_message_mib > 0 ? max_message_mib : 32) * 1024 * 1024; }

absl::StatusOr<std::shared_ptr<grpc::Channel>> MakeChannel(const std::string& address, const std::string& service,
                                                           int max_message_mib) {
  const bool unix_socket = address.starts_with("unix:") && address.size() > 5;
  if (!unix_socket && !EndsInPort(address)) {
    return absl::InvalidArgumentError(fmt::format(
        "address \"{}\": expected HOST:PORT, unix:PATH or dns:///NAME:PORT with a port in [1, 65535]", address));
  }
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(MaxMessageBytes(max_message_mib));
  arguments.SetMaxSendMessageSize(MaxMessageBytes(max_message_mib));
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 200);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 200);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 2000);
  // Retrying is the caller's: see orchestrator/pipeline/backoff_policy.h.
  arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  if (address.starts_with("dns:")) {
    // No timeout in here, ever: gRPC 1.51 then ends calls too early. Deadlines are set per call.
    arguments.SetServiceConfigJSON(fmt::format(
        R"({{"loadBalancingConfig":[{{"round_robin":{{}}}}],"healthCheckConfig":{{"serviceName":"{}"}}}})", service));
  }
  return grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments);
}

}  // namespace flair::runtime
