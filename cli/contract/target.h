// SPDX-License-Identifier: GPL-3.0-or-later
// The server under test: a channel, what it claims, and calls that always end.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/channel.h>
#include <grpcpp/support/byte_buffer.h>

#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/worker_service.pb.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::contract {

// A call under way. Cancelled when it is destroyed before its end.
class Call {
 public:
  Call(const std::shared_ptr<grpc::Channel>& channel, const std::string& path, const std::string& request,
       absl::Time deadline);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void Cancel();
  // Waits for the end: the bytes of the answer, or the status.
  absl::StatusOr<std::string> Wait();
  // Waits at most so long; whether it has ended.
  bool WaitFor(absl::Duration duration);

 private:
  struct End;
  struct Parts;
  // Shared with gRPC's thread.
  std::shared_ptr<End> end_;
  std::unique_ptr<Parts> parts_;
};

struct TargetOptions {
  // HOST:PORT, unix:PATH or dns:///NAME:PORT.
  std::string address;
  // Full name, such as "flair.v1.OptimizerService".
  std::string service;
  // How long a plain call may take before the server counts as silent.
  absl::Duration patience = absl::Seconds(20);
  // The largest message that the server is to take.
  int max_message_mib = 32;
  // How it is reached; its max_message_mib is not read.
  runtime::ChannelOptions connection = {};
};

// Thread-safe.
class Target {
 public:
  // UNAVAILABLE when nobody answers there within ten seconds or the patience, INVALID_ARGUMENT when the address has no
  // known form.
  static absl::StatusOr<std::unique_ptr<Target>> Connect(const TargetOptions& options);

  const TargetOptions& options() const { return options_; }
  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }
  // What it says of itself; empty when it has no WorkerService.
  const v1::GetWorkerResponse& worker() const { return worker_; }
  bool Claims(v1::Capability capability) const;
  // Whether anything answers there.
  bool IsReachable() const;

  // Calls the RPC of the service that takes such a request. DEADLINE_EXCEEDED after the patience, and at once when the
  // same RPC has been silent before; DATA_LOSS when the answer's bytes are no such message.
  template <typename Response>
  absl::StatusOr<Response> Ask(const google::protobuf::Message& request) {
    Response response;
    absl::Status status = AskInto(request, response);
    if (!status.ok()) return status;
    return response;
  }
  absl::Status AskInto(const google::protobuf::Message& request, google::protobuf::Message& response);

  // The same without waiting, and with another deadline.
  std::unique_ptr<Call> Start(const google::protobuf::Message& request, absl::Duration within) const;
  // Any bytes to any path, such as "/grpc.health.v1.Health/Check".
  std::unique_ptr<Call> Start(const std::string& path, const std::string& bytes, absl::Duration within) const;

  // A name for a request that no server has seen.
  std::string NewRequestId();

 private:
  explicit Target(TargetOptions options);
  absl::Duration ConnectWithin() const;

  const TargetOptions options_;
  std::shared_ptr<grpc::Channel> channel_;
  v1::GetWorkerResponse worker_;
  std::mutex mutex_;
  std::set<std::string> silent_;  // paths of RPCs
  std::string run_;               // differs between runs
  int request_count_ = 0;
};

// Path of the RPC of the service that takes such a request, "/flair.v1.OptimizerService/Solve"; empty when none does.
std::string PathOf(const std::string& service, const google::protobuf::Message& request);
// Its last word, "Solve".
std::string RpcName(const google::protobuf::Message& request);

// "INVALID_ARGUMENT: the message".
std::string StatusText(const absl::Status& status);

}  // namespace flair::contract
