// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "flair/v1/orchestrator_service.grpc.pb.h"

namespace flair::cli {

// An orchestrator that runs nothing: jobs are what the test says that they are. Served in this process.
class FakeBatchService final : public v1::OrchestratorService::Service {
 public:
  FakeBatchService();
  ~FakeBatchService() override;
  std::shared_ptr<grpc::Channel> channel() const { return channel_; }

  // ---- What the test wants

  // Ends a job: succeeded with a layout, a picture and a report, or failed when `error` is not empty.
  void End(int64_t index, const std::string& error = "");
  void CloseBatch();
  // The next calls fail.
  void FailAdds(std::vector<grpc::Status> statuses);
  void FailArtifacts(std::vector<grpc::Status> statuses);
  // Specs with this text are INVALID_ARGUMENT.
  void Refuse(const std::string& text) { refused_text_ = text; }

  // Calls that the deletion of a batch takes: each deletes 10 jobs and 20 artifacts.
  void SetDeletionSteps(int steps) { deletion_steps_ = steps; }

  // ---- What it saw

  std::vector<v1::JobSpec> specs();
  // Places of the first job of each AddToBatch that it took.
  std::vector<int64_t> adds();
  int artifact_calls();
  bool open();
  std::vector<std::string> request_ids();

  grpc::Status CreateBatch(grpc::ServerContext*, const v1::CreateBatchRequest*, v1::CreateBatchResponse*) override;
  grpc::Status AddToBatch(grpc::ServerContext*, const v1::AddToBatchRequest*, v1::AddToBatchResponse*) override;
  grpc::Status DeleteBatch(grpc::ServerContext*, const v1::DeleteBatchRequest*, v1::DeleteBatchResponse*) override;
  grpc::Status GetBatch(grpc::ServerContext*, const v1::GetBatchRequest*, v1::GetBatchResponse*) override;
  grpc::Status WatchBatch(grpc::ServerContext*, const v1::WatchBatchRequest*,
                          grpc::ServerWriter<v1::WatchBatchResponse>*) override;
  grpc::Status GetArtifact(grpc::ServerContext*, const v1::GetArtifactRequest*, v1::GetArtifactResponse*) override;

 private:
  v1::ArtifactRef Store(v1::Artifact artifact);
  v1::Batch Standing() const;

  std::mutex mutex_;
  bool open_ = true;
  std::vector<v1::Job> jobs_;
  std::vector<int64_t> adds_;
  std::vector<std::string> request_ids_;
  // Sequence and place.
  std::map<int64_t, int64_t> ends_;
  int64_t last_sequence_ = 0;
  std::map<std::string, v1::Artifact> artifacts_;
  std::vector<grpc::Status> add_faults_;
  std::vector<grpc::Status> artifact_faults_;
  std::string refused_text_;
  int artifact_calls_ = 0;
  std::atomic<int> deletion_steps_ = 1;
  std::unique_ptr<grpc::Server> server_;
  std::shared_ptr<grpc::Channel> channel_;
};

}  // namespace flair::cli
