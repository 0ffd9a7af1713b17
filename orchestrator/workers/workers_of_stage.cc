// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/workers_of_stage.h"

#include <set>
#include <utility>

namespace flair::orchestrator {

WorkersOfStage::WorkersOfStage(WorkerPoolOptions options, StageChannel where, const Lookup& lookup,
                               Connections& connections, const runtime::Clock& clock)
    : options_(std::move(options)),
      where_(std::move(where)),
      lookup_(lookup),
      connections_(connections),
      pool_(options_, clock) {
  if (where_.connect == nullptr) {
    const WorkerId id = pool_.Add(where_.address);
    open_[id] = connections_.Open({pool_, id, options_.stage, where_.address, options_.setting}, where_.channel, false);
  } else if (absl::StatusOr<StageAddresses> addresses = ParseStageAddresses(where_.address); addresses.ok()) {
    addresses_ = *std::move(addresses);
    for (const std::string& address : addresses_.workers) Add({address, ""});
  }
  if (!has_names()) pool_.SetFound(absl::OkStatus());
}

std::shared_ptr<Connection> WorkersOfStage::ConnectionTo(WorkerId id) const {
  std::lock_guard lock(mutex_);
  const auto found = open_.find(id);
  return found == open_.end() ? nullptr : found->second;
}

void WorkersOfStage::Add(const Listed& worker) {
  const WorkerId id = pool_.Add(worker.address);
  absl::StatusOr<std::shared_ptr<grpc::Channel>> channel = where_.connect(worker.address, worker.server_name);
  std::lock_guard lock(mutex_);
  if (!worker.server_name.empty()) found_[worker] = id;
  if (!channel.ok()) {
    pool_.SetGone(id, absl::UnavailableError(channel.status().message()));
    return;
  }
  open_[id] =
      connections_.Open({pool_, id, options_.stage, worker.address, options_.setting}, *std::move(channel), true);
}

void WorkersOfStage::LookUp() {
  std::set<Listed> listed;
  absl::Status status;
  for (const StageAddresses::Name& name : addresses_.names) {
    const absl::StatusOr<std::vector<std::string>> hosts = lookup_(name.host);
    if (!hosts.ok()) {
      status = hosts.status();
      continue;
    }
    for (const std::string& host : *hosts) listed.insert({JoinHostPort(host, name.port), name.host});
  }
  std::set<Listed> added = listed;
  std::map<WorkerId, std::shared_ptr<Connection>> removed;
  {
    std::lock_guard lock(mutex_);
    for (auto it = found_.begin(); it != found_.end();) {
      added.erase(it->first);
      if (!status.ok() || listed.contains(it->first)) {
        ++it;
        continue;
      }
      removed[it->second] = std::move(open_[it->second]);
      open_.erase(it->second);
      pool_.Remove(it->second);
      it = found_.erase(it);
    }
  }
  for (const Listed& worker : added) Add(worker);
  pool_.SetFound(status);
}

}  // namespace flair::orchestrator
