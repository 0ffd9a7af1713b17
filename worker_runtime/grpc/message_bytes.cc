// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::internal::WireFormatLite;

// What a message may take: some in any case, then so many times its bytes; of large ones hardly more than they are.
constexpr int64_t kAnyMessageBytes = 8 << 20;
constexpr int64_t kBytesPerByte = 16;
constexpr int64_t kLargeMessageBytes = 120 << 20;
// Of what is allocated for each: about, and not too little for fields that the message does not know.
constexpr int64_t kScalarBytes = 16;
constexpr int64_t kObjectBytes = 48;
constexpr int64_t kPackedBytes = 8;
constexpr int kNestingLimit = 100;

// Goes through the fields of a message without making anything, and counts down what each would take.
class Unfolding {
 public:
  Unfolding(google::protobuf::io::CodedInputStream& in, int64_t left) : in_(in), left_(left) {}

  // False when more is taken than is left. Stops at what is no field: so will the parser.
  bool Fits(const Descriptor& type, int nesting = 0) {
    while (const uint32_t tag = left_ > 0 ? in_.ReadTag() : 0) {
      if (WireFormatLite::GetTagWireType(tag) != WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
        left_ -= kScalarBytes;
        if (!SkipScalar(tag)) break;
        continue;
      }
      uint32_t length = 0;
      if (!in_.ReadVarint32(&length)) break;
      const FieldDescriptor* field = type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
      left_ -= kObjectBytes;
      if (field != nullptr && field->message_type() != nullptr && nesting < kNestingLimit) {
        const Descriptor& inner = *field->message_type();
        left_ -= static_cast<int64_t>(
            google::protobuf::MessageFactory::generated_factory()->GetPrototype(&inner)->SpaceUsedLong());
        const auto limit = in_.PushLimit(static_cast<int>(length));
        if (!Fits(inner, nesting + 1)) return false;
        if (in_.BytesUntilLimit() > 0) break;
        in_.PopLimit(limit);
      } else {
        left_ -= length * (field != nullptr && field->is_packable() ? kPackedBytes : 1);
        if (!in_.Skip(static_cast<int>(length))) break;
      }
    }
    return left_ > 0;
  }

 private:
  bool SkipScalar(uint32_t tag) {
    uint64_t value = 0;
    switch (WireFormatLite::GetTagWireType(tag)) {
      case WireFormatLite::WIRETYPE_VARINT:
        return in_.ReadVarint64(&value);
      case WireFormatLite::WIRETYPE_FIXED64:
        return in_.Skip(8);
      case WireFormatLite::WIRETYPE_FIXED32:
        return in_.Skip(4);
      default:
        // The two ends of a group: an object, which only a stranger's message has.
        left_ -= kObjectBytes;
        return true;
    }
  }

  google::protobuf::io::CodedInputStream& in_;
  int64_t left_;
};

}  // namespace

absl::Status ParseMessage(grpc::ByteBuffer& bytes, google::protobuf::Message& message) {
  const auto size = static_cast<int64_t>(bytes.Length());
  const int64_t limit = kAnyMessageBytes + std::min(kBytesPerByte * size, kLargeMessageBytes + 2 * size);
  const std::string name = message.GetDescriptor()->name();
  {
    grpc::ProtoBufferReader reader(&bytes);
    google::protobuf::io::CodedInputStream in(&reader);
    if (!Unfolding(in, limit).Fits(*message.GetDescriptor())) {
      return InvalidArgument("{}: {} bytes that would take more than {} MiB of memory; send fewer fields at once", name,
                             size, limit >> 20);
    }
  }
  grpc::ProtoBufferReader reader(&bytes);
  const bool parsed = reader.status().ok() && message.ParseFromZeroCopyStream(&reader);
  bytes.Clear();
  return parsed ? absl::OkStatus() : InvalidArgument("these bytes are no {}", name);
}

}  // namespace flair::runtime
