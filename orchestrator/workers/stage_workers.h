// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "orchestrator/batch/repeater.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/stage_channels.h"
#include "orchestrator/workers/worker_pool.h"
#include "worker_runtime/clock/clock.h"

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

struct StageWorkersOptions {
  config::v1::StageCallConfig calls;
  // As in WorkerPoolOptions.
  absl::Duration outage_limit = absl::Hours(24);
  std::function<void(const std::string&)> log = [](const std::string&) {};
  Lookup lookup = LookUpHost;
  // Between two lookups of names.
  absl::Duration lookup_interval = absl::Seconds(3);
};

// The workers of one stage with the connections to them, which come and go as the addresses of their names do.
// Thread-safe; the arguments outlive it.
class WorkersOfStage {
 public:
  // `stage` is its name.
  WorkersOfStage(const char* stage, StageChannel where, const StageWorkersOptions& options, Connections& connections,
                 const runtime::Clock& clock);

  const std::string& stage() const { return options_.stage; }
  const std::string& setting() const { return options_.setting; }
  WorkerPool& pool() { return pool_; }
  const WorkerPool& pool() const { return pool_; }

  // Null when the worker has gone. Calls keep it while they need it.
  std::shared_ptr<Connection> ConnectionTo(WorkerId id) const;

  // Whether there are names, whose addresses may change.
  bool has_names() const { return !addresses_.names.empty(); }
  // Adds and removes workers as the names' addresses say now; where they cannot be told, all stay. One thread at a
  // time.
  void LookUp();

 private:
  // A worker as it is listed: what to connect to, and whom its certificate must name when that is not the same.
  struct Listed {
    std::string address;
    std::string server_name;
    auto operator<=>(const Listed&) const = default;
  };
  void Add(const Listed& worker);

  const WorkerPoolOptions options_;
  const StageChannel where_;
  const Lookup& lookup_;
  Connections& connections_;
  StageAddresses addresses_;
  WorkerPool pool_;
  mutable std::mutex mutex_;
  // Of names only.
  std::map<Listed, WorkerId> found_;
  std::map<WorkerId, std::shared_ptr<Connection>> open_;
};

// Who is called for the stages; the workers outlive the clients.
struct StageCallers {
  WorkersOfStage& language;
  WorkersOfStage& translator;
  WorkersOfStage& optimizer;
  WorkersOfStage& renderer;
};

// The stages as their workers. Errors say which worker, where that is set and what to do. In grpc_stage_clients.cc.
std::unique_ptr<StageClients> MakeGrpcStageClients(const StageCallers& callers);

// All workers that an orchestrator calls, and the calls to them: docs/workers.md. One thread keeps the connections, and
// one looks up names where there are any. Thread-safe.
class StageWorkers {
 public:
  // `clock` and the servers behind `channels` outlive it. No call is under way when it is destroyed.
  StageWorkers(const StageChannels& channels, StageWorkersOptions options, const runtime::Clock& clock);

  // The stages as the pipeline asks them. A worker that cannot be reached is UNAVAILABLE with its stage, address and
  // what to do.
  StageClients& clients() { return *clients_; }

  // Every worker, stage by stage.
  std::vector<v1::WorkerStatus> Status() const;

  // Looks up names now, as somebody may want who knows that workers came or went.
  void LookAgain() {
    if (lookups_.has_value()) lookups_->Wake();
  }

 private:
  std::vector<WorkersOfStage*> All();

  const StageWorkersOptions options_;
  Connections connections_;
  WorkersOfStage language_;
  WorkersOfStage translator_;
  WorkersOfStage optimizer_;
  WorkersOfStage renderer_;
  std::unique_ptr<StageClients> clients_;
  // Only where there are names.
  std::optional<Repeater> lookups_;
};

}  // namespace flair::orchestrator
