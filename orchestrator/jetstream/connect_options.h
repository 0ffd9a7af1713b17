// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/config/v1/runtime_config.pb.h"

typedef struct __natsOptions natsOptions;

namespace flair::orchestrator {

struct NatsOptionsDeleter {
  void operator()(natsOptions* options) const;
};
using NatsOptionsPtr = std::unique_ptr<natsOptions, NatsOptionsDeleter>;

// The servers for people, logs and errors: without a user, password or token that their addresses may hold.
std::string ShownAddress(const config::v1::QueueConfig& config);

// INVALID_ARGUMENT naming the field whose value cannot be used.
absl::Status CheckQueueConfig(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls);

// How to connect: the servers of a checked config, their certificates and ours, for ever. INVALID_ARGUMENT when a file
// cannot be used.
absl::StatusOr<NatsOptionsPtr> MakeConnectOptions(const config::v1::QueueConfig& config,
                                                  const config::v1::TlsConfig* tls);

// Why a first connection failed (`status`: a natsStatus, on the thread that got it), in a sentence that names the field
// to look at: UNAUTHENTICATED when one side does not believe the other, else UNAVAILABLE. Holds no secret. `tls` as for
// MakeConnectOptions.
absl::Status DescribeConnectError(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls, int status);

}  // namespace flair::orchestrator
