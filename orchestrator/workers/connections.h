// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/completion_queue.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

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

}  // namespace flair::orchestrator
