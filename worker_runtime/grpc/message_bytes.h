// SPDX-License-Identifier: GPL-3.0-or-later
// Messages between their bytes and what they unfold to.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/byte_buffer.h>

#include "absl/status/status.h"

namespace flair::runtime {

// Parses `bytes` and lets go of them. INVALID_ARGUMENT for what is no such message, and for a small one that would take
// much memory, such as millions of empty fields: nothing of it is made then.
absl::Status ParseMessage(grpc::ByteBuffer& bytes, google::protobuf::Message& message);

template <typename Message>
grpc::ByteBuffer BytesOf(const Message& message) {
  grpc::ByteBuffer bytes;
  bool own = false;
  (void)grpc::SerializationTraits<Message>::Serialize(message, &bytes, &own);
  return bytes;
}

}  // namespace flair::runtime
