// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/status.h"

#include <string>

#include "worker_runtime/grpc/connection_trouble.h"

namespace flair::runtime {

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  return grpc::Status(static_cast<grpc::StatusCode>(status.code()), std::string(status.message()));
}

absl::Status FromGrpcStatus(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  return absl::Status(static_cast<absl::StatusCode>(status.error_code()), InPlainWords(status.error_message()));
}

}  // namespace flair::runtime
