// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/status.h"

namespace flair::cli {

// What a command that got `status` from the orchestrator at `address` ends with: when nobody answered there or not in
// time, UNAVAILABLE with the address, why, and what to do; `status` itself otherwise.
absl::Status NoOrchestrator(const absl::Status& status, const std::string& address);

}  // namespace flair::cli
