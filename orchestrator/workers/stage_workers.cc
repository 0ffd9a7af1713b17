// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_workers.h"

#include <random>
#include <utility>

#include "orchestrator/workers/grpc_stage_clients.h"

namespace flair::orchestrator {
namespace {

WorkerPoolOptions PoolOptions(const char* stage, const StageChannel& where, const config::v1::StageCallConfig& calls) {
  WorkerPoolOptions options = {.stage = stage, .setting = where.setting};
  if (calls.in_flight_limit() > 0) options.in_flight_limit = calls.in_flight_limit();
  if (calls.failure_limit() > 0) options.failure_limit = calls.failure_limit();
  if (calls.has_recovery_seconds()) options.recovery = absl::Seconds(calls.recovery_seconds());
  // Changes no result: every worker of a revision gives the same answer.
  options.seed = std::random_device()();
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
  for (const WorkersOfStage* workers : All()) {
    if (workers->has_names() && !lookups_.has_value()) lookups_.emplace([this] { LookUpNames(); });
  }
}

StageWorkers::~StageWorkers() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    wake_.notify_all();
  }
  if (lookups_.has_value()) lookups_->join();
}

std::vector<v1::WorkerStatus> StageWorkers::Status() const {
  std::vector<v1::WorkerStatus> all;
  for (const WorkersOfStage* workers : {&language_, &translator_, &optimizer_, &renderer_}) {
    std::vector<v1::WorkerStatus> some = workers->pool().Status();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

void StageWorkers::LookAgain() {
  std::lock_guard lock(mutex_);
  look_again_ = true;
  wake_.notify_all();
}

std::vector<WorkersOfStage*> StageWorkers::All() { return {&language_, &translator_, &optimizer_, &renderer_}; }

void StageWorkers::LookUpNames() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    look_again_ = false;
    lock.unlock();
    for (WorkersOfStage* workers : All()) {
      if (workers->has_names()) workers->LookUp();
    }
    lock.lock();
    wake_.wait_for(lock, absl::ToChronoMilliseconds(options_.lookup_interval),
                   [this] { return stopping_ || look_again_; });
  }
}

}  // namespace flair::orchestrator
