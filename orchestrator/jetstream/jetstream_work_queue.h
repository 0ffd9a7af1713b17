// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/batch/repeater.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/artifact_users.h"
#include "orchestrator/jetstream/batch_repair.h"
#include "orchestrator/jetstream/consumers.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/lease_keeper.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// The queue on NATS servers; see docs/decisions/0017-jobs-wait-in-jetstream.md for how, and names.h for what is where.
// Two threads of its own besides the keeper's: one reads notices, one looks every second, since notices may be lost.
class JetStreamWorkQueue final : public WorkQueue {
 public:
  static absl::StatusOr<std::unique_ptr<WorkQueue>> Open(std::unique_ptr<QueueParts> parts);
  ~JetStreamWorkQueue() override;

  void Listen(Listener listener) override;

  absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id) override;
  absl::StatusOr<store::v1::BatchRecord> CreateBatch(const store::v1::BatchRecord& batch) override;
  absl::StatusOr<bool> HasRequest(RequestKind kind, const std::string& owner, const std::string& request_id) override;
  absl::StatusOr<v1::Batch> AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs, bool last) override;
  absl::Status Cancel(const std::string& job_id, absl::Time now) override;
  absl::StatusOr<bool> Retry(const std::string& job_id) override;
  absl::Status SetBatchState(const std::string& batch_id, v1::BatchState state) override;
  absl::Status CancelBatch(const std::string& batch_id, absl::Time now) override;

  absl::StatusOr<Deleted> DeleteJob(const std::string& job_id, ArtifactStore& artifacts) override;
  absl::StatusOr<Deleted> DeleteBatch(const std::string& batch_id, int job_limit, ArtifactStore& artifacts) override;
  absl::StatusOr<Deleted> FinishDeletions(ArtifactStore& artifacts) override;
  absl::StatusOr<EndedPage> EndedBefore(absl::Time time, const std::string& after, int limit) override;

  absl::StatusOr<std::unique_ptr<Lease>> Take(const TakeFilter& filter) override;
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key) override;

  absl::StatusOr<v1::Job> GetJob(const std::string& job_id) override;
  absl::StatusOr<std::vector<v1::Job>> ListJobs(const ListFilter& filter) override;
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence,
                                                        int limit) override;
  absl::StatusOr<v1::Batch> GetBatch(const std::string& batch_id) override;
  absl::StatusOr<v1::Batch> FindBatch(const std::string& batch_id) override;
  absl::StatusOr<std::vector<v1::Batch>> ListBatches(const ListFilter& filter) override;
  absl::StatusOr<bool> BatchHasEnded(const std::string& batch_id) override;
  absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit) override;
  absl::StatusOr<int64_t> CountQueued() override;
  absl::StatusOr<int64_t> CountOpen(const std::string& owner) override;
  absl::StatusOr<bool> OwnsArtifact(const std::string& owner, const std::string& artifact_id) override;

  absl::Status ReportStatus(const v1::OrchestratorStatus& status) override;
  absl::StatusOr<std::vector<v1::OrchestratorStatus>> Orchestrators() override;

 private:
  explicit JetStreamWorkQueue(std::unique_ptr<QueueParts> parts);
  absl::Status Start();

  // requests.cc
  absl::StatusOr<std::string> IdOfRequest(const std::string& key, const std::string& id);
  absl::Status AddRecords(const std::string& batch_id, std::span<const v1::Job> jobs);
  absl::Status CompareSpecs(std::span<const v1::Job> jobs);
  absl::Status PutIntoQueue(std::span<const v1::Job> jobs);

  // delete.cc
  std::string NoteKey(const std::string& owner, const std::string& id) const;
  absl::Status RemoveNote(const std::string& owner, const std::string& id);
  absl::Status RemoveRequest(const std::string& key, const std::string& id);
  absl::StatusOr<int64_t> DeleteArtifacts(std::span<const std::string> ids, const std::string& user_id,
                                          ArtifactStore& artifacts);
  absl::StatusOr<Deleted> ForgetJob(const std::string& job_id, const std::string& owner, ArtifactStore& artifacts);
  absl::StatusOr<RevisedBatch> BeginToDelete(const std::string& batch_id);
  absl::StatusOr<int64_t> ForgetPlaces(const std::string& batch_id, int64_t first, int64_t end);
  absl::Status DeleteTombstoned(const std::string& batch_id, int64_t all, int64_t job_limit, ArtifactStore& artifacts,
                                Deleted& deleted);
  absl::Status ForgetBatch(const store::v1::BatchRecord& record);

  // list.cc
  absl::StatusOr<bool> BatchEndedBefore(absl::Time time, const std::string& batch_id);

  // take.cc
  absl::StatusOr<std::unique_ptr<Lease>> TakeFrom(const Consumer& consumer, int& passed_over);
  absl::StatusOr<std::unique_ptr<Lease>> Begin(const Consumer& consumer, const Delivery& delivery,
                                               bool batch_cancelled);
  absl::StatusOr<bool> MayRun(const Delivery& delivery, const store::v1::JobRecord& record, bool batch_cancelled);
  absl::StatusOr<bool> OtherMessageRuns(const Delivery& delivery, const store::v1::JobRecord& record);
  absl::StatusOr<v1::BatchState> BatchStateOf(const Consumer& consumer);
  absl::Status WantNamed(const std::set<std::string>& job_ids);
  void Acknowledge(const Delivery& delivery, const std::string& how);

  // list.cc
  absl::StatusOr<std::vector<v1::Job>> ListOfBatch(const ListFilter& filter);
  absl::StatusOr<std::vector<v1::Job>> GetJobs(std::span<const std::string> ids, const ListFilter& filter);

  absl::Status VisitRequests(const ListFilter& filter, const std::string& kind, const std::function<bool()>& more,
                             const std::function<absl::Status(const std::string& kind, const std::string& id)>& visit);

  // watch.cc
  void ReadNotices();
  absl::Duration Look();
  void LookOnce();
  void NotifyListenerOfWork();
  void NotifyListenerOfJob(const std::string& job_id);
  void NotifyListenerOfBatch(const std::string& batch_id);
  void ScheduleRepair(const std::string& batch_id);
  void Queued(const std::string& consumer);

  const std::unique_ptr<QueueParts> parts_;
  // Unique among the processes of a queue.
  const std::string process_;
  JobEnds ends_;
  Consumers consumers_;
  BatchRepair repair_;
  ArtifactUsers users_;
  LeaseKeeper keeper_;
  std::atomic<int64_t> next_run_ = 1;

  std::mutex listener_mutex_;
  Listener listener_;

  std::mutex repair_mutex_;
  // Batches to be looked at.
  std::set<std::string> to_repair_;
  std::unique_ptr<NatsInbox> notices_;
  std::thread notice_thread_;
  // Of the thread that looks.
  int looks_ = 0;
  int64_t reconnects_ = 0;
  std::optional<Repeater> looker_;
};

}  // namespace flair::orchestrator
