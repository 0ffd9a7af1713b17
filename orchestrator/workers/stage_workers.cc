// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_workers.h"

#include <algorithm>
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

namespace {

WorkerPoolOptions PoolOptions(const char* stage, const StageChannel& where, const config::v1::StageCallConfig& calls) {
  WorkerPoolOptions options = {.stage = stage, .setting = where.setting};
  if (calls.in_flight_limit() > 0) options.in_flight_limit = calls.in_flight_limit();
  if (calls.failure_limit() > 0) options.failure_limit = calls.failure_limit();
  if (calls.has_recovery_seconds()) options.recovery = absl::Seconds(calls.recovery_seconds());
  return options;
}

absl::Duration HedgeAfter(const config::v1::StageCallConfig& calls) {
  return calls.has_hedge_seconds() ? absl::Seconds(calls.hedge_seconds()) : absl::InfiniteDuration();
}

}  // namespace

StageWorkers::StageWorkers(const StageChannels& channels, StageWorkersOptions options, const runtime::Clock& clock)
    : options_(std::move(options)),
      language_(PoolOptions("language", channels.language, options_.calls), channels.language, options_.lookup,
                connections_, clock),
      translator_(PoolOptions("translator", channels.translator, options_.calls), channels.translator, options_.lookup,
                  connections_, clock),
      optimizer_(PoolOptions("optimizer", channels.optimizer, options_.calls), channels.optimizer, options_.lookup,
                 connections_, clock),
      renderer_(PoolOptions("renderer", channels.renderer, options_.calls), channels.renderer, options_.lookup,
                connections_, clock),
      clients_(MakeGrpcStageClients({language_, translator_, optimizer_, renderer_, HedgeAfter(options_.calls)})) {
  if (std::ranges::none_of(All(), &WorkersOfStage::has_names)) return;
  lookups_.emplace([this] {
    for (WorkersOfStage* workers : All()) {
      if (workers->has_names()) workers->LookUp();
    }
    return options_.lookup_interval;
  });
}

std::vector<v1::WorkerStatus> StageWorkers::Status() const {
  std::vector<v1::WorkerStatus> all;
  for (const WorkersOfStage* workers : {&language_, &translator_, &optimizer_, &renderer_}) {
    std::vector<v1::WorkerStatus> some = workers->pool().Status();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<WorkersOfStage*> StageWorkers::All() { return {&language_, &translator_, &optimizer_, &renderer_}; }

}  // namespace flair::orchestrator
