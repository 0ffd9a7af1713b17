// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/client_interceptor.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// How the two ends of a connection know each other: certificates and tokens.

// Credentials of TLS, of 1.2 and later. The files are read again within seconds of a change, for connections made from
// then on; one that cannot be used then leaves the former in force. INVALID_ARGUMENT names field and file
// (CheckTlsFiles).

// Needs certificate and key; with require_client_certificate, the authority too.
absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> MakeServerCredentials(const config::v1::TlsConfig& tls);

// Without an authority, the machine's own are believed. With certificate and key, shows them to servers that ask. The
// server's certificate must name the host that is called. Equal configs share credentials.
absl::StatusOr<std::shared_ptr<grpc::ChannelCredentials>> MakeChannelCredentials(const config::v1::TlsConfig& tls);

// For a channel: sends "authorization: Bearer TOKEN" with every call. gRPC's own way asks for TLS, also to one's own
// machine.
std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> SendBearerToken(
    const std::string& token);

// The call's metadata "authorization"; nullopt when there is none or more than one. Lives as long as the context.
inline std::optional<std::string_view> AuthorizationOf(const grpc::CallbackServerContext& context) {
  const auto& metadata = context.client_metadata();
  const auto [first, end] = metadata.equal_range("authorization");
  if (first == end || std::next(first) != end) return std::nullopt;
  return std::string_view(first->second.data(), first->second.size());
}

}  // namespace flair::runtime
