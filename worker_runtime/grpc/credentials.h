// SPDX-License-Identifier: GPL-3.0-or-later
// How the two ends of a connection know each other: certificates and tokens.
#pragma once

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
