// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/config/v1/runtime_config.pb.h"

namespace flair::orchestrator {

// Why a first connection failed (`status`: a natsStatus, on the thread that got it), in a sentence that names the field
// to look at: UNAUTHENTICATED when one side does not believe the other, else UNAVAILABLE. Holds no secret. `tls` as for
// MakeConnectOptions.
absl::Status DescribeConnectError(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls, int status);

}  // namespace flair::orchestrator
