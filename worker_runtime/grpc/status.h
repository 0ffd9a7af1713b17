// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/support/status.h>

#include "absl/status/status.h"

namespace flair::runtime {

// The same code and message on the other side, but what gRPC itself says of connections in plain words (InPlainWords).
grpc::Status ToGrpcStatus(const absl::Status& status);
absl::Status FromGrpcStatus(const grpc::Status& status);

}  // namespace flair::runtime
