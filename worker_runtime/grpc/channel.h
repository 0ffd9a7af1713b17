// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/runtime_config.pb.h"

namespace flair::runtime {

// Options of a channel to a server.
struct ChannelOptions {
  // Largest message, MiB; 32 when 0.
  int max_message_mib = 0;
  // Trusted authorities and our own certificate (MakeChannelCredentials). Unset: plain text.
  std::optional<config::v1::TlsConfig> tls;
  // Sent with every call, as "authorization: Bearer TOKEN".
  std::string token = "";
  // Allows plain text, token included, to other machines.
  bool allow_insecure = false;
  // The name in the server's certificate, if it is not the host of the address.
  std::string server_name = "";
  // Watches the server's health: the channel is not READY while the server reports NOT_SERVING, for example because it
  // is stopping. Always on for "dns:///".
  bool only_while_serving = false;
};

// The options that a program's config sets for its calls.
ChannelOptions ChannelOptionsOf(const config::v1::RuntimeConfig& runtime);

// A channel to "HOST:PORT", "unix:PATH" or "dns:///NAME:PORT"; the last spreads calls over all healthy addresses that
// serve `service` (full name, such as "flair.v1.OptimizerService"). Returns at once, connects on first use.
// INVALID_ARGUMENT when the address has no such form, when it would be plain text to another machine, or for the files
// of TLS.
absl::StatusOr<std::shared_ptr<grpc::Channel>> MakeChannel(const std::string& address, const std::string& service,
                                                           const ChannelOptions& options = {});

// Largest message in bytes for a config's max_message_mib.
int MaxMessageBytes(int max_message_mib);

}  // namespace flair::runtime
