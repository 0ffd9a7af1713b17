// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/watch_job.h"

#include <fmt/format.h>

#include <deque>
#include <memory>

#include "worker_runtime/grpc/status.h"

namespace flair::orchestrator {
namespace {
// Events read from the store at once.
constexpr int kReadLimit = 64;
}  // namespace

// One stream. Shared by gRPC (until OnDone), by JobWatches and by calls of the hub that are under way.
class JobWatches::Watch final : public grpc::ServerWriteReactor<v1::WatchJobResponse>,
                                public std::enable_shared_from_this<Watch> {
 public:
  Watch(JobWatches& owner, const v1::WatchJobRequest& request)
      : owner_(owner), job_id_(request.job_id()), sequence_(request.after_sequence()) {}

  // Looks the job up and begins; on a thread that may wait for the store.
  void Begin() {
    {
      // Once the stream has ended, the store and the hub may be gone: neither is used without a look, under the lock.
      std::lock_guard lock(mutex_);
      if (ended_) return;
      const absl::StatusOr<v1::Job> job = owner_.store_.jobs().Get(job_id_);
      if (!job.ok()) return EndLocked(job.status());
      std::weak_ptr<Watch> self = weak_from_this();
      subscription_ = owner_.hub_.Subscribe(job_id_, [self] {
        if (const auto watch = self.lock()) watch->Pump();
      });
    }
    Pump();
  }

  // Writes the next event if there is one and none is being written.
  void Pump() {
    std::lock_guard lock(mutex_);
    if (writing_ || ended_) return;
    if (pending_.empty()) {
      auto events = owner_.store_.events().After(job_id_, sequence_, kReadLimit);
      if (!events.ok()) return EndLocked(events.status());
      pending_.assign(events->begin(), events->end());
    }
    if (pending_.empty()) return;
    *response_.mutable_event() = std::move(pending_.front());
    pending_.pop_front();
    sequence_ = response_.event().sequence();
    writing_ = true;
    StartWrite(&response_);
  }

  void End(const absl::Status& status) {
    std::lock_guard lock(mutex_);
    EndLocked(status);
  }

 private:
  void OnWriteDone(bool ok) override {
    {
      std::lock_guard lock(mutex_);
      writing_ = false;
      if (!ok) return EndLocked(absl::CancelledError("the watcher has gone"));
      if (response_.event().kind() == v1::JOB_EVENT_KIND_ENDED) return EndLocked(absl::OkStatus());
    }
    Pump();
  }
  void OnCancel() override { End(absl::CancelledError("the watcher has gone")); }
  void OnDone() override {
    if (subscription_ != 0) owner_.hub_.Unsubscribe(subscription_);
    const std::shared_ptr<Watch> self = shared_from_this();
    std::lock_guard lock(owner_.mutex_);
    owner_.watches_.erase(self);
  }

  void EndLocked(const absl::Status& status) {
    if (ended_) return;
    ended_ = true;
    owner_.worker_.logger->info("WatchJob job_id={} {}", job_id_, absl::StatusCodeToString(status.code()));
    Finish(runtime::ToGrpcStatus(status));
  }

  JobWatches& owner_;
  const std::string job_id_;
  int subscription_ = 0;
  std::mutex mutex_;
  int64_t sequence_;
  std::deque<v1::JobEvent> pending_;
  v1::WatchJobResponse response_;
  bool writing_ = false;
  bool ended_ = false;
};

grpc::ServerWriteReactor<v1::WatchJobResponse>* JobWatches::Start(const v1::WatchJobRequest& request) {
  auto watch = std::make_shared<Watch>(*this, request);
  bool stopped;
  {
    std::lock_guard lock(mutex_);
    watches_.insert(watch);
    stopped = stopped_;
  }
  if (stopped) {
    watch->End(absl::UnavailableError("the orchestrator is stopping; watch again when it is back"));
  } else if (!worker_.executor.TrySubmit([watch] { watch->Begin(); })) {
    watch->End(absl::ResourceExhaustedError("WatchJob: the queue is full; try again later"));
  }
  return watch.get();
}

void JobWatches::Stop() {
  std::set<std::shared_ptr<Watch>> watches;
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
    watches = watches_;
  }
  for (const auto& watch : watches) {
    watch->End(absl::UnavailableError("the orchestrator is stopping; watch again when it is back"));
  }
}

}  // namespace flair::orchestrator
