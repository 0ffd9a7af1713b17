// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of the protobuf mapping, to and from the bytes of messages of types that are linked into the program.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace flair::studio {

// INVALID_ARGUMENT says where and what is wrong: no JSON, a field that there is not, a value of another type, more than
// a hundred objects within each other.
absl::StatusOr<grpc::ByteBuffer> BytesFromJson(const std::string& type, std::string_view json);

// INTERNAL when the bytes are no such message. Empties the buffer.
absl::StatusOr<std::string> JsonFromBytes(const std::string& type, grpc::ByteBuffer& bytes);

}  // namespace flair::studio
