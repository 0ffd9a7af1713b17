// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>

#include <memory>

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

}  // namespace flair::runtime
