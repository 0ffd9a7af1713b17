// SPDX-License-Identifier: GPL-3.0-or-later
// What callers do to a server who mean no good.
#pragma once

#include <grpcpp/support/status.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::testing {

// Sockets to one address; closed at the end.
class Sockets {
 public:
  ~Sockets();
  // Connects one more to "HOST:PORT" of this machine, from `source` (such as "127.0.0.2"); false when it is refused.
  bool Connect(const std::string& address, const std::string& source = "127.0.0.1");
  // Sends to the one that was connected last; whether it took it.
  bool SendToLast(const std::string& bytes);
  // The same of more than fits into a socket; false when it is hung up on, or not read for seconds.
  bool SendAllToLast(const std::string& bytes);
  // Sends to all that are open; how many took it.
  int SendToAll(const std::string& bytes);
  // Waits until the other side has closed all of them, at most so long; how many are still open.
  int WaitForClose(int seconds);
  // How many are open now.
  int CountOpen();
  int count() const { return static_cast<int>(files_.size()); }

 private:
  std::vector<int> files_;
};

// Allows this process as many files as it may have; how many.
int RaiseFileLimit();

// What HTTP/2 begins with, and an empty SETTINGS frame.
extern const std::string kPreface;
// A HEADERS frame of stream 1 whose headers go on for ever: no END_HEADERS; and one more byte of them.
extern const std::string kEndlessHeaders;
extern const std::string kMoreHeaders;

// Sends a message of that size, `unit` over and over, over a connection of its own; how the call ended. As it is, no
// request of ours.
grpc::Status SendMessage(const std::string& address, const std::string& method, size_t mib,
                         const std::string& unit = "\x0a", const std::string& token = "");

// All at once, again and again until destroyed, from other addresses than 127.0.0.1: as many connections as may be
// (10,000 when this process may have them), headers that never end, messages that are too large.
class Attack {
 public:
  // `method` of the server is sent the messages.
  Attack(const std::string& address, const std::string& method);
  ~Attack();

  // Waits until each part of it has been tried once.
  void WaitUntilUnderWay();
  // Connections that were tried; messages that were refused, and those that were not.
  int connection_count() const { return connections_; }
  int refused_count() const { return refused_; }
  int taken_count() const { return taken_; }

 private:
  void Crowd();
  void SendEndlessHeaders();
  void SendLargeMessages();
  void Repeat(std::atomic<int>& count, const std::function<void()>& attack);

  const std::string address_;
  const std::string method_;
  std::atomic<bool> stop_ = false;
  std::atomic<int> connections_ = 0;
  std::atomic<int> refused_ = 0;
  std::atomic<int> taken_ = 0;
  std::atomic<int> crowds_ = 0;
  std::atomic<int> headers_ = 0;
  std::atomic<int> messages_ = 0;
  std::vector<std::jthread> threads_;
};

// Calls of an orchestrator by their names, for tests that make all of them.

class OrchestratorCaller {
 public:
  // Throws when the channel cannot be made.
  OrchestratorCaller(const std::string& address, const runtime::ChannelOptions& options);

  absl::StatusOr<v1::Job> CreateJob(const std::string& text, const std::string& request_id);
  // Waits for its end.
  absl::StatusOr<v1::Job> EndOf(const std::string& job_id);
  absl::StatusOr<v1::Batch> CreateBatch(const std::string& text, const std::string& request_id, int job_count = 1);
  absl::StatusOr<v1::ListJobsResponse> ListJobs();
  absl::StatusOr<v1::ListBatchesResponse> ListBatches();

  // Every RPC that is about a job, a batch or an artifact, by its name, of that one.
  std::map<std::string, absl::Status> AskAbout(const std::string& job_id, const std::string& batch_id,
                                               const std::string& artifact_id);
  // Those that are about none.
  std::map<std::string, absl::Status> AskForAny();

 private:
  template <typename Request, typename Response>
  using Method = grpc::Status (v1::OrchestratorService::StubInterface::*)(grpc::ClientContext*, const Request&,
                                                                          Response*);
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(Method<Request, Response> method, const Request& request);

  std::unique_ptr<v1::OrchestratorService::Stub> stub_;
};

}  // namespace flair::testing
