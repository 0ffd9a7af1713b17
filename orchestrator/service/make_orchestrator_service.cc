// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/make_orchestrator_service.h"

#include <algorithm>
#include <thread>

#include "orchestrator/batch/event_hub.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/batch/store_monitor.h"
#include "orchestrator/pipeline/grpc_stage_clients.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/service/orchestrator_handlers.h"
#include "orchestrator/service/watch_job.h"
#include "orchestrator/store/job_store.h"
#include "worker_runtime/grpc/unary_call.h"

namespace flair::orchestrator {
namespace {

int RunningJobLimit(const config::v1::OrchestratorConfig& config) {
  if (config.running_job_limit() > 0) return config.running_job_limit();
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int QueuedJobLimit(const config::v1::OrchestratorConfig& config) {
  return config.queued_job_limit() > 0 ? config.queued_job_limit() : 10000;
}

PipelineOptions MakePipelineOptions(const config::v1::OrchestratorConfig& config, const std::string& build,
                                    EventHub& hub) {
  PipelineOptions options;
  options.build = build;
  if (config.has_stage_deadline_seconds()) options.stage_deadline = absl::Seconds(config.stage_deadline_seconds());
  options.notify = [&hub](const std::string& job_id) { hub.Notify(job_id); };
  return options;
}

class Service final : public OrchestratorService {
 public:
  Service(const config::v1::OrchestratorConfig& config, runtime::WorkerContext& worker, const StageChannels& channels,
          std::unique_ptr<JobStore> store)
      : worker_(worker),
        store_(std::move(store)),
        clients_(MakeGrpcStageClients(channels)),
        pipeline_options_(MakePipelineOptions(config, worker.build, hub_)),
        pipeline_(*store_, *clients_, worker.clock, pipeline_options_),
        runner_(*store_, pipeline_, worker.clock, *worker.logger, pipeline_options_,
                {RunningJobLimit(config), config.requested_jobs_only()}),
        handlers_(*store_, runner_, worker.clock, QueuedJobLimit(config)),
        watches_(*store_, hub_, worker),
        monitor_(*store_, {[this] { OnChange(); }, [this] { OnOwnerGone(); }}) {}

  void Stop() override {
    watches_.Stop();
    runner_.Stop();
  }

  grpc::ServerUnaryReactor* CreateJob(grpc::CallbackServerContext* context, const v1::CreateJobRequest* request,
                                      v1::CreateJobResponse* response) override {
    return Serve("CreateJob", *context, *request, *response, &OrchestratorHandlers::CreateJob);
  }
  grpc::ServerUnaryReactor* GetJob(grpc::CallbackServerContext* context, const v1::GetJobRequest* request,
                                   v1::GetJobResponse* response) override {
    return Serve("GetJob", *context, *request, *response, &OrchestratorHandlers::GetJob);
  }
  grpc::ServerUnaryReactor* ListJobs(grpc::CallbackServerContext* context, const v1::ListJobsRequest* request,
                                     v1::ListJobsResponse* response) override {
    return Serve("ListJobs", *context, *request, *response, &OrchestratorHandlers::ListJobs);
  }
  grpc::ServerUnaryReactor* CancelJob(grpc::CallbackServerContext* context, const v1::CancelJobRequest* request,
                                      v1::CancelJobResponse* response) override {
    return Serve("CancelJob", *context, *request, *response, &OrchestratorHandlers::CancelJob);
  }
  grpc::ServerUnaryReactor* CreateBatch(grpc::CallbackServerContext* context, const v1::CreateBatchRequest* request,
                                        v1::CreateBatchResponse* response) override {
    return Serve("CreateBatch", *context, *request, *response, &OrchestratorHandlers::CreateBatch);
  }
  grpc::ServerUnaryReactor* GetBatch(grpc::CallbackServerContext* context, const v1::GetBatchRequest* request,
                                     v1::GetBatchResponse* response) override {
    return Serve("GetBatch", *context, *request, *response, &OrchestratorHandlers::GetBatch);
  }
  grpc::ServerUnaryReactor* GetArtifact(grpc::CallbackServerContext* context, const v1::GetArtifactRequest* request,
                                        v1::GetArtifactResponse* response) override {
    return Serve("GetArtifact", *context, *request, *response, &OrchestratorHandlers::GetArtifact);
  }

  grpc::ServerWriteReactor<v1::WatchJobResponse>* WatchJob(grpc::CallbackServerContext*,
                                                           const v1::WatchJobRequest* request) override {
    runner_.Request({request->job_id()});
    return watches_.Start(*request);
  }

 private:
  template <typename Request, typename Response>
  grpc::ServerUnaryReactor* Serve(const char* rpc, grpc::CallbackServerContext& context, const Request& request,
                                  Response& response,
                                  absl::StatusOr<Response> (OrchestratorHandlers::*handle)(const Request&,
                                                                                           runtime::CallContext&)) {
    return runtime::StartUnary(worker_, rpc, runtime::internal::RequestIdOf(request), context,
                               [this, &request, &response, handle](runtime::CallContext& call) -> absl::Status {
                                 absl::StatusOr<Response> answer = (handlers_.*handle)(request, call);
                                 if (!answer.ok()) return answer.status();
                                 response = *std::move(answer);
                                 return absl::OkStatus();
                               });
  }

  void OnChange() {
    runner_.HonourCancelRequests();
    runner_.Wake();
    hub_.NotifyAll();
  }

  void OnOwnerGone() {
    const absl::Status status = store_->ReleaseDeadOwners();
    if (!status.ok()) worker_.logger->error("cannot look for jobs to resume: {}", std::string(status.message()));
    runner_.Wake();
  }

  // Destroyed from the last to the first: nothing is told of what has gone.
  runtime::WorkerContext& worker_;
  std::unique_ptr<JobStore> store_;
  std::unique_ptr<StageClients> clients_;
  EventHub hub_;
  const PipelineOptions pipeline_options_;
  const Pipeline pipeline_;
  JobRunner runner_;
  OrchestratorHandlers handlers_;
  JobWatches watches_;
  StoreMonitor monitor_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<OrchestratorService>> MakeOrchestratorService(
    const config::v1::OrchestratorConfig& config, runtime::WorkerContext& context, const StageChannels& channels) {
  absl::StatusOr<std::unique_ptr<JobStore>> store = JobStore::Open(config.store_path());
  if (!store.ok()) return store.status();
  context.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  return std::make_unique<Service>(config, context, channels, *std::move(store));
}

void CheckOrchestratorConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  if (config.store_path().empty()) checker.Report("store_path", "missing; expected a folder");
  checker.Range("running_job_limit", config.running_job_limit(), 0, 256);
  checker.Range("queued_job_limit", config.queued_job_limit(), 0, 1000000);
  if (config.has_stage_deadline_seconds()) {
    checker.Range("stage_deadline_seconds", config.stage_deadline_seconds(), 0.001, 86400);
  }
  const std::pair<const char*, const std::string&> stages[] = {{"stages.language", config.stages().language()},
                                                               {"stages.translator", config.stages().translator()},
                                                               {"stages.optimizer", config.stages().optimizer()},
                                                               {"stages.renderer", config.stages().renderer()}};
  for (const auto& [path, address] : stages) {
    if (address.empty()) checker.Report(path, "missing; expected HOST:PORT, unix:PATH or dns:///NAME:PORT");
  }
}

}  // namespace flair::orchestrator
