// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/support/client_interceptor.h>

#include <memory>
#include <string>
#include <vector>

namespace flair::runtime {

// For a channel: sends "authorization: Bearer TOKEN" with every call. gRPC's own way asks for TLS, also to one's own
// machine.
std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> SendBearerToken(
    const std::string& token);

}  // namespace flair::runtime
