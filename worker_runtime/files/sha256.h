// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message_lite.h>

#include <string>
#include <string_view>

namespace flair::runtime {

// SHA-256 in lower-case hex, 64 characters.
std::string Sha256Hex(std::string_view bytes);

// The bytes of a message, the same in every program: known fields in number order, no map in any of our messages.
std::string CanonicalBytes(const google::protobuf::MessageLite& message);

}  // namespace flair::runtime
