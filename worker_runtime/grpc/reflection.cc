// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include <set>
#include <utility>

#include "grpc/reflection/v1alpha/reflection.pb.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/server.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::runtime {
namespace {

using google::protobuf::FileDescriptor;
using grpc::reflection::v1alpha::ServerReflectionRequest;
using grpc::reflection::v1alpha::ServerReflectionResponse;

constexpr char kName[] = "grpc.reflection.v1alpha.ServerReflection";
constexpr char kPath[] = "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo";

// The file behind those that it needs.
void AddFiles(const FileDescriptor& file, std::set<const FileDescriptor*>& added, ServerReflectionResponse& answer) {
  if (!added.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) AddFiles(*file.dependency(i), added, answer);
  google::protobuf::FileDescriptorProto proto;
  file.CopyTo(&proto);
  proto.SerializeToString(answer.mutable_file_descriptor_response()->add_file_descriptor_proto());
}

ServerReflectionResponse Answer(const ServerReflectionRequest& question, const std::vector<std::string>& services) {
  ServerReflectionResponse answer;
  if (question.has_list_services()) {
    for (const std::string& service : services) {
      answer.mutable_list_services_response()->add_service()->set_name(service);
    }
    return answer;
  }
  const auto& pool = *google::protobuf::DescriptorPool::generated_pool();
  const std::string& name =
      question.has_file_by_filename() ? question.file_by_filename() : question.file_containing_symbol();
  std::set<const FileDescriptor*> added;
  if (const FileDescriptor* file =
          question.has_file_by_filename() ? pool.FindFileByName(name) : pool.FindFileContainingSymbol(name)) {
    AddFiles(*file, added, answer);
  } else {
    answer.mutable_error_response()->set_error_code(grpc::StatusCode::NOT_FOUND);
    answer.mutable_error_response()->set_error_message("not found: " + name);
  }
  return answer;
}

class Stream final : public grpc::ServerBidiReactor<grpc::ByteBuffer, ServerReflectionResponse> {
 public:
  explicit Stream(const std::vector<std::string>& services) : services_(services) { StartRead(&question_); }

 private:
  void OnReadDone(bool ok) override {
    if (!ok) return Finish(grpc::Status::OK);
    ServerReflectionRequest question;
    if (const absl::Status parsed = ParseShortMessage(question_, question); !parsed.ok()) {
      return Finish(ToGrpcStatus(parsed));
    }
    answer_ = Answer(question, services_);
    StartWrite(&answer_);
  }
  void OnWriteDone(bool ok) override {
    if (!ok) return Finish(grpc::Status::CANCELLED);
    StartRead(&question_);
  }
  void OnDone() override { delete this; }

  const std::vector<std::string>& services_;
  grpc::ByteBuffer question_;
  ServerReflectionResponse answer_;
};

class Reflection final : public grpc::Service {
 public:
  explicit Reflection(std::vector<std::string> services) : services_(std::move(services)) {
    services_.emplace_back(kName);
    using grpc::internal::RpcMethod;
    AddMethod(new grpc::internal::RpcServiceMethod(kPath, RpcMethod::BIDI_STREAMING, nullptr));
    using Handler = grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, ServerReflectionResponse>;
    MarkMethodRawCallback(0, new Handler([this](grpc::CallbackServerContext*) { return new Stream(services_); }));
  }

 private:
  std::vector<std::string> services_;
};

}  // namespace

std::unique_ptr<grpc::Service> MakeReflectionService(std::vector<std::string> service_names) {
  return std::make_unique<Reflection>(std::move(service_names));
}

}  // namespace flair::runtime
