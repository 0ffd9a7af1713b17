// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>
#include <string>
#include <vector>

namespace flair::runtime {

// Serves grpc.reflection.v1alpha.ServerReflection, by which tools learn the services of these names and their messages.
// gRPC's own makes of a message whatever it is sent: gigabytes of 30 MiB.
std::unique_ptr<grpc::Service> MakeReflectionService(std::vector<std::string> service_names);

}  // namespace flair::runtime
