// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that people write as protobuf text.
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "absl/status/status.h"

namespace flair::cli {

// Fills `message` from the file. Errors begin with `flag`, such as "--options", and the path: NOT_FOUND and
// FAILED_PRECONDITION as ReadFile, INVALID_ARGUMENT with line, column and `example`, what would be right.
absl::Status ReadTextMessage(const std::string& flag, const std::string& path, const std::string& example,
                             google::protobuf::Message& message);

}  // namespace flair::cli
