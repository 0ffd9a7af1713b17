// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/proto_buffer_reader.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <set>
#include <utility>

#include "worker_runtime/grpc/server.h"

namespace flair::runtime {
namespace {

using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptor;
using google::protobuf::internal::WireFormatLite;

constexpr char kName[] = "grpc.reflection.v1alpha.ServerReflection";
constexpr char kPath[] = "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo";
constexpr uint32_t kLongestName = 1024;

// Fields of the protocol's messages; these few are written and read by hand.
constexpr int kFileByName = 3;
constexpr int kFileOfSymbol = 4;
constexpr int kListServices = 7;
constexpr int kFilesAnswer = 4;
constexpr int kServicesAnswer = 6;
constexpr int kErrorAnswer = 7;

std::string Field(int number, const std::string& bytes) {
  std::string field;
  google::protobuf::io::StringOutputStream stream(&field);
  google::protobuf::io::CodedOutputStream out(&stream);
  WireFormatLite::WriteBytes(number, bytes, &out);
  out.Trim();
  return field;
}

// What is asked, and of which name.
std::pair<int, std::string> ReadQuestion(grpc::ByteBuffer& bytes) {
  std::pair<int, std::string> question;
  grpc::ProtoBufferReader reader(&bytes);
  google::protobuf::io::CodedInputStream in(&reader);
  while (const uint32_t tag = in.ReadTag()) {
    uint32_t length = 0;
    const int number = WireFormatLite::GetTagFieldNumber(tag);
    const bool is_text = WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
    if (is_text && number >= kFileByName && number <= kListServices) {
      question.first = number;
      if (!in.ReadVarint32(&length) || length > kLongestName ||
          !in.ReadString(&question.second, static_cast<int>(length))) {
        break;
      }
    } else if (!WireFormatLite::SkipField(&in, tag)) {
      break;
    }
  }
  return question;
}

// The file behind those that it needs.
void AddFiles(const FileDescriptor& file, std::set<const FileDescriptor*>& added, std::string& files) {
  if (!added.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) AddFiles(*file.dependency(i), added, files);
  google::protobuf::FileDescriptorProto proto;
  file.CopyTo(&proto);
  files += Field(1, proto.SerializeAsString());
}

std::string Answer(const std::pair<int, std::string>& question, const std::vector<std::string>& services) {
  const auto& [asked, name] = question;
  std::string answer;
  if (asked == kListServices) {
    for (const std::string& service : services) answer += Field(1, Field(1, service));
    return Field(kServicesAnswer, answer);
  }
  const DescriptorPool& pool = *DescriptorPool::generated_pool();
  const FileDescriptor* file = asked == kFileByName     ? pool.FindFileByName(name)
                               : asked == kFileOfSymbol ? pool.FindFileContainingSymbol(name)
                                                        : nullptr;
  // NOT_FOUND, 5.
  if (file == nullptr) return Field(kErrorAnswer, "\x08\x05" + Field(2, "not found: " + name));
  std::set<const FileDescriptor*> added;
  AddFiles(*file, added, answer);
  return Field(kFilesAnswer, answer);
}

class Stream final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  explicit Stream(const std::vector<std::string>& services) : services_(services) { StartRead(&question_); }

 private:
  void OnReadDone(bool ok) override {
    if (!ok) return Finish(grpc::Status::OK);
    const grpc::Slice answer(Answer(ReadQuestion(question_), services_));
    question_.Clear();
    answer_ = grpc::ByteBuffer(&answer, 1);
    StartWrite(&answer_);
  }
  void OnWriteDone(bool ok) override {
    if (!ok) return Finish(grpc::Status::CANCELLED);
    StartRead(&question_);
  }
  void OnDone() override { delete this; }

  const std::vector<std::string>& services_;
  grpc::ByteBuffer question_;
  grpc::ByteBuffer answer_;
};

class Reflection final : public grpc::Service {
 public:
  explicit Reflection(std::vector<std::string> services) : services_(std::move(services)) {
    services_.emplace_back(kName);
    using grpc::internal::RpcMethod;
    AddMethod(new grpc::internal::RpcServiceMethod(kPath, RpcMethod::BIDI_STREAMING, nullptr));
    using Handler = grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, grpc::ByteBuffer>;
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
