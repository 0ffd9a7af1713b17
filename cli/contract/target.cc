// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/target.h"

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/generic_stub.h>

#include <algorithm>
#include <random>
#include <utility>

#include "absl/time/clock.h"
#include "grpc/health/v1/health.pb.h"
#include "grpc/reflection/v1alpha/reflection.pb.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

constexpr absl::Duration kConnectWithin = absl::Seconds(10);
// Answers may be larger than what the server takes, and so must be what is sent to see whether it refuses.
constexpr int kSpareMib = 16;
constexpr char kGetWorker[] = "/flair.v1.WorkerService/GetWorker";

grpc::ByteBuffer ToBuffer(const std::string& bytes) {
  const grpc::Slice slice(bytes);
  return grpc::ByteBuffer(&slice, 1);
}

std::string ToBytes(const grpc::ByteBuffer& buffer) {
  std::vector<grpc::Slice> slices;
  std::string bytes;
  if (!buffer.Valid() || !buffer.Dump(&slices).ok()) return bytes;
  for (const grpc::Slice& slice : slices) bytes.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
  return bytes;
}

// The steps of a streaming call, one after the other. Every step ends when the deadline has passed.
class SteppedCall {
 public:
  SteppedCall(const std::shared_ptr<grpc::Channel>& channel, const std::string& path, absl::Duration within)
      : stub_(channel) {
    context_.set_deadline(absl::ToChronoTime(absl::Now() + within));
    stream_ = stub_.PrepareCall(&context_, path, &queue_);
    stream_->StartCall(nullptr);
    Step();
  }
  ~SteppedCall() {
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  bool Write(const std::string& bytes) {
    stream_->Write(ToBuffer(bytes), nullptr);
    return Step();
  }
  void WritesDone() {
    stream_->WritesDone(nullptr);
    Step();
  }
  bool Read(std::string& bytes) {
    grpc::ByteBuffer buffer;
    stream_->Read(&buffer, nullptr);
    if (!Step()) return false;
    bytes = ToBytes(buffer);
    return true;
  }
  void Cancel() { context_.TryCancel(); }
  absl::Status Finish() {
    grpc::Status status;
    stream_->Finish(&status, nullptr);
    Step();
    return runtime::FromGrpcStatus(status);
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

struct Call::Parts {
  explicit Parts(const std::shared_ptr<grpc::Channel>& channel) : stub(channel) {}

  grpc::GenericStub stub;
  grpc::ClientContext context;
  grpc::ByteBuffer request;
  grpc::ByteBuffer response;
};

Call::Call(const std::shared_ptr<grpc::Channel>& channel, const std::string& path, const std::string& request,
           absl::Duration within)
    : parts_(std::make_unique<Parts>(channel)) {
  parts_->request = ToBuffer(request);
  parts_->context.set_deadline(absl::ToChronoTime(absl::Now() + within));
  // gRPC's thread may hold the promise a moment longer than the call, and nothing else: a channel that it let go of
  // last would have to end within itself.
  auto end = std::make_shared<std::promise<absl::Status>>();
  end_ = end->get_future().share();
  parts_->stub.UnaryCall(&parts_->context, path, grpc::StubOptions(), &parts_->request, &parts_->response,
                         [end](const grpc::Status& status) { end->set_value(runtime::FromGrpcStatus(status)); });
}

Call::~Call() {
  Cancel();
  end_.wait();
}

void Call::Cancel() { parts_->context.TryCancel(); }

absl::StatusOr<std::string> Call::Wait() {
  RETURN_IF_ERROR(end_.get());
  return ToBytes(parts_->response);
}

bool Call::WaitFor(absl::Duration duration) {
  return end_.wait_for(absl::ToChronoMilliseconds(duration)) == std::future_status::ready;
}

Target::Target(TargetOptions options)
    : options_(std::move(options)),
      run_(fmt::format("contract-{:x}-{:x}", absl::ToUnixMicros(absl::Now()), std::random_device()())) {}

absl::StatusOr<std::unique_ptr<Target>> Target::Connect(const TargetOptions& options) {
  runtime::ChannelOptions connection = options.connection;
  connection.max_message_mib = options.max_message_mib + kSpareMib;
  std::unique_ptr<Target> target(new Target(options));
  ASSIGN_OR_RETURN(target->channel_, runtime::MakeChannel(options.address, options.service, connection));
  const absl::StatusOr<std::string> worker = Call(target->channel_, kGetWorker, "", target->ConnectWithin()).Wait();
  if (absl::IsUnavailable(worker.status()) || absl::IsDeadlineExceeded(worker.status())) {
    return Unavailable("{}: no gRPC server answers there: {}; is it running, and is this its port?", options.address,
                       worker.status().message());
  }
  // Servers of others need not have a WorkerService; what they answer instead is their business.
  if (!worker.ok() || !target->worker_.ParseFromString(*worker)) target->worker_.Clear();
  return target;
}

absl::Duration Target::ConnectWithin() const { return std::min(kConnectWithin, options_.patience); }

bool Target::Claims(v1::Capability capability) const {
  return std::ranges::find(worker_.capabilities(), capability) != worker_.capabilities().end();
}

bool Target::IsReachable() const {
  const absl::Status status = Call(channel_, kGetWorker, "", ConnectWithin()).Wait().status();
  return !absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status);
}

absl::StatusOr<std::string> Target::AskForBytes(const google::protobuf::Message& request) {
  return AskOnce(PathOf(request), request.SerializeAsString());
}

absl::StatusOr<std::string> Target::AskOnce(const std::string& path, const std::string& request) {
  {
    std::lock_guard lock(mutex_);
    if (silent_.contains(path)) {
      return DeadlineExceeded("{} was silent for {} before; it is not asked again", path.substr(path.rfind('/') + 1),
                              absl::FormatDuration(options_.patience));
    }
  }
  absl::StatusOr<std::string> bytes = Call(channel_, path, request, options_.patience).Wait();
  if (absl::IsDeadlineExceeded(bytes.status())) {
    std::lock_guard lock(mutex_);
    silent_.insert(path);
  }
  return bytes;
}

absl::StatusOr<std::vector<std::string>> Target::Exchange(const google::protobuf::MethodDescriptor& method,
                                                          const std::vector<std::string>& requests,
                                                          size_t leave_after) {
  const std::string path = fmt::format("/{}/{}", options_.service, method.name());
  if (method.client_streaming() || method.server_streaming()) return Stream(path, requests, leave_after);
  ASSIGN_OR_RETURN(std::string answer, AskOnce(path, requests.front()));
  return std::vector{std::move(answer)};
}

absl::StatusOr<std::vector<std::string>> Target::Stream(const std::string& path,
                                                        const std::vector<std::string>& requests,
                                                        size_t leave_after) const {
  SteppedCall call(channel_, path, options_.patience);
  bool open = true;
  for (const std::string& request : requests) open = open && call.Write(request);
  if (open) call.WritesDone();
  std::vector<std::string> answers;
  bool left = false;
  for (std::string answer; !left && call.Read(answer);) {
    answers.push_back(std::move(answer));
    left = answers.size() == leave_after;
  }
  if (left) call.Cancel();
  const absl::Status status = call.Finish();
  if (!left && !status.ok()) return status;
  return answers;
}

std::unique_ptr<Call> Target::Start(const google::protobuf::Message& request, absl::Duration within) const {
  return std::make_unique<Call>(channel_, PathOf(request), request.SerializeAsString(), within);
}

absl::StatusOr<std::string> Target::AskAgain(const google::protobuf::Message& request) const {
  return Start(request, options_.patience)->Wait();
}

std::string Target::PathOf(const google::protobuf::Message& request) const {
  const google::protobuf::ServiceDescriptor* const service =
      google::protobuf::DescriptorPool::generated_pool()->FindServiceByName(options_.service);
  for (int i = 0; service != nullptr && i < service->method_count(); ++i) {
    if (service->method(i)->input_type() == request.GetDescriptor()) {
      return fmt::format("/{}/{}", options_.service, service->method(i)->name());
    }
  }
  return "";
}

std::string Target::NewRequestId() {
  std::lock_guard lock(mutex_);
  return fmt::format("{}-{}", run_, ++request_count_);
}

std::string RpcName(const google::protobuf::Message& request) {
  const std::string& name = request.GetDescriptor()->name();
  constexpr std::string_view kEnd = "Request";
  return name.ends_with(kEnd) ? name.substr(0, name.size() - kEnd.size()) : name;
}

absl::StatusOr<std::string> HealthOf(const std::shared_ptr<grpc::Channel>& channel, const std::string& service,
                                     absl::Duration within) {
  grpc::health::v1::HealthCheckRequest request;
  request.set_service(service);
  ASSIGN_OR_RETURN(const std::string bytes,
                   Call(channel, "/grpc.health.v1.Health/Check", request.SerializeAsString(), within).Wait());
  grpc::health::v1::HealthCheckResponse response;
  if (!response.ParseFromString(bytes)) return absl::DataLossError("the answer is no HealthCheckResponse");
  const std::string& name = grpc::health::v1::HealthCheckResponse::ServingStatus_Name(response.status());
  return name.empty() ? "UNKNOWN" : name;
}

absl::StatusOr<std::vector<std::string>> ReflectedServices(const Target& target) {
  grpc::reflection::v1alpha::ServerReflectionRequest request;
  request.set_list_services("*");
  absl::StatusOr<std::vector<std::string>> answers = absl::UnimplementedError("no reflection");
  for (const char* version : {"v1alpha", "v1"}) {
    const std::string path = fmt::format("/grpc.reflection.{}.ServerReflection/ServerReflectionInfo", version);
    answers = target.Stream(path, {request.SerializeAsString()}, 1);
    if (!absl::IsUnimplemented(answers.status())) break;
  }
  if (!answers.ok()) return answers.status();
  if (answers->empty()) return absl::DataLossError("the stream ended without an answer");
  grpc::reflection::v1alpha::ServerReflectionResponse response;
  if (!response.ParseFromString(answers->front())) return absl::DataLossError("the answer is none of reflection");
  std::vector<std::string> names;
  for (const auto& service : response.list_services_response().service()) names.push_back(service.name());
  return names;
}

}  // namespace flair::contract
