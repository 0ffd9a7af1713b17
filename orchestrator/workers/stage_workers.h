// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/batch/repeater.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/connections.h"
#include "orchestrator/workers/stage_channels.h"
#include "orchestrator/workers/worker_pool.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// The workers of one stage with the connections to them, which come and go as the addresses of their names do.
// Thread-safe; the arguments outlive it.
class WorkersOfStage {
 public:
  WorkersOfStage(WorkerPoolOptions options, StageChannel where, const Lookup& lookup, Connections& connections,
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
  // After this a call that is not answered is made of a second worker too; never when infinite.
  absl::Duration hedge_after = absl::InfiniteDuration();
};

// The stages as their workers. Errors say which worker, where that is set and what to do. In grpc_stage_clients.cc.
std::unique_ptr<StageClients> MakeGrpcStageClients(const StageCallers& callers);

struct StageWorkersOptions {
  config::v1::StageCallConfig calls;
  Lookup lookup = LookUpHost;
  // Between two lookups of names.
  absl::Duration lookup_interval = absl::Seconds(3);
};

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
