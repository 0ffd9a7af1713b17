// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/testing/fake_batch_service.h"

#include <grpcpp/server_builder.h>

#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

constexpr char kBatchId[] = "b1";

// The next fault; OK when there is none.
grpc::Status Next(std::vector<grpc::Status>& faults) {
  if (faults.empty()) return grpc::Status::OK;
  const grpc::Status fault = faults.front();
  faults.erase(faults.begin());
  return fault;
}

}  // namespace

FakeBatchService::FakeBatchService() {
  grpc::ServerBuilder builder;
  builder.RegisterService(this);
  server_ = builder.BuildAndStart();
  channel_ = server_->InProcessChannel({});
}

FakeBatchService::~FakeBatchService() { server_->Shutdown(); }

v1::ArtifactRef FakeBatchService::Store(v1::Artifact artifact) {
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  v1::ArtifactRef ref;
  ref.set_id(artifact.id());
  ref.set_kind(orchestrator::KindOf(artifact));
  artifacts_[artifact.id()] = std::move(artifact);
  return ref;
}

void FakeBatchService::End(int64_t index, const std::string& error) {
  const std::lock_guard lock(mutex_);
  v1::Job& job = jobs_[static_cast<size_t>(index)];
  std::erase_if(ends_, [index](const auto& end) { return end.second == index; });
  ends_[last_sequence_ += 5] = index;
  v1::Artifact layout;
  layout.mutable_solved_layout()->set_total_cost(static_cast<double>(index));
  *job.add_artifacts() = Store(layout);
  if (!error.empty()) {
    job.set_state(v1::JOB_STATE_FAILED);
    job.set_failure_kind(v1::FAILURE_KIND_WORKER);
    job.set_stage("render");
    job.set_error(error);
    return;
  }
  job.set_state(v1::JOB_STATE_SUCCEEDED);
  v1::Artifact picture;
  picture.mutable_preview()->set_view(v1::PREVIEW_VIEW_PLAN);
  picture.mutable_preview()->set_format(v1::PREVIEW_FORMAT_PNG);
  picture.mutable_preview()->set_image(fmt::format("picture {}", index));
  *job.add_artifacts() = Store(picture);
  v1::Artifact report;
  report.mutable_report()->set_job_id(job.id());
  report.mutable_report()->mutable_metrics()->set_pathway_cost_m3(0.25);
  *job.add_artifacts() = Store(report);
}

void FakeBatchService::CloseBatch() {
  const std::lock_guard lock(mutex_);
  open_ = false;
}

void FakeBatchService::FailAdds(std::vector<grpc::Status> statuses) {
  const std::lock_guard lock(mutex_);
  add_faults_ = std::move(statuses);
}

void FakeBatchService::FailArtifacts(std::vector<grpc::Status> statuses) {
  const std::lock_guard lock(mutex_);
  artifact_faults_ = std::move(statuses);
}

std::vector<v1::JobSpec> FakeBatchService::specs() {
  const std::lock_guard lock(mutex_);
  std::vector<v1::JobSpec> specs;
  for (const v1::Job& job : jobs_) specs.push_back(job.spec());
  return specs;
}

std::vector<int64_t> FakeBatchService::adds() {
  const std::lock_guard lock(mutex_);
  return adds_;
}

int FakeBatchService::artifact_calls() {
  const std::lock_guard lock(mutex_);
  return artifact_calls_;
}

bool FakeBatchService::open() {
  const std::lock_guard lock(mutex_);
  return open_;
}

std::vector<std::string> FakeBatchService::request_ids() {
  const std::lock_guard lock(mutex_);
  return request_ids_;
}

v1::Batch FakeBatchService::Standing() const {
  v1::Batch batch;
  batch.set_id(kBatchId);
  batch.set_state(v1::BATCH_STATE_ACTIVE);
  batch.set_open(open_);
  batch.set_job_count(static_cast<int>(jobs_.size()));
  return batch;
}

