// SPDX-License-Identifier: GPL-3.0-or-later
// Clients of the two services that gRPC itself defines. Flair has no classes for their messages: a field or two of each
// is all that is needed, and is read and written by number.
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "cli/contract/target.h"

namespace flair::contract {

// HealthCheckResponse.ServingStatus.
enum class Health : int { kUnknown = 0, kServing = 1, kNotServing = 2, kServiceUnknown = 3 };

// "SERVING" and so on.
const char* HealthName(Health health);

// grpc.health.v1.Health/Check of a service's full name; "" for the whole server. UNIMPLEMENTED when there is no such
// service, NOT_FOUND when it does not know the name.
absl::StatusOr<Health> HealthOf(const std::shared_ptr<grpc::Channel>& channel, const std::string& service,
                                absl::Duration within);

// Full names of the services that reflection lists. UNIMPLEMENTED when there is no reflection.
absl::StatusOr<std::vector<std::string>> ReflectedServices(const Target& target, absl::Duration within);

}  // namespace flair::contract
