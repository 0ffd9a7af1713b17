// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/watches.h"

#include <fmt/format.h>

#include <deque>
#include <utility>

#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {
// Read from the queue at once.
constexpr int kReadLimit = 64;
}  // namespace

WatchSource<v1::WatchJobResponse> JobSource(WorkQueue& queue, const std::string& job_id,
                                            std::function<absl::Status()> admit) {
  WatchSource<v1::WatchJobResponse> source;
  source.rpc = "WatchJob";
  source.id = job_id;
  source.ids.job_id = job_id;
  source.admit = std::move(admit);
  source.next = [&queue, job_id](int64_t after) -> absl::StatusOr<std::vector<v1::WatchJobResponse>> {
    ASSIGN_OR_RETURN(auto events, queue.EventsAfter(job_id, after, kReadLimit));
    std::vector<v1::WatchJobResponse> responses(events.size());
    for (size_t i = 0; i < responses.size(); ++i) *responses[i].mutable_event() = std::move(events[i]);
    return responses;
  };
  source.has_ended = [&queue, job_id](int64_t after) -> absl::StatusOr<bool> {
    // An end that was retried is followed by other events.
    if (after == 0) return false;
    ASSIGN_OR_RETURN(const auto last, queue.EventsAfter(job_id, after - 1, 2));
    return last.size() == 1 && last.front().kind() == v1::JOB_EVENT_KIND_ENDED;
  };
  source.sequence_of = [](const v1::WatchJobResponse& response) { return response.event().sequence(); };
  return source;
}

WatchSource<v1::WatchBatchResponse> BatchSource(WorkQueue& queue, const std::string& batch_id,
                                                std::function<absl::Status()> admit) {
  WatchSource<v1::WatchBatchResponse> source;
  source.rpc = "WatchBatch";
  source.id = batch_id;
  source.ids.batch_id = batch_id;
  source.admit = std::move(admit);
  source.next = [&queue, batch_id](int64_t after) -> absl::StatusOr<std::vector<v1::WatchBatchResponse>> {
    ASSIGN_OR_RETURN(const auto ends, queue.EndsAfter(batch_id, after, kReadLimit));
    std::vector<v1::WatchBatchResponse> responses;
    for (const BatchEnd& end : ends) {
      ASSIGN_OR_RETURN(v1::Job job, queue.GetJob(end.job_id));
      responses.emplace_back().set_sequence(end.sequence);
      *responses.back().mutable_job() = std::move(job);
    }
    return responses;
  };
  source.has_ended = [&queue, batch_id](int64_t after) -> absl::StatusOr<bool> {
    const absl::StatusOr<bool> ended = queue.BatchHasEnded(batch_id);
    if (!ended.ok() || !*ended) return ended;
    // One may have ended since the last look.
    ASSIGN_OR_RETURN(const auto ends, queue.EndsAfter(batch_id, after, 1));
    return ends.empty();
  };
  source.sequence_of = [](const v1::WatchBatchResponse& response) { return response.sequence(); };
  return source;
}

namespace {

absl::Status Stopping() { return absl::UnavailableError("the orchestrator is stopping; watch again when it is back"); }

}  // namespace

// A stream of any kind.
class WatchStream {
 public:
  virtual ~WatchStream() = default;
  virtual void End(const absl::Status& status) = 0;
};

