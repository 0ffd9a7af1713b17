// SPDX-License-Identifier: GPL-3.0-or-later
// Package flair.v1 as the .proto files of this build have it, with their comments, for a terminal; page.py makes
// docs/protocol.md of the same.
#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace flair::cli {

// Every service with its calls, every other name with the first sentence about it.
std::string ProtocolOverview();

// One service, call, message or enum in full, by its name in any case. NOT_FOUND names what there is.
absl::StatusOr<std::string> ProtocolEntryText(std::string_view name);

}  // namespace flair::cli
