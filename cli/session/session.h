// SPDX-License-Identifier: GPL-3.0-or-later
// A client of an orchestrator, in this process or elsewhere.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "cli/input/artifact_shelf.h"
#include "cli/input/service_flags.h"
#include "cli/output/report_text.h"
#include "cli/progress/progress.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

// gRPC's headers are in the .cc file: they cost every file that includes them seconds.
namespace grpc {
class Channel;
}

namespace flair::cli {

class EmbeddedServices;

// Every call is made again, for a while, when the orchestrator is not reached any more, once it has answered: it may be
// restarting. Thread-safe.
class Session final : public ArtifactShelf {
 public:
  // To the orchestrator at `address`; when it is empty, to one in this process, with the `stages` that run elsewhere
  // and own ones, which ask `llm`; `orchestrator` as for EmbeddedServices::Start.
  static absl::StatusOr<std::unique_ptr<Session>> Open(const std::string& address,
                                                       const OptionalLlm& llm = std::nullopt,
                                                       const StageChoice& stages = {},
                                                       const config::v1::OrchestratorConfig& orchestrator = {});
  // `address` is for messages, such as "127.0.0.1:50050".
  Session(std::shared_ptr<grpc::Channel> channel, const std::string& address);
  ~Session() override;

  struct Limits {
    // How long somebody who has answered before may be silent.
    absl::Duration patience = absl::Seconds(7);
    // How long it may say that what it needs itself, such as the servers of its queue, is silent; at least `patience`.
    absl::Duration outage = absl::ZeroDuration();
    absl::Duration answer_within = absl::Seconds(30);
    // Ends every call with CANCELLED, and outlives the session.
    runtime::Cancellation* stop = nullptr;
  };
  // Before the first call.
  void SetLimits(const Limits& limits);
  // Whether the calls have been asked to end.
  bool stopped() const;

  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) override;
  // Among the latest 1000 jobs.
  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) override;
  std::string name() const override { return "the orchestrator at " + address(); }

  // Jobs.

  absl::StatusOr<v1::Job> CreateJob(const v1::JobSpec& spec);
  absl::StatusOr<v1::Job> GetJob(const std::string& id) override;
  absl::StatusOr<v1::Job> CancelJob(const std::string& id);
  absl::StatusOr<v1::DeleteJobResponse> DeleteJob(const std::string& id);
  // Newest first, at most `count`.
  absl::StatusOr<std::vector<v1::Job>> ListJobs(int count);
  // Calls `see` for every event until the job ends. Goes on where it was when the connection breaks.
  absl::Status Watch(const std::string& id, const std::function<void(const v1::JobEvent&)>& see);

  // Batches.

  // An open batch; the same one when the request made it before.
  absl::StatusOr<v1::Batch> CreateBatch(const std::string& request_id, const std::string& label);
  // Waits, calling `full`, while the queue is full. Otherwise as OrchestratorService.AddToBatch.
  absl::StatusOr<v1::Batch> AddToBatch(const v1::AddToBatchRequest& request,
                                       const std::function<void(const std::string& why)>& full);
  absl::StatusOr<v1::Batch> GetBatch(const std::string& id);
  // Newest first, at most `count`.
  absl::StatusOr<std::vector<v1::Batch>> ListBatches(int count);
  absl::StatusOr<v1::Batch> PauseBatch(const std::string& id);
  absl::StatusOr<v1::Batch> ResumeBatch(const std::string& id);
  absl::StatusOr<v1::Batch> CancelBatch(const std::string& id);
  absl::StatusOr<v1::RetryBatchResponse> RetryBatch(const v1::RetryBatchRequest& request);
  // One step of it.
  absl::StatusOr<v1::DeleteBatchResponse> DeleteBatch(const std::string& id);
  absl::StatusOr<v1::GetClusterResponse> GetCluster();
  // Calls `see` for every end after a sequence number until the batch is closed and all its jobs have ended, until
  // `see` returns false, or until `enough` is asked for. Goes on where it was when the connection breaks.
  absl::Status WatchBatch(const std::string& id, int64_t after_sequence, runtime::Cancellation& enough,
                          const std::function<bool(const v1::WatchBatchResponse&)>& see);

  bool embedded() const;
  // To the orchestrator, for other classes of calls.
  const std::shared_ptr<grpc::Channel>& channel() const;
  const std::string& address() const;

 private:
  struct Calls;
  explicit Session(std::unique_ptr<Calls> calls);
  const std::unique_ptr<Calls> calls_;
};

// Of which stages no worker works, "no optimizer worker works: 10.0.0.4:50053 is gone"; empty when all can go on.
std::string StagesAway(const v1::GetClusterResponse& cluster);

// Waits, at most until `stop` is asked for. Returns whether it was.
bool WaitUnlessStopped(runtime::Cancellation& stop, absl::Duration time);

// How a job ended, and what came of it.

// What a failed job ends the program with. A model's failures have an exit code of their own.
absl::Status ErrorOf(const v1::Job& job);

// Shows `progress` what happens until the job ends; OK when it succeeded.
absl::Status WaitForJob(Session& session, const std::string& id, Progress& progress);

// The artifacts that a job has stored so far. DATA_LOSS when one is not what it was.
absl::StatusOr<ArtifactsByKind> StoredArtifacts(Session& session, const v1::Job& job);

// The same of a job that succeeded, with a layout and a picture.
absl::StatusOr<ArtifactsByKind> CollectArtifacts(Session& session, const v1::Job& job);

}  // namespace flair::cli
