// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/make_orchestrator_service.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "orchestrator/access/access_control.h"
#include "orchestrator/batch/event_hub.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/batch/queue_config.h"
#include "orchestrator/batch/queue_metrics.h"
#include "orchestrator/batch/repeater.h"
#include "orchestrator/batch/sweeper.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/service/orchestrator_handlers.h"
#include "orchestrator/service/watches.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/workers/stage_workers.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

namespace {

const config::v1::TlsConfig* TlsOf(const config::v1::OrchestratorConfig& config) {
  return config.runtime().has_tls() ? &config.runtime().tls() : nullptr;
}

int RunningJobLimit(const config::v1::OrchestratorConfig& config) {
  if (config.running_job_limit() > 0) return config.running_job_limit();
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Reports a queue on other machines that would be spoken to in plain text.
void CheckQueueExposure(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  if (!config.has_queue() || config.runtime().allow_insecure()) return;
  const std::string shown = ShownAddress(config.queue());
  // One encrypted server makes the connections to all of them so.
  if (absl::StrContains(shown, "tls://")) return;
  const std::vector<std::string> servers = absl::StrSplit(shown, ',');
  for (const std::string& server : servers) {
    const std::string host(absl::StripPrefix(server, "nats://"));
    const bool has_port = host.rfind(':') != std::string::npos && !host.ends_with(']');
    if (runtime::IsLocalAddress(has_port ? host : host + ":4222")) continue;
    checker.Report(
        "queue.address",
        fmt::format("\"{}\" is on another machine, and in plain text others can read and change what goes "
                    "there; use tls:// with runtime.tls, or set runtime.allow_insecure: true if only trusted "
                    "machines can reach that network",
                    server));
  }
}

int QueuedJobLimit(const config::v1::OrchestratorConfig& config) {
  return config.queued_job_limit() > 0 ? config.queued_job_limit() : 1000000;
}

PipelineOptions PipelineOptionsOf(const config::v1::OrchestratorConfig& config, const std::string& build) {
  PipelineOptions options;
  options.build = build;
  if (config.has_stage_deadline_seconds()) options.stage_deadline = absl::Seconds(config.stage_deadline_seconds());
  return options;
}

JobRunnerOptions RunnerOptionsOf(const config::v1::OrchestratorConfig& config) {
  JobRunnerOptions options;
  options.running_job_limit = config.takes_no_jobs() ? 0 : RunningJobLimit(config);
  options.requested_jobs_only = config.requested_jobs_only();
  if (config.attempt_limit() > 0) options.attempt_limit = config.attempt_limit();
  return options;
}

std::optional<absl::Duration> KeepEnded(const config::v1::OrchestratorConfig& config) {
  if (!config.has_keep_ended_seconds()) return std::nullopt;
  return absl::Seconds(config.keep_ended_seconds());
}

// In JetStream when the config names a queue, otherwise in its store_path.
absl::StatusOr<std::unique_ptr<WorkQueue>> OpenWorkQueue(const config::v1::OrchestratorConfig& config,
                                                         const runtime::Clock& clock) {
  if (config.has_queue()) return Nats().open_queue(config.queue(), TlsOf(config), clock);
  return SqliteWorkQueue::Open(config.store_path(), clock);
}

// See OrchestratorConfig.artifact_store.
absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenArtifactStore(const config::v1::OrchestratorConfig& config,
                                                                 const runtime::Clock& clock) {
  const std::string& address = config.artifact_store();
  if (address.starts_with("folder:")) return ArtifactFiles::Open(address.substr(7));
  if (address.empty() && !config.has_queue()) return LocalArtifacts::Open(config.store_path() + "/artifacts");
  if (!address.empty() && address != "jetstream:") {
    return absl::InvalidArgumentError(
        fmt::format("artifact_store: \"{}\" is not a store; expected \"folder:PATH\" or \"jetstream:\"", address));
  }
  if (!config.has_queue()) {
    return absl::InvalidArgumentError(
        "artifact_store: \"jetstream:\" keeps artifacts on the queue's servers; set queue");
  }
  return Nats().open_artifacts(config.queue(), TlsOf(config), clock);
}

google::protobuf::Timestamp ToProto(absl::Time time) {
  return google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(time));
}

// What of the status never changes.
v1::OrchestratorStatus Introduce(const config::v1::OrchestratorConfig& config, const runtime::WorkerContext& worker) {
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  std::random_device random;
  v1::OrchestratorStatus status;
  status.set_id(fmt::format("{}-{}-{:06x}", host, ::getpid(), random() & 0xffffffu));
  status.set_host(host);
  status.set_build(worker.build);
  status.set_running_limit(RunnerOptionsOf(config).running_job_limit);
  *status.mutable_start_time() = ToProto(worker.clock.Now());
  return status;
}

struct Stores {
  std::unique_ptr<WorkQueue> queue;
  std::unique_ptr<ArtifactStore> artifacts;
  std::unique_ptr<AccessControl> access;
};

class Service final : public OrchestratorService {
 public:
  Service(const config::v1::OrchestratorConfig& config, runtime::WorkerContext& worker, const StageChannels& channels,
          Stores stores)
      : worker_(worker),
        stores_(std::move(stores)),
        workers_(channels, {.calls = config.stage_calls()}, worker.clock),
        introduction_(Introduce(config, worker)),
        pipeline_(*stores_.queue, *stores_.artifacts, workers_.clients(), worker.clock,
                  PipelineOptionsOf(config, worker.build)),
        runner_(*stores_.queue, pipeline_, worker.clock, *worker.logger, RunnerOptionsOf(config)),
        handlers_(*stores_.queue, *stores_.artifacts, runner_, worker.clock, QueuedJobLimit(config),
                  [this] { return Status(); }),
        watches_(hub_, worker),
        sweeper_(*stores_.queue, *stores_.artifacts, worker.clock, *worker.logger, KeepEnded(config)) {
    stores_.queue->Listen({[this] { runner_.Wake(); }, [this](const std::string& id) { hub_.Notify(id); },
                           [this](const std::string& id) { hub_.Notify(id); }});
    // Who runs only what it is asked for is no part of a cluster.
    if (config.has_queue() || !config.requested_jobs_only()) {
      reporter_.emplace([this] { return Report(); });
    }
    sweeper_.Start();
  }

