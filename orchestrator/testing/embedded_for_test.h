// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "orchestrator/service/make_orchestrator_service.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::orchestrator {

// An orchestrator in this process with a client for it, for tests.
class EmbeddedForTest {
 public:
  EmbeddedForTest(const config::v1::OrchestratorConfig& config, const StageChannels& channels) {
    auto server = runtime::InProcessServer::Start(
        "flair-orchestrator", config.runtime(), v1::OrchestratorService::service_full_name(),
        [&](runtime::WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
          auto service = MakeOrchestratorService(config, context, channels);
          if (!service.ok()) return service.status();
          service_ = service->get();
          return *std::move(service);
        });
    status_ = server.status();
    if (!server.ok()) return;
    server_ = *std::move(server);
    stub_ = v1::OrchestratorService::NewStub(server_->channel());
  }

  const absl::Status& status() const { return status_; }
  OrchestratorService& service() { return *service_; }
  v1::OrchestratorService::Stub& stub() { return *stub_; }

  absl::StatusOr<v1::Job> CreateJob(const std::string& request_id, const v1::JobSpec& spec) {
    v1::CreateJobRequest request;
    request.set_request_id(request_id);
    *request.mutable_spec() = spec;
    auto response = Ask(&v1::OrchestratorService::StubInterface::CreateJob, request);
    if (!response.ok()) return response.status();
    return response->job();
  }

  absl::StatusOr<v1::Job> GetJob(const std::string& id) {
    v1::GetJobRequest request;
    request.set_job_id(id);
    auto response = Ask(&v1::OrchestratorService::StubInterface::GetJob, request);
    if (!response.ok()) return response.status();
    return response->job();
  }

  absl::Status CancelJob(const std::string& id) {
    v1::CancelJobRequest request;
    request.set_job_id(id);
    return Ask(&v1::OrchestratorService::StubInterface::CancelJob, request).status();
  }

  // All events until the stream ends; `status`, when given, takes how it ended.
  std::vector<v1::JobEvent> Watch(const std::string& id, int64_t after = 0, absl::Status* status = nullptr) {
    grpc::ClientContext context;
    v1::WatchJobRequest request;
    request.set_job_id(id);
    request.set_after_sequence(after);
    auto reader = stub_->WatchJob(&context, request);
    std::vector<v1::JobEvent> events;
    v1::WatchJobResponse response;
    while (reader->Read(&response)) events.push_back(response.event());
    const absl::Status end = runtime::FromGrpcStatus(reader->Finish());
    if (status != nullptr) *status = end;
    return events;
  }

  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (v1::OrchestratorService::StubInterface::*method)(grpc::ClientContext*,
                                                                                              const Request&,
                                                                                              Response*),
                               const Request& request) {
    runtime::CallContext call;
    return runtime::UnaryRequest(*stub_, method, request, call);
  }

 private:
  absl::Status status_;
  OrchestratorService* service_ = nullptr;
  std::unique_ptr<runtime::InProcessServer> server_;
  std::unique_ptr<v1::OrchestratorService::Stub> stub_;
};

}  // namespace flair::orchestrator