grpc::Status FakeBatchService::CreateBatch(grpc::ServerContext*, const v1::CreateBatchRequest* request,
                                           v1::CreateBatchResponse* response) {
  const std::lock_guard lock(mutex_);
  request_ids_.push_back(request->request_id());
  *response->mutable_batch() = Standing();
  return grpc::Status::OK;
}

grpc::Status FakeBatchService::AddToBatch(grpc::ServerContext*, const v1::AddToBatchRequest* request,
                                          v1::AddToBatchResponse* response) {
  const std::lock_guard lock(mutex_);
  if (grpc::Status fault = Next(add_faults_); !fault.ok()) return fault;
  for (const v1::JobSpec& spec : request->specs()) {
    if (spec.brief().text() == refused_text_) return {grpc::StatusCode::INVALID_ARGUMENT, "specs[0]: refused"};
  }
  if (request->first_index() > static_cast<int64_t>(jobs_.size())) {
    return {grpc::StatusCode::FAILED_PRECONDITION, "leaves a gap"};
  }
  adds_.push_back(request->first_index());
  for (int i = 0; i < request->specs_size(); ++i) {
    const int64_t index = request->first_index() + i;
    if (index < static_cast<int64_t>(jobs_.size())) {
      if (jobs_[static_cast<size_t>(index)].spec().SerializeAsString() != request->specs(i).SerializeAsString()) {
        return {grpc::StatusCode::ALREADY_EXISTS, "another spec"};
      }
      continue;
    }
    v1::Job& job = jobs_.emplace_back();
    job.set_id(fmt::format("j{}", index));
    job.set_state(v1::JOB_STATE_QUEUED);
    job.set_batch_index(index);
    *job.mutable_spec() = request->specs(i);
  }
  if (request->last()) open_ = false;
  *response->mutable_batch() = Standing();
  return grpc::Status::OK;
}

grpc::Status FakeBatchService::GetBatch(grpc::ServerContext*, const v1::GetBatchRequest*,
                                        v1::GetBatchResponse* response) {
  const std::lock_guard lock(mutex_);
  *response->mutable_batch() = Standing();
  return grpc::Status::OK;
}

grpc::Status FakeBatchService::DeleteBatch(grpc::ServerContext*, const v1::DeleteBatchRequest*,
                                           v1::DeleteBatchResponse* response) {
  response->set_deleted_job_count(10);
  response->set_deleted_artifact_count(20);
  response->set_done(--deletion_steps_ == 0);
  return grpc::Status::OK;
}

// Ends with what there is: as if all had ended.
grpc::Status FakeBatchService::WatchBatch(grpc::ServerContext*, const v1::WatchBatchRequest* request,
                                          grpc::ServerWriter<v1::WatchBatchResponse>* writer) {
  std::vector<v1::WatchBatchResponse> responses;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [sequence, index] : ends_) {
      if (sequence <= request->after_sequence()) continue;
      v1::WatchBatchResponse& response = responses.emplace_back();
      response.set_sequence(sequence);
      *response.mutable_job() = jobs_[static_cast<size_t>(index)];
    }
  }
  for (const v1::WatchBatchResponse& response : responses) {
    if (!writer->Write(response)) break;
  }
  return grpc::Status::OK;
}

grpc::Status FakeBatchService::GetArtifact(grpc::ServerContext*, const v1::GetArtifactRequest* request,
                                           v1::GetArtifactResponse* response) {
  const std::lock_guard lock(mutex_);
  ++artifact_calls_;
  if (grpc::Status fault = Next(artifact_faults_); !fault.ok()) return fault;
  const auto found = artifacts_.find(request->artifact_id());
  if (found == artifacts_.end()) return {grpc::StatusCode::NOT_FOUND, "no such artifact"};
  *response->mutable_artifact() = found->second;
  return grpc::Status::OK;
}

}  // namespace flair::cli
