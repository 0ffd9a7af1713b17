// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/target.h"

#include <google/protobuf/descriptor.h>
#include <grpcpp/client_context.h>
#include <grpcpp/generic/generic_stub.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <random>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"
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

}  // namespace

// What gRPC tells of the end of a call. Its thread may hold this a moment longer than the call, and nothing else: a
// channel that it let go of last would have to end within itself.
struct Call::End {
  std::mutex mutex;
  std::condition_variable changed;
  bool reached = false;
  grpc::Status status;
};

struct Call::Parts {
  Parts(const std::shared_ptr<grpc::Channel>& channel, const std::string& rpc_path, const std::string& bytes)
      : stub(channel), path(rpc_path), request(ToBuffer(bytes)) {}

  grpc::GenericStub stub;
  const std::string path;
  grpc::ClientContext context;
  grpc::ByteBuffer request;
  grpc::ByteBuffer response;
};

Call::Call(const std::shared_ptr<grpc::Channel>& channel, const std::string& path, const std::string& request,
           absl::Time deadline)
    : end_(std::make_shared<End>()), parts_(std::make_unique<Parts>(channel, path, request)) {
  parts_->context.set_deadline(absl::ToChronoTime(deadline));
  parts_->stub.UnaryCall(&parts_->context, parts_->path, grpc::StubOptions(), &parts_->request, &parts_->response,
                         [end = end_](grpc::Status status) {
                           std::lock_guard lock(end->mutex);
                           end->status = std::move(status);
                           end->reached = true;
                           end->changed.notify_all();
                         });
}

Call::~Call() {
  parts_->context.TryCancel();
  std::unique_lock lock(end_->mutex);
  end_->changed.wait(lock, [this] { return end_->reached; });
}

void Call::Cancel() { parts_->context.TryCancel(); }

absl::StatusOr<std::string> Call::Wait() {
  std::unique_lock lock(end_->mutex);
  end_->changed.wait(lock, [this] { return end_->reached; });
  if (!end_->status.ok()) return runtime::FromGrpcStatus(end_->status);
  return ToBytes(parts_->response);
}

bool Call::WaitFor(absl::Duration duration) {
  std::unique_lock lock(end_->mutex);
  return end_->changed.wait_for(lock, absl::ToChronoMilliseconds(duration), [this] { return end_->reached; });
}

Target::Target(TargetOptions options)
    : options_(std::move(options)),
      run_(fmt::format("contract-{:x}-{:x}", absl::ToUnixMicros(absl::Now()), std::random_device()())) {}

absl::StatusOr<std::unique_ptr<Target>> Target::Connect(const TargetOptions& options) {
  runtime::ChannelOptions connection = options.connection;
  connection.max_message_mib = options.max_message_mib + kSpareMib;
  auto channel = runtime::MakeChannel(options.address, options.service, connection);
  if (!channel.ok()) return channel.status();
  std::unique_ptr<Target> target(new Target(options));
  target->channel_ = *std::move(channel);
  const absl::StatusOr<std::string> worker = target->Start(kGetWorker, "", target->ConnectWithin())->Wait();
  if (absl::IsUnavailable(worker.status()) || absl::IsDeadlineExceeded(worker.status())) {
    return absl::UnavailableError(
        fmt::format("{}: no gRPC server answers there: {}; is it running, and is this its port?", options.address,
                    std::string(worker.status().message())));
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
  const absl::Status status = Start(kGetWorker, "", ConnectWithin())->Wait().status();
  return !absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status);
}

absl::Status Target::AskInto(const google::protobuf::Message& request, google::protobuf::Message& response) {
  const std::string path = PathOf(options_.service, request);
  {
    std::lock_guard lock(mutex_);
    if (silent_.contains(path)) {
      return absl::DeadlineExceededError(fmt::format("{} was silent for {} before; it is not asked again",
                                                     RpcName(request), absl::FormatDuration(options_.patience)));
    }
  }
  const absl::StatusOr<std::string> bytes = Start(request, options_.patience)->Wait();
  if (absl::IsDeadlineExceeded(bytes.status())) {
    std::lock_guard lock(mutex_);
    silent_.insert(path);
  }
  if (!bytes.ok()) return bytes.status();
  if (response.ParseFromString(*bytes)) return absl::OkStatus();
  return absl::DataLossError(
      fmt::format("the answer's {} bytes are no {}", bytes->size(), response.GetDescriptor()->full_name()));
}

std::unique_ptr<Call> Target::Start(const google::protobuf::Message& request, absl::Duration within) const {
  return Start(PathOf(options_.service, request), request.SerializeAsString(), within);
}

std::unique_ptr<Call> Target::Start(const std::string& path, const std::string& bytes, absl::Duration within) const {
  return std::make_unique<Call>(channel_, path, bytes, absl::Now() + within);
}

std::string Target::NewRequestId() {
  std::lock_guard lock(mutex_);
  return fmt::format("{}-{}", run_, ++request_count_);
}

std::string PathOf(const std::string& service, const google::protobuf::Message& request) {
  const google::protobuf::ServiceDescriptor* const found =
      google::protobuf::DescriptorPool::generated_pool()->FindServiceByName(service);
  for (int i = 0; found != nullptr && i < found->method_count(); ++i) {
    if (found->method(i)->input_type() == request.GetDescriptor()) {
      return fmt::format("/{}/{}", service, found->method(i)->name());
    }
  }
  return "";
}

std::string RpcName(const google::protobuf::Message& request) {
  const std::string& name = request.GetDescriptor()->name();
  constexpr std::string_view kEnd = "Request";
  return name.ends_with(kEnd) ? name.substr(0, name.size() - kEnd.size()) : name;
}

std::string StatusText(const absl::Status& status) {
  constexpr size_t kShown = 300;
  std::string message(status.message().substr(0, kShown));
  if (status.message().size() > kShown) message += "...";
  return fmt::format("{}{}{}", absl::StatusCodeToString(status.code()), message.empty() ? "" : ": ", message);
}

}  // namespace flair::contract
