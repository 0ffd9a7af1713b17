// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/server_call.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <grpc/grpc_security_constants.h>
#include <grpcpp/support/proto_buffer_reader.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/logging/log.h"

namespace flair::runtime {
namespace {

// Callers choose their ids; no line is longer for it.
constexpr size_t kLongestId = 200;
constexpr size_t kLongestError = 500;

std::string_view Cut(std::string_view text, size_t limit) { return text.substr(0, limit); }

// What a message may take: some in any case, then so many times its bytes; of large ones hardly more than they are.
constexpr int64_t kAnyMessageBytes = 8 << 20;
constexpr int64_t kBytesPerByte = 16;
constexpr int64_t kLargeMessageBytes = 120 << 20;
constexpr int64_t MostUnfolded(int64_t size) {
  return kAnyMessageBytes + std::min(kBytesPerByte * size, kLargeMessageBytes + 2 * size);
}
// What messages from here on may take that a worker has in hand at once; one that is alone may take more.
constexpr int64_t kLargeBytes = 1 << 20;
constexpr int64_t kUnfoldedInHand = 192 << 20;

// One call from arrival to answer. Deletes itself when gRPC is done with it, which is never before it has ended.
class ServerCall final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  ServerCall(WorkerContext& worker, std::string_view rpc, const grpc::CallbackServerContext& context, CallSteps steps)
      : worker_(worker), call_("", DeadlineOf(context), worker.clock), record_(worker, rpc), steps_(std::move(steps)) {}

  CallContext& call() { return call_; }

  void Start(const absl::Status& admitted) {
    record_.SetCaller(call_.caller().name);
    if (!admitted.ok()) return End(admitted);
    StartRead(&message_);
  }

 private:
  void OnReadDone(bool has_message) override {
    if (!has_message && call_.cancellation().cancelled()) return End(call_.CheckAlive());
    if (has_message) ++message_count_;
    if (worker_.executor.TrySubmit([this, has_message] { Step(has_message); })) return;
    End(record_.Refuse());
  }

  void Step(bool has_message) {
    record_.Begin();
    if (const absl::Status alive = call_.CheckAlive(); !alive.ok()) return End(alive);
    absl::StatusOr<std::optional<grpc::ByteBuffer>> answer = Answer(has_message);
    if (!answer.ok()) return End(answer.status());
    if (!answer->has_value()) return StartRead(&message_);
    answer_ = **std::move(answer);
    record_.End(absl::OkStatus(), steps_.is_stream ? message_count_ : -1);
    StartWriteAndFinish(&answer_, grpc::WriteOptions(), grpc::Status::OK);
  }

  absl::StatusOr<std::optional<grpc::ByteBuffer>> Answer(bool has_message) {
    const auto size = static_cast<int64_t>(message_.Length());
    const int64_t bytes = size < kLargeBytes ? 0 : MostUnfolded(size);
    std::atomic<int64_t>& in_hand = *worker_.unfolded_bytes;
    const absl::Cleanup give_back = [&] {
      in_hand -= bytes;
      // What is free between other things would stay with the process, and pile up.
      if (bytes > 0) ::malloc_trim(0);
    };
    if ((in_hand += bytes) > std::max(kUnfoldedInHand, bytes)) return absl::ResourceExhaustedError(kNoRoom);
    if (has_message) return steps_.take(message_, call_, record_);
    return steps_.finish(call_);
  }

  void End(const absl::Status& status) {
    record_.End(status, steps_.is_stream ? message_count_ : -1);
    Finish(ToGrpcStatus(status));
  }

  void OnCancel() override { call_.cancellation().Cancel(); }
  void OnDone() override { delete this; }

  WorkerContext& worker_;
  CallContext call_;
  RpcRecord record_;
  const CallSteps steps_;
  int64_t message_count_ = 0;
  grpc::ByteBuffer message_;
  grpc::ByteBuffer answer_;
};

namespace pb = google::protobuf;
using pb::internal::WireFormatLite;

// Of what is allocated for each: about, and not too little for fields that the message does not know.
constexpr int64_t kScalarBytes = 16;
constexpr int64_t kObjectBytes = 48;
constexpr int64_t kPackedBytes = 8;
constexpr int kNestingLimit = 100;
constexpr size_t kShortMessageBytes = 4096;

// Goes through the fields of a message without making anything, and counts down what each would take.
class Unfolding {
 public:
  Unfolding(pb::io::CodedInputStream& in, int64_t left) : in_(in), left_(left) {}

