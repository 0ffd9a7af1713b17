// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/common_services.h"

#include <google/protobuf/unknown_field_set.h>
#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/generic_stub.h>

#include "absl/time/clock.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

using google::protobuf::UnknownField;
using google::protobuf::UnknownFieldSet;

// Field numbers of grpc/health/v1/health.proto and grpc/reflection/v1/reflection.proto.
constexpr int kHealthService = 1;
constexpr int kHealthStatus = 1;
constexpr int kListServices = 7;
constexpr int kListServicesResponse = 6;
constexpr int kService = 1;
constexpr int kName = 1;

std::string Encoded(int number, const std::string& text) {
  UnknownFieldSet fields;
  fields.AddLengthDelimited(number, text);
  std::string bytes;
  fields.SerializeToString(&bytes);
  return bytes;
}

// The contents of all fields of this number that hold bytes.
std::vector<std::string> BytesAt(const std::string& bytes, int number) {
  std::vector<std::string> found;
  UnknownFieldSet fields;
  if (!fields.ParseFromString(bytes)) return found;
  for (int i = 0; i < fields.field_count(); ++i) {
    const UnknownField& field = fields.field(i);
    if (field.number() == number && field.type() == UnknownField::TYPE_LENGTH_DELIMITED) {
      found.push_back(field.length_delimited());
    }
  }
  return found;
}

// One message to a stream and one back, step by step. Every step ends when the deadline has passed.
class Exchange {
 public:
  Exchange(const std::shared_ptr<grpc::Channel>& channel, const std::string& path, absl::Duration within)
      : stub_(channel) {
    context_.set_deadline(absl::ToChronoTime(absl::Now() + within));
    stream_ = stub_.PrepareCall(&context_, path, &queue_);
    stream_->StartCall(nullptr);
    Step();
  }
  ~Exchange() {
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  absl::StatusOr<std::string> Run(const std::string& request) {
    const grpc::Slice slice(request);
    stream_->Write(grpc::ByteBuffer(&slice, 1), nullptr);
    Step();
    grpc::ByteBuffer buffer;
    stream_->Read(&buffer, nullptr);
    const bool answered = Step();
    if (answered) context_.TryCancel();
    grpc::Status status;
    stream_->Finish(&status, nullptr);
    Step();
    grpc::Slice answer;
    if (answered && buffer.DumpToSingleSlice(&answer).ok()) {
      return std::string(reinterpret_cast<const char*>(answer.begin()), answer.size());
    }
    return status.ok() ? absl::DataLossError("the stream ended without an answer") : runtime::FromGrpcStatus(status);
  }

 private:
  bool Step() {
    void* tag = nullptr;
    bool ok = false;
    return queue_.Next(&tag, &ok) && ok;
  }

  grpc::GenericStub stub_;
  grpc::ClientContext context_;
  grpc::CompletionQueue queue_;
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> stream_;
};

}  // namespace

const char* HealthName(Health health) {
  switch (health) {
    case Health::kServing:
      return "SERVING";
    case Health::kNotServing:
      return "NOT_SERVING";
    case Health::kServiceUnknown:
      return "SERVICE_UNKNOWN";
    default:
      return "UNKNOWN";
  }
}

absl::StatusOr<Health> HealthOf(const std::shared_ptr<grpc::Channel>& channel, const std::string& service,
                                absl::Duration within) {
  const absl::StatusOr<std::string> bytes =
      Call(channel, "/grpc.health.v1.Health/Check", Encoded(kHealthService, service), absl::Now() + within).Wait();
  if (!bytes.ok()) return bytes.status();
  UnknownFieldSet fields;
  if (!fields.ParseFromString(*bytes)) return absl::DataLossError("the answer is no HealthCheckResponse");
  Health health = Health::kUnknown;
  for (int i = 0; i < fields.field_count(); ++i) {
    if (fields.field(i).number() == kHealthStatus && fields.field(i).type() == UnknownField::TYPE_VARINT) {
      health = static_cast<Health>(fields.field(i).varint());
    }
  }
  return health;
}

absl::StatusOr<std::vector<std::string>> ReflectedServices(const Target& target, absl::Duration within) {
  absl::StatusOr<std::string> bytes = absl::UnimplementedError("no reflection");
  for (const char* version : {"v1alpha", "v1"}) {
    const std::string path = std::string("/grpc.reflection.") + version + ".ServerReflection/ServerReflectionInfo";
    bytes = Exchange(target.channel(), path, within).Run(Encoded(kListServices, "*"));
    if (!absl::IsUnimplemented(bytes.status())) break;
  }
  if (!bytes.ok()) return bytes.status();
  std::vector<std::string> names;
  for (const std::string& list : BytesAt(*bytes, kListServicesResponse)) {
    for (const std::string& service : BytesAt(list, kService)) {
      for (const std::string& name : BytesAt(service, kName)) names.push_back(name);
    }
  }
  return names;
}

}  // namespace flair::contract