  ~Service() override {
    Stop();
    stores_.queue->Listen({});
  }

  void Stop() override {
    sweeper_.Stop();
    watches_.Stop();
    runner_.Stop();
  }

#define FLAIR_SERVE(Rpc)                                                                               \
  grpc::ServerUnaryReactor* Rpc(grpc::CallbackServerContext* context, const v1::Rpc##Request* request, \
                                v1::Rpc##Response* response) override {                                \
    return Serve(#Rpc, *context, *request, *response, &OrchestratorHandlers::Rpc);                     \
  }
  FLAIR_SERVE(CreateJob)
  FLAIR_SERVE(GetJob)
  FLAIR_SERVE(ListJobs)
  FLAIR_SERVE(CancelJob)
  FLAIR_SERVE(GetArtifact)
  FLAIR_SERVE(GetCluster)
  FLAIR_SERVE(CreateBatch)
  FLAIR_SERVE(AddToBatch)
  FLAIR_SERVE(GetBatch)
  FLAIR_SERVE(ListBatches)
  FLAIR_SERVE(PauseBatch)
  FLAIR_SERVE(ResumeBatch)
  FLAIR_SERVE(CancelBatch)
  FLAIR_SERVE(RetryBatch)
  FLAIR_SERVE(DeleteJob)
  FLAIR_SERVE(DeleteBatch)
#undef FLAIR_SERVE

  grpc::ServerWriteReactor<v1::WatchJobResponse>* WatchJob(grpc::CallbackServerContext* context,
                                                           const v1::WatchJobRequest* request) override {
    const std::string id = request->job_id();
    const auto admit = [this, id, caller = Admit(*context)]() -> absl::Status {
      if (!caller.ok()) return caller.status();
      RETURN_IF_ERROR(handlers_.VisibleJob(id, *caller).status());
      runner_.Request({id});
      return absl::OkStatus();
    };
    return watches_.Start(JobSource(*stores_.queue, id, admit), request->after_sequence());
  }

  grpc::ServerWriteReactor<v1::WatchBatchResponse>* WatchBatch(grpc::CallbackServerContext* context,
                                                               const v1::WatchBatchRequest* request) override {
    const std::string id = request->batch_id();
    const auto admit = [this, id, caller = Admit(*context)]() -> absl::Status {
      if (!caller.ok()) return caller.status();
      RETURN_IF_ERROR(handlers_.VisibleBatch(id, *caller).status());
      runner_.Request({}, id);
      return absl::OkStatus();
    };
    return watches_.Start(BatchSource(*stores_.queue, id, admit), request->after_sequence());
  }

 private:
  absl::StatusOr<Caller> Admit(const grpc::CallbackServerContext& context) {
    return stores_.access->Admit(runtime::AuthorizationOf(context));
  }

  // Those who may not call take no place in the queue from those who may.
  grpc::ServerUnaryReactor* TurnAway(const char* rpc, grpc::CallbackServerContext& context,
                                     const absl::Status& status) {
    runtime::RpcRecord(worker_, rpc, {}).End(status);
    grpc::ServerUnaryReactor* reactor = context.DefaultReactor();
    reactor->Finish(runtime::ToGrpcStatus(status));
    return reactor;
  }

  template <typename Request, typename Response>
  grpc::ServerUnaryReactor* Serve(const char* rpc, grpc::CallbackServerContext& context, const Request& request,
                                  Response& response,
                                  absl::StatusOr<Response> (OrchestratorHandlers::*handle)(const Request&,
                                                                                           const Caller&)) {
    const absl::StatusOr<Caller> caller = Admit(context);
    if (!caller.ok()) return TurnAway(rpc, context, caller.status());
    return runtime::StartUnary(
        worker_, rpc, runtime::internal::CallIdsOf(request), context,
        [this, caller = *caller, &request, &response, handle](runtime::CallContext&) -> absl::Status {
          ASSIGN_OR_RETURN(response, (handlers_.*handle)(request, caller));
          return absl::OkStatus();
        });
  }

  v1::OrchestratorStatus Status() {
    const JobRunnerCounts counts = runner_.counts();
    v1::OrchestratorStatus status = introduction_;
    *status.mutable_report_time() = ToProto(worker_.clock.Now());
    status.set_running_count(counts.running_count);
    status.set_succeeded_count(counts.succeeded_count);
    status.set_failed_count(counts.failed_count);
    status.set_retried_count(counts.retried_count);
    for (v1::WorkerStatus& worker : workers_.Status()) *status.add_workers() = std::move(worker);
    return status;
  }

  // Tells the other orchestrators of the queue how this one does.
  absl::Duration Report() {
    const absl::Status status = stores_.queue->ReportStatus(Status());
    // Once per outage.
    if (!status.ok() && !report_failed_) {
      worker_.logger->warn("cannot report to the queue: {}", std::string(status.message()));
    }
    report_failed_ = !status.ok();
    return absl::Seconds(2);
  }

  // Destroyed from the last to the first: nothing is told of what has gone.
  runtime::WorkerContext& worker_;
  Stores stores_;
  StageWorkers workers_;
  const v1::OrchestratorStatus introduction_;
  EventHub hub_;
  const Pipeline pipeline_;
  JobRunner runner_;
  OrchestratorHandlers handlers_;
  Watches watches_;
  bool report_failed_ = false;
  std::optional<Repeater> reporter_;
  Sweeper sweeper_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<OrchestratorService>> MakeOrchestratorService(
    const config::v1::OrchestratorConfig& config, runtime::WorkerContext& context, const StageChannels& channels) {
  ASSIGN_OR_RETURN(std::unique_ptr<AccessControl> access,
                   AccessControl::Open(config.tokens_path(), context.clock, context.logger));
  ASSIGN_OR_RETURN(std::unique_ptr<WorkQueue> queue, OpenWorkQueue(config, context.clock));
  ASSIGN_OR_RETURN(std::unique_ptr<ArtifactStore> artifacts, OpenArtifactStore(config, context.clock));
  context.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  return std::make_unique<Service>(
      config, context, channels,
      Stores{MakeMeteredWorkQueue(std::move(queue), context.metrics, context.clock, context.logger),
             std::move(artifacts), std::move(access)});
}

void CheckOrchestratorConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  if (config.store_path().empty() && !config.has_queue()) {
    checker.Report("store_path", "missing; expected a folder, or a queue");
  }
  checker.Range("attempt_limit", config.attempt_limit(), 0, 100);
  checker.Range("running_job_limit", config.running_job_limit(), 0, 256);
  checker.Range("queued_job_limit", config.queued_job_limit(), 0, 10000000);
  if (config.has_stage_deadline_seconds()) {
    checker.Range("stage_deadline_seconds", config.stage_deadline_seconds(), 0.001, 86400);
  }
  if (config.has_keep_ended_seconds()) {
    checker.Range("keep_ended_seconds", config.keep_ended_seconds(), 60, 315360000);
  }
  CheckStageConfig(config, checker);
  CheckQueueExposure(config, checker);
}

}  // namespace flair::orchestrator
