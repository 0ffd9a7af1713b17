// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "absl/status/status.h"

namespace flair::cli {

// Fills `message` from proto JSON, field names as in the .proto files or in camel case. INVALID_ARGUMENT as
// ParseMessageText, in words of ours where protobuf's name its types.
absl::Status ParseJsonMessage(const std::string& name, const std::string& json, google::protobuf::Message& message);

}  // namespace flair::cli
