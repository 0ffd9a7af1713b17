// SPDX-License-Identifier: GPL-3.0-or-later
// The server under test: a channel, what it claims, and calls that always end.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <grpcpp/channel.h>

#include <future>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/worker_service.pb.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {

// A call under way. Cancelled when it is destroyed before its end.
class Call {
 public:
  // Any bytes to any path, such as "/grpc.health.v1.Health/Check".
  Call(const std::shared_ptr<grpc::Channel>& channel, const std::string& path, const std::string& request,
       absl::Duration within);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void Cancel();
  // Waits for the end: the bytes of the answer, or the status.
  absl::StatusOr<std::string> Wait();
  // Waits at most so long; whether it has ended.
  bool WaitFor(absl::Duration duration);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  std::shared_future<absl::Status> end_;
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
    const absl::StatusOr<std::string> bytes = AskForBytes(request);
    if (!bytes.ok()) return bytes.status();
    Response answer;
    if (answer.ParseFromString(*bytes)) return answer;
    return DataLoss("the answer's {} bytes are no {}", bytes->size(), Response::descriptor()->full_name());
  }
  absl::StatusOr<std::string> AskForBytes(const google::protobuf::Message& request);

  // Sends messages to a method and returns what comes back: of one that takes and gives one, as AskForBytes; of streams
  // all until the stream or the patience ends, or until `leave_after` (0: never) have come.
  absl::StatusOr<std::vector<std::string>> Exchange(const google::protobuf::MethodDescriptor& method,
                                                    const std::vector<std::string>& requests, size_t leave_after);
  absl::StatusOr<std::vector<std::string>> Stream(const std::string& path, const std::vector<std::string>& requests,
                                                  size_t leave_after) const;

  // A unary call without waiting.
  std::unique_ptr<Call> Start(const google::protobuf::Message& request, absl::Duration within) const;
  // The answer's bytes, within the patience; an RPC that was silent is asked again.
  absl::StatusOr<std::string> AskAgain(const google::protobuf::Message& request) const;

  // Path of the RPC of the service that takes such a request, "/flair.v1.OptimizerService/Solve"; empty when none does.
  std::string PathOf(const google::protobuf::Message& request) const;

  // A name for a request that no server has seen.
  std::string NewRequestId();

 private:
  explicit Target(TargetOptions options);
  absl::Duration ConnectWithin() const;
  absl::StatusOr<std::string> AskOnce(const std::string& path, const std::string& request);

  const TargetOptions options_;
  std::shared_ptr<grpc::Channel> channel_;
  v1::GetWorkerResponse worker_;
  std::mutex mutex_;
  std::set<std::string> silent_;  // paths of RPCs
  std::string run_;               // differs between runs
  int request_count_ = 0;
};

// Name of the RPC that takes such a request: "Solve".
std::string RpcName(const google::protobuf::Message& request);

// What grpc.health.v1.Health says of a service, such as "SERVING"; empty name: of the server. UNIMPLEMENTED when the
// server has no health service, NOT_FOUND when it does not know the service.
absl::StatusOr<std::string> HealthOf(const std::shared_ptr<grpc::Channel>& channel, const std::string& service,
                                     absl::Duration within);

// Full names of the services that grpc.reflection lists. UNIMPLEMENTED when the server has no reflection.
absl::StatusOr<std::vector<std::string>> ReflectedServices(const Target& target);

}  // namespace flair::contract
