// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "orchestrator/workers/addresses.h"
#include "orchestrator/workers/connection.h"
#include "orchestrator/workers/stage_channels.h"
#include "orchestrator/workers/worker_pool.h"

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

}  // namespace flair::orchestrator
