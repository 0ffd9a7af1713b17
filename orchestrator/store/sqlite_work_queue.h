// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/job_store.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// The queue in a folder, for any number of processes of one machine: jobs.db (SQLite) and owners/. A process is dead
// when its lock is free, which the kernel sees to; its jobs wait again at once. No clock decides that.
class SqliteWorkQueue final : public WorkQueue {
 public:
  // Opens the folder, makes it when missing, and gives back the jobs of processes that died. Errors as JobStore::Open.
  // `clock` outlives it.
  static absl::StatusOr<std::unique_ptr<WorkQueue>> Open(const std::string& path, const runtime::Clock& clock);
  ~SqliteWorkQueue() override;

  void Listen(Listener listener) override;

  absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id,
                                    const GivenArtifact* given) override;
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
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key) override {
    return store_->jobs().FindResult(key);
  }

  absl::StatusOr<v1::Job> GetJob(const std::string& job_id) override { return store_->jobs().Get(job_id); }
  absl::StatusOr<std::vector<v1::Job>> ListJobs(const ListFilter& filter) override {
    return store_->jobs().List(filter);
  }
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence,
                                                        int limit) override {
    return store_->jobs().EventsAfter(job_id, sequence, limit);
  }
  absl::StatusOr<v1::Batch> GetBatch(const std::string& batch_id) override {
    return store_->batches().GetWithCounts(batch_id);
  }
  absl::StatusOr<v1::Batch> FindBatch(const std::string& batch_id) override { return store_->batches().Get(batch_id); }
  absl::StatusOr<std::vector<v1::Batch>> ListBatches(const ListFilter& filter) override {
    return store_->batches().List(filter);
  }
  absl::StatusOr<bool> BatchHasEnded(const std::string& batch_id) override;
  absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit) override {
    return store_->batches().EndsAfter(batch_id, sequence, limit);
  }
  absl::StatusOr<int64_t> CountQueued() override { return store_->jobs().CountQueued(); }
  absl::StatusOr<int64_t> CountOpen(const std::string& owner) override { return store_->jobs().CountOpen(owner); }
  absl::StatusOr<bool> OwnsArtifact(const std::string& owner, const std::string& artifact_id) override {
    return store_->jobs().OwnsArtifact(owner, artifact_id);
  }

  absl::Status ReportStatus(const v1::OrchestratorStatus& status) override;
  absl::StatusOr<std::vector<v1::OrchestratorStatus>> Orchestrators() override;

 private:
  friend class SqliteLease;
  SqliteWorkQueue(std::unique_ptr<JobStore> store, const runtime::Clock& clock);

  // A transaction that survives a loss of power.
  absl::StatusOr<Transaction> BeginDurable() {
    return Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
  }

  absl::StatusOr<std::string> ChooseJob(const TakeFilter& filter);
  absl::StatusOr<std::string> ChooseOfAnyBatch();
  absl::StatusOr<bool> BatchIsActive(const std::string& batch_id);
  // In a transaction of the caller's. Saves what `change` makes of the record, unless it returns false or an error, and
  // keeps the ends of batches' jobs in step.
  absl::StatusOr<store::v1::JobRecord> ChangeJob(
      const std::string& job_id, const std::function<absl::StatusOr<bool>(store::v1::JobRecord&)>& change);
  absl::Status ChangeBatch(const std::string& batch_id, const std::function<absl::StatusOr<bool>(v1::Batch&)>& change);
  absl::Status DeleteUnlessUsed(const std::string& artifact_id, ArtifactStore& artifacts, int64_t& deleted_count);
  absl::StatusOr<Deleted> RemoveLastJobs(const std::string& batch_id, int64_t limit);

  // What makes a batch go on for which nothing has happened for a second, though nobody runs a job and none waits for
  // its time. Damaged when an index has lost one.
  absl::Status CheckWhenStill();

  void NotifyChanged(const std::string& job_id);
  void NotifyBatchChanged(const std::string& batch_id);
  void NotifyWork();
  void CancelHeld(const std::string& job_id);
  void HonourCancelRequests();
  void OnChange();
  void OnOwnerGone();
  void Forget(const std::string& job_id);

  const std::unique_ptr<JobStore> store_;
  const runtime::Clock& clock_;

  std::mutex listener_mutex_;
  Listener listener_;

  std::mutex mutex_;
  // Of the jobs that run under a lease of this queue. Shared with who cancels one while its lease ends.
  std::map<std::string, std::shared_ptr<runtime::Cancellation>> held_;
  // The batch that had the last turn.
  std::string last_batch_;

  // Whether nothing has happened for a second, and the store was looked through since.
  enum class Stillness { kBusy, kStill, kChecked };
  std::atomic<Stillness> still_ = Stillness::kBusy;

  // Destroyed first: it calls back.
  std::unique_ptr<StoreMonitor> monitor_;
};

}  // namespace flair::orchestrator
