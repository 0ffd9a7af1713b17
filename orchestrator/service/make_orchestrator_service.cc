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
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/batch/queue_metrics.h"
#include "orchestrator/batch/repeater.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/service/orchestrator_handlers.h"
#include "orchestrator/service/stage_passage.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/workers/stage_workers.h"
#include "worker_runtime/grpc/channel.h"
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

JobRunnerOptions RunnerOptionsOf(const config::v1::OrchestratorConfig& config,
                                 std::function<void(const absl::Status&)> damaged = {}) {
  JobRunnerOptions options;
  // On NATS, a damaged record is one job's or one batch's.
  if (!config.has_queue()) options.damaged = std::move(damaged);
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
    return InvalidArgument("artifact_store: \"{}\" is not a store; expected \"folder:PATH\" or \"jetstream:\"",
                           address);
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
      : OrchestratorService(worker, v1::OrchestratorService::service_full_name()),
        stores_(std::move(stores)),
        workers_(channels,
                 {.calls = config.stage_calls(),
                  .outage_limit = absl::Hours(config.has_outage_limit_hours() ? config.outage_limit_hours() : 24),
                  .log = [&worker](const std::string& remark) { worker.logger->warn("{}", remark); }},
                 worker.clock),
        introduction_(Introduce(config, worker)),
        pipeline_(*stores_.queue, *stores_.artifacts, workers_.clients(), worker.clock,
                  PipelineOptionsOf(config, worker.build)),
        watches_(hub_, worker),
        runner_(*stores_.queue, pipeline_, worker.clock, *worker.logger,
                RunnerOptionsOf(config, [this](const absl::Status& why) { watches_.EndAll(why); })),
        handlers_(*stores_.queue, *stores_.artifacts, runner_, worker.clock, QueuedJobLimit(config),
                  [this] { return Status(); }),
        sweeper_(*stores_.queue, *stores_.artifacts, worker.clock, *worker.logger, KeepEnded(config)) {
    Serve(&OrchestratorHandlers::CreateJob, "CreateJob");
    Serve(&OrchestratorHandlers::GetJob, "GetJob");
    Serve(&OrchestratorHandlers::ListJobs, "ListJobs");
    Serve(&OrchestratorHandlers::CancelJob, "CancelJob");
    Serve(&OrchestratorHandlers::GetArtifact, "GetArtifact");
    Serve(&OrchestratorHandlers::GetCluster, "GetCluster");
    Serve(&OrchestratorHandlers::CreateBatch, "CreateBatch");
    Serve(&OrchestratorHandlers::AddToBatch, "AddToBatch");
    Serve(&OrchestratorHandlers::GetBatch, "GetBatch");
    Serve(&OrchestratorHandlers::ListBatches, "ListBatches");
    Serve(&OrchestratorHandlers::PauseBatch, "PauseBatch");
    Serve(&OrchestratorHandlers::ResumeBatch, "ResumeBatch");
    Serve(&OrchestratorHandlers::CancelBatch, "CancelBatch");
    Serve(&OrchestratorHandlers::RetryBatch, "RetryBatch");
    Serve(&OrchestratorHandlers::DeleteJob, "DeleteJob");
    Serve(&OrchestratorHandlers::DeleteBatch, "DeleteBatch");
    using JobStream = absl::StatusOr<WatchSource<v1::WatchJobResponse>>;
    Watch<v1::WatchJobRequest, v1::WatchJobResponse>("WatchJob",
                                                     [this](const auto& request, const Caller& caller) -> JobStream {
                                                       const std::string& id = request.job_id();
                                                       RETURN_IF_ERROR(handlers_.VisibleJob(id, caller).status());
                                                       runner_.Request({id});
                                                       return JobSource(*stores_.queue, id);
                                                     });
    using BatchStream = absl::StatusOr<WatchSource<v1::WatchBatchResponse>>;
    Watch<v1::WatchBatchRequest, v1::WatchBatchResponse>(
        "WatchBatch", [this](const auto& request, const Caller& caller) -> BatchStream {
          const std::string& id = request.batch_id();
          RETURN_IF_ERROR(handlers_.VisibleBatch(id, caller).status());
          runner_.Request({}, id);
          return BatchSource(*stores_.queue, id);
        });
    stores_.queue->Listen({[this] { runner_.Wake(); }, [this](const std::string& id) { hub_.Notify(id); },
                           [this](const std::string& id) { hub_.Notify(id); }});
    // Who runs only what it is asked for is no part of a cluster.
    if (config.has_queue() || !config.requested_jobs_only()) reporter_.emplace([this] { return Report(); });
    sweeper_.Start();
  }

  ~Service() override {
    Stop();
    stores_.queue->Listen({});
  }

  std::vector<runtime::NamedService> Passages() override {
    return MakeStagePassages(workers_.clients(), *stores_.access, worker_);
  }

  void Stop() override {
    sweeper_.Stop();
    watches_.Stop();
    runner_.Stop();
  }

 private:
  absl::Status Admit(grpc::CallbackServerContext& context, runtime::CallContext& call) override {
    RETURN_IF_ERROR(runtime::Service::Admit(context, call));
    ASSIGN_OR_RETURN(Caller caller, stores_.access->Admit(runtime::AuthorizationOf(context)));
    call.set_caller({caller.name, caller});
    return absl::OkStatus();
  }

  template <typename Request, typename Response>
  void Serve(absl::StatusOr<Response> (OrchestratorHandlers::*handle)(const Request&, const Caller&), const char* rpc) {
    Unary<Request>(rpc, [this, handle](const Request& request, runtime::CallContext& call) {
      return (handlers_.*handle)(request, std::any_cast<const Caller&>(call.caller().rights));
    });
  }

  // `open` says where a request's stream comes from, or why not.
  template <typename Request, typename Response>
  void Watch(const char* rpc,
             std::function<absl::StatusOr<WatchSource<Response>>(const Request&, const Caller&)> open) {
    ServerStream<Response>(rpc, [this, rpc, open](grpc::CallbackServerContext* context) {
      runtime::CallContext call;
      const absl::Status admitted = Admit(*context, call);
      return watches_.Start<Request, Response>(rpc, call.caller().name, admitted,
                                               [open, caller = call.caller().rights](const Request& request) {
                                                 return open(request, std::any_cast<const Caller&>(caller));
                                               });
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
  Stores stores_;
  StageWorkers workers_;
  const v1::OrchestratorStatus introduction_;
  EventHub hub_;
  const Pipeline pipeline_;
  Watches watches_;
  JobRunner runner_;
  OrchestratorHandlers handlers_;
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
  if (config.has_outage_limit_hours()) checker.Range("outage_limit_hours", config.outage_limit_hours(), 0, 8760);
  if (config.has_keep_ended_seconds()) checker.Range("keep_ended_seconds", config.keep_ended_seconds(), 60, 315360000);
  CheckStageConfig(config, checker);
  CheckQueueExposure(config, checker);
}

}  // namespace flair::orchestrator
