// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol for a terminal.
#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace flair::cli {

// Every service with its calls, every other name with the first sentence about it.
std::string ProtocolOverview();

// One service, call, message or enum in full. NOT_FOUND names what there is.
absl::StatusOr<std::string> ProtocolEntryText(std::string_view name);

}  // namespace flair::cli