// Shared by gRPC (until OnDone), by Watches and by calls of the hub that are under way.
template <typename Response>
class Watches::Stream final : public grpc::ServerWriteReactor<Response>,
                              public WatchStream,
                              public std::enable_shared_from_this<Stream<Response>> {
 public:
  Stream(Watches& owner, WatchSource<Response> source, int64_t after_sequence)
      : owner_(owner),
        source_(std::move(source)),
        sequence_(after_sequence),
        record_(owner.worker_, source_.rpc, source_.ids) {}

  // Looks whether it may, and begins; on a thread that may wait for the queue.
  void Begin() {
    {
      // Once the stream has ended, the queue and the hub may be gone: neither is used without a look, under the lock.
      std::lock_guard lock(mutex_);
      if (ended_) return;
      record_.Begin();
      if (const absl::Status admitted = source_.admit(); !admitted.ok()) return EndLocked(admitted);
      std::weak_ptr<Stream> self = this->weak_from_this();
      subscription_ = owner_.hub_.Subscribe(source_.id, [self] {
        if (const auto stream = self.lock()) stream->Pump();
      });
    }
    Pump();
  }

  // Writes what comes next if there is something and nothing is being written.
  void Pump() {
    std::lock_guard lock(mutex_);
    if (writing_ || ended_) return;
    if (pending_.empty()) {
      absl::StatusOr<std::vector<Response>> next = source_.next(sequence_);
      if (!next.ok()) return EndLocked(next.status());
      pending_.assign(std::make_move_iterator(next->begin()), std::make_move_iterator(next->end()));
    }
    if (pending_.empty()) {
      const absl::StatusOr<bool> over = source_.has_ended(sequence_);
      if (!over.ok() || *over) EndLocked(over.status());
      return;
    }
    response_ = std::move(pending_.front());
    pending_.pop_front();
    sequence_ = source_.sequence_of(response_);
    writing_ = true;
    ++message_count_;
    this->StartWrite(&response_);
  }

  void Refuse() {
    std::lock_guard lock(mutex_);
    EndLocked(record_.Refuse());
  }

  void End(const absl::Status& status) override {
    std::lock_guard lock(mutex_);
    EndLocked(status);
  }

 private:
  void OnWriteDone(bool ok) override {
    {
      std::lock_guard lock(mutex_);
      writing_ = false;
      if (!ok) return EndLocked(absl::CancelledError("the watcher is gone"));
    }
    // gRPC's thread does not wait for the queue.
    const std::shared_ptr<Stream> self = this->shared_from_this();
    if (!owner_.worker_.executor.TrySubmit([self] { self->Pump(); })) Pump();
  }
  void OnCancel() override { End(absl::CancelledError("the watcher is gone")); }
  void OnDone() override {
    if (subscription_ != 0) owner_.hub_.Unsubscribe(subscription_);
    owner_.Remove(this->shared_from_this());
  }

  void EndLocked(const absl::Status& status) {
    if (ended_) return;
    ended_ = true;
    record_.End(status, message_count_);
    this->Finish(runtime::ToGrpcStatus(status));
  }

  Watches& owner_;
  const WatchSource<Response> source_;
  int subscription_ = 0;
  std::mutex mutex_;
  int64_t sequence_;
  runtime::RpcRecord record_;
  int64_t message_count_ = 0;
  std::deque<Response> pending_;
  Response response_;
  bool writing_ = false;
  bool ended_ = false;
};

template <typename Response>
grpc::ServerWriteReactor<Response>* Watches::Start(WatchSource<Response> source, int64_t after_sequence) {
  auto stream = std::make_shared<Stream<Response>>(*this, std::move(source), after_sequence);
  bool stopped;
  {
    std::lock_guard lock(mutex_);
    streams_.insert(stream);
    stopped = stopped_;
  }
  if (stopped) {
    stream->End(Stopping());
  } else if (!worker_.executor.TrySubmit([stream] { stream->Begin(); })) {
    stream->Refuse();
  }
  return stream.get();
}

template grpc::ServerWriteReactor<v1::WatchJobResponse>* Watches::Start(WatchSource<v1::WatchJobResponse>, int64_t);
template grpc::ServerWriteReactor<v1::WatchBatchResponse>* Watches::Start(WatchSource<v1::WatchBatchResponse>, int64_t);

void Watches::Remove(const std::shared_ptr<WatchStream>& stream) {
  std::lock_guard lock(mutex_);
  streams_.erase(stream);
}

void Watches::Stop() {
  std::set<std::shared_ptr<WatchStream>> streams;
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
    streams = streams_;
  }
  for (const auto& stream : streams) stream->End(Stopping());
}

}  // namespace flair::orchestrator
