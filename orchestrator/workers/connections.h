// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "flair/v1/worker_service.grpc.pb.h"
#include "orchestrator/workers/worker_pool.h"

namespace flair::orchestrator {

class Connection;

// Keeps connections to workers and tells their pools how they stand: a worker is ready when its channel is and it has
// said which revision it is, which it is asked once each time that it is reached. One thread for all connections.
// Thread-safe.
class Connections {
 public:
  // Where a connection leads, and whom it tells; `pool` outlives the connection.
  struct Worker {
    WorkerPool& pool;
    WorkerId id;
    // For messages, as in WorkerPoolOptions.
    std::string stage;
    std::string address;
    std::string setting;
  };

  Connections();
  // All connections are gone by then.
  ~Connections();

  // The worker is called through `channel` from now on. `watched`: the channel is nobody else's and may be lost;
  // otherwise it leads to a server of this process, say, which is always there.
  std::shared_ptr<Connection> Open(Worker worker, std::shared_ptr<grpc::Channel> channel, bool watched);

 private:
  friend class Connection;
  // What is to happen when an operation ends; `ok` as gRPC says.
  using Step = std::function<void(bool ok)>;

  // Lets `begin` start an operation whose tag runs `step`; does nothing at the end of it all.
  void Start(Step step, const std::function<void(grpc::CompletionQueue&, void* tag)>& begin);
  void Run();

  std::mutex mutex_;
  bool stopped_ = false;
  grpc::CompletionQueue events_;
  std::thread thread_;
};

// One of Connections. Its channel may outlive it, for calls that are under way. Thread-safe.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Connections& connections, Connections::Worker worker, std::shared_ptr<grpc::Channel> channel,
             bool watched);
  // Stops telling the pool anything.
  ~Connection();

  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }
  const std::string& address() const { return worker_.address; }

  // How to call the worker; of one and the same service each time, which is the stage's.
  template <typename Service>
  typename Service::Stub& StubOf() {
    std::call_once(calls_made_, [this] { calls_ = Service::NewStub(channel_); });
    return *static_cast<typename Service::Stub*>(calls_.get());
  }

  // Once.
  void Open();

 private:
  struct Question {
    grpc::ClientContext context;
    v1::GetWorkerResponse answer;
    grpc::Status status;
    std::unique_ptr<grpc::ClientAsyncResponseReader<v1::GetWorkerResponse>> reader;
  };

  // Connects, and from then on sees what becomes of the channel.
  void Watch();
  // Asks the worker which revision it is and tells the pool.
  void Ask();
  void OnState(grpc_connectivity_state state);
  void OnAnswer(const Question& question);
  void AskLater();
  void AskAgain();

  Connections& connections_;
  const Connections::Worker worker_;
  const std::shared_ptr<grpc::Channel> channel_;
  const bool watched_;
  const std::unique_ptr<v1::WorkerService::Stub> stub_;
  std::once_flag calls_made_;
  // The stub of the stage's service; what knows how to delete it is shared_ptr's alone.
  std::shared_ptr<void> calls_;
  std::mutex mutex_;
  // The one that counts; answers to earlier ones, of a connection that was lost since, do not.
  std::shared_ptr<Question> question_;
  bool ready_ = false;
  std::unique_ptr<grpc::Alarm> alarm_;
};

}  // namespace flair::orchestrator
