// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace flair::runtime {

// A channel to "HOST:PORT", "unix:PATH" or "dns:///NAME:PORT"; the last spreads calls over all healthy addresses that
// serve `service` (full name, such as "flair.v1.OptimizerService"). Returns at once, connects on first use.
// INVALID_ARGUMENT when the address has no such form.
absl::StatusOr<std::shared_ptr<grpc::Channel>> MakeChannel(const std::string& address, const std::string& service,
                                                           int max_message_mib = 0);

// Largest message in bytes for a config's max_message_mib.
int MaxMessageBytes(int max_message_mib);

}  // namespace flair::runtime
