// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/json_messages.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/type_resolver.h>
#include <google/protobuf/util/type_resolver_util.h>
#include <grpcpp/support/proto_buffer_reader.h>
#include <grpcpp/support/slice.h>

#include <memory>

#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

namespace util = google::protobuf::util;

constexpr char kPrefix[] = "type.googleapis.com";
// Of what was sent, in a message about it.
constexpr size_t kQuotedBytes = 300;

util::TypeResolver* Types() {
  static util::TypeResolver* const types =
      util::NewTypeResolverForDescriptorPool(kPrefix, google::protobuf::DescriptorPool::generated_pool());
  return types;
}

std::string UrlOf(const std::string& type) { return fmt::format("{}/{}", kPrefix, type); }

// Without the picture of the place that follows after a line break.
std::string Shortened(std::string_view message) {
  message = message.substr(0, message.find('\n'));
  while (message.starts_with(": ")) message.remove_prefix(2);
  if (message.size() <= kQuotedBytes) return std::string(message);
  return std::string(message.substr(0, kQuotedBytes)) + "...";
}

// Takes the text: it may be large.
grpc::ByteBuffer BufferOf(std::string text) {
  auto owned = std::make_unique<std::string>(std::move(text));
  const grpc::Slice slice(
      owned->data(), owned->size(), [](void* kept) { delete static_cast<std::string*>(kept); }, owned.get());
  (void)owned.release();
  return grpc::ByteBuffer(&slice, 1);
}

}  // namespace

absl::StatusOr<grpc::ByteBuffer> BytesFromJson(const std::string& type, std::string_view json) {
  google::protobuf::io::ArrayInputStream input(json.data(), static_cast<int>(json.size()));
  std::string bytes;
  google::protobuf::io::StringOutputStream output(&bytes);
  const auto status = util::JsonToBinaryStream(Types(), UrlOf(type), &input, &output);
  if (!status.ok()) {
    return InvalidArgument("the request is no {}: {}", type,
                           Shortened({status.message().data(), status.message().size()}));
  }
  return BufferOf(std::move(bytes));
}

absl::StatusOr<std::string> JsonFromBytes(const std::string& type, grpc::ByteBuffer& bytes) {
  std::string json;
  util::JsonPrintOptions options;
  google::protobuf::io::StringOutputStream output(&json);
  util::Status status;
  {
    grpc::ProtoBufferReader input(&bytes);
    status = util::BinaryToJsonStream(Types(), UrlOf(type), &input, &output, options);
  }
  bytes.Clear();
  if (!status.ok()) {
    return Internal("the answer is no {}: {}", type, Shortened({status.message().data(), status.message().size()}));
  }
  return json;
}

}  // namespace flair::studio