  // False when more is taken than is left. Stops at what is no field: so will the parser.
  bool Fits(const pb::Descriptor& type, int nesting = 0) {
    while (const uint32_t tag = left_ > 0 ? in_.ReadTag() : 0) {
      const pb::FieldDescriptor* field = type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
      if (WireFormatLite::GetTagWireType(tag) != WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
        left_ -= field != nullptr ? kScalarBytes : kObjectBytes;
        if (!SkipScalar(tag)) break;
        continue;
      }
      uint32_t length = 0;
      if (!in_.ReadVarint32(&length)) break;
      left_ -= kObjectBytes;
      if (field != nullptr && field->message_type() != nullptr && nesting < kNestingLimit) {
        const pb::Descriptor& inner = *field->message_type();
        left_ -= static_cast<int64_t>(pb::MessageFactory::generated_factory()->GetPrototype(&inner)->SpaceUsedLong());
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

  pb::io::CodedInputStream& in_;
  int64_t left_;
};

}  // namespace

RpcRecord::RpcRecord(WorkerContext& worker, std::string_view rpc)
    : worker_(worker),
      counters_(worker.rpc_metrics.Of(rpc)),
      open_calls_(worker.rpc_metrics.open_calls()),
      rpc_(rpc),
      arrival_(worker.clock.Elapsed()) {
  ++*open_calls_;
  counters_.Begin();
}

RpcRecord::~RpcRecord() { --*open_calls_; }

void RpcRecord::Begin() {
  if (wait_ != absl::InfiniteDuration()) return;
  wait_ = worker_.clock.Elapsed() - arrival_;
  counters_.ObserveWait(wait_);
}

absl::Status RpcRecord::Refuse() {
  counters_.Refuse();
  return ResourceExhausted("{}: the queue is full ({} calls wait); try again later", rpc_, worker_.executor.queued());
}

void RpcRecord::End(const absl::Status& status, int64_t message_count) {
  const absl::Duration total = worker_.clock.Elapsed() - arrival_;
  counters_.End(status.code(), total);
  const std::string code = absl::StatusCodeToString(status.code());
  const std::string error(Cut(std::string_view(status.message().data(), status.message().size()), kLongestError));
  LogField messages{"messages", {}};
  if (message_count >= 0) messages.value = message_count;
  // Callers that leave are no failure: watchers do when they have seen enough.
  const bool good = status.ok() || absl::IsCancelled(status);
  Log(*worker_.logger, good ? spdlog::level::info : spdlog::level::warn, fmt::format("{} {}", rpc_, code),
      {{"rpc", rpc_},
       {"code", code},
       {"caller", Cut(caller_, kLongestId)},
       {"request_id", Cut(ids_.request_id, kLongestId)},
       {"job_id", Cut(ids_.job_id, kLongestId)},
       {"batch_id", Cut(ids_.batch_id, kLongestId)},
       {"duration_ms", absl::ToDoubleMilliseconds(total)},
       {"wait_ms", absl::ToDoubleMilliseconds(std::min(wait_, total))},
       messages,
       {"error", error}});
}

absl::Time DeadlineOf(const grpc::CallbackServerContext& context) {
  const std::chrono::system_clock::time_point deadline = context.deadline();
  if (deadline == std::chrono::system_clock::time_point::max()) return absl::InfiniteFuture();
  return absl::FromChrono(deadline);
}

absl::Status Service::Admit(grpc::CallbackServerContext& context, CallContext& call) {
  const auto peer = context.auth_context();
  if (peer == nullptr || !peer->IsPeerAuthenticated()) return absl::OkStatus();
  std::vector<std::string> names;
  for (const char* property : {GRPC_X509_CN_PROPERTY_NAME, GRPC_X509_SAN_PROPERTY_NAME}) {
    for (const grpc::string_ref& name : peer->FindPropertyValues(property))
      names.emplace_back(name.data(), name.size());
  }
  call.set_caller({names.empty() ? "" : names.front(), {}});
  const std::vector<std::string>& believed = worker_.client_names;
  const auto is_believed = [&](const std::string& name) { return std::ranges::find(believed, name) != believed.end(); };
  if (believed.empty() || std::ranges::any_of(names, is_believed)) return absl::OkStatus();
  return absl::PermissionDeniedError(fmt::format(
      "the certificate of \"{}\" is none that may call here (runtime.tls.client_names)", call.caller().name));
}

void Service::AddSteps(const std::string& rpc, std::function<CallSteps()> make) {
  using Handler = grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, grpc::ByteBuffer>;
  AddMethod(rpc, new Handler([this, rpc, make = std::move(make)](grpc::CallbackServerContext* context) {
              auto* call = new ServerCall(worker_, rpc, *context, make());
              call->Start(Admit(*context, call->call()));
              return call;
            }));
}

// On the wire all calls are streams both ways; as such gRPC gives them away with their headers, and reads no message
// unasked.
void Service::AddMethod(const std::string& rpc, grpc::internal::MethodHandler* handler) {
  paths_.push_back("/" + name_ + "/" + rpc);
  grpc::Service::AddMethod(
      new grpc::internal::RpcServiceMethod(paths_.back().c_str(), grpc::internal::RpcMethod::BIDI_STREAMING, nullptr));
  MarkMethodRawCallback(paths_.size() - 1, handler);
}

absl::Status ParseMessage(grpc::ByteBuffer& bytes, pb::Message& message) {
  const auto size = static_cast<int64_t>(bytes.Length());
  const int64_t limit = MostUnfolded(size);
  const std::string name = message.GetDescriptor()->name();
  {
    grpc::ProtoBufferReader reader(&bytes);
    pb::io::CodedInputStream in(&reader);
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

absl::Status ParseShortMessage(grpc::ByteBuffer& bytes, google::protobuf::Message& message) {
  const size_t size = bytes.Length();
  if (size <= kShortMessageBytes) return ParseMessage(bytes, message);
  bytes.Clear();
  return InvalidArgument("{} bytes are too many for this call", size);
}

}  // namespace flair::runtime
