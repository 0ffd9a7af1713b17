// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "absl/strings/numbers.h"
#include "orchestrator/service/orchestrator_handlers.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {
// Read from the queue at once.
constexpr int kReadLimit = 64;

// What is still known of a job whose record is lost: others of its batch are watched on.
v1::Job LostJob(const std::string& batch_id, const BatchEnd& end, const absl::Status& why) {
  v1::Job job;
  job.set_id(end.job_id);
  job.set_batch_id(batch_id);
  int64_t index = 0;
  if (absl::SimpleAtoi(end.job_id.substr(std::min(end.job_id.size(), batch_id.size() + 1)), &index)) {
    job.set_batch_index(index);
  }
  job.set_state(v1::JOB_STATE_FAILED);
  job.set_failure_kind(v1::FAILURE_KIND_STORE);
  job.set_error_code(static_cast<int>(absl::StatusCode::kDataLoss));
  job.set_error(fmt::format("the record of the job is lost: {}", std::string(why.message())));
  return job;
}
}  // namespace

WatchSource<v1::WatchJobResponse> JobSource(WorkQueue& queue, const std::string& job_id) {
  WatchSource<v1::WatchJobResponse> source;
  source.id = job_id;
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

WatchSource<v1::WatchBatchResponse> BatchSource(WorkQueue& queue, const std::string& batch_id) {
  WatchSource<v1::WatchBatchResponse> source;
  source.id = batch_id;
  source.next = [&queue, batch_id](int64_t after) -> absl::StatusOr<std::vector<v1::WatchBatchResponse>> {
    ASSIGN_OR_RETURN(const auto ends, queue.EndsAfter(batch_id, after, kReadLimit));
    std::vector<v1::WatchBatchResponse> responses;
    for (const BatchEnd& end : ends) {
      absl::StatusOr<v1::Job> job = queue.GetJob(end.job_id);
      if (absl::IsNotFound(job.status()) || absl::IsDataLoss(job.status())) job = LostJob(batch_id, end, job.status());
      RETURN_IF_ERROR(job.status());
      responses.emplace_back().set_sequence(end.sequence);
      *responses.back().mutable_job() = *std::move(job);
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
class Watches::Stream final : public grpc::ServerBidiReactor<grpc::ByteBuffer, Response>,
                              public WatchStream,
                              public std::enable_shared_from_this<Stream<Response>> {
 public:
  // What to read, by the request; sets what is known by then.
  using Open = std::function<absl::StatusOr<WatchSource<Response>>(grpc::ByteBuffer&, int64_t& after_sequence,
                                                                   runtime::CallIds& ids)>;

  Stream(Watches& owner, const std::string& rpc, const std::string& caller, Open open)
      : owner_(owner), open_(std::move(open)), record_(owner.worker_, rpc) {
    record_.SetCaller(caller);
  }

  void ReadRequest() { this->StartRead(&request_); }

  // Looks whether it may, and begins; on a thread that may wait for the queue.
  void Begin() {
    {
      // Once the stream has ended, the queue and the hub may be gone: neither is used without a look, under the lock.
      std::lock_guard lock(mutex_);
      if (ended_) return;
      record_.Begin();
      runtime::CallIds ids;
      absl::StatusOr<WatchSource<Response>> source = open_(request_, sequence_, ids);
      record_.SetIds(std::move(ids));
      if (!source.ok()) return EndLocked(source.status());
      source_ = *std::move(source);
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

  void End(const absl::Status& status) override {
    std::lock_guard lock(mutex_);
    EndLocked(status);
  }

 private:
  void OnReadDone(bool ok) override {
    if (!ok) return End(absl::InvalidArgumentError("the call has no request"));
    const std::shared_ptr<Stream> self = this->shared_from_this();
    if (owner_.worker_.executor.TrySubmit([self] { self->Begin(); })) return;
    std::lock_guard lock(mutex_);
    EndLocked(record_.Refuse());
  }
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
  const Open open_;
  grpc::ByteBuffer request_;
  WatchSource<Response> source_;
  int subscription_ = 0;
  std::mutex mutex_;
  int64_t sequence_ = 0;
  runtime::RpcRecord record_;
  int64_t message_count_ = 0;
  std::deque<Response> pending_;
  Response response_;
  bool writing_ = false;
  bool ended_ = false;
};

template <typename Request, typename Response>
grpc::ServerBidiReactor<grpc::ByteBuffer, Response>* Watches::Start(
    const std::string& rpc, const std::string& caller, const absl::Status& admitted,
    std::function<absl::StatusOr<WatchSource<Response>>(const Request&)> open) {
  const auto open_bytes = [open = std::move(open)](grpc::ByteBuffer& bytes, int64_t& after_sequence,
                                                   runtime::CallIds& ids) -> absl::StatusOr<WatchSource<Response>> {
    Request request;
    RETURN_IF_ERROR(runtime::ParseShortMessage(bytes, request));
    after_sequence = request.after_sequence();
    ids = runtime::CallIdsOf(request);
    return open(request);
  };
  auto stream = std::make_shared<Stream<Response>>(*this, rpc, caller, open_bytes);
  bool stopped;
  {
    std::lock_guard lock(mutex_);
    streams_.insert(stream);
    stopped = stopped_;
  }
  if (stopped || !admitted.ok()) {
    stream->End(stopped ? Stopping() : admitted);
  } else {
    stream->ReadRequest();
  }
  return stream.get();
}

template grpc::ServerBidiReactor<grpc::ByteBuffer, v1::WatchJobResponse>* Watches::Start(
    const std::string&, const std::string&, const absl::Status&,
    std::function<absl::StatusOr<WatchSource<v1::WatchJobResponse>>(const v1::WatchJobRequest&)>);
template grpc::ServerBidiReactor<grpc::ByteBuffer, v1::WatchBatchResponse>* Watches::Start(
    const std::string&, const std::string&, const absl::Status&,
    std::function<absl::StatusOr<WatchSource<v1::WatchBatchResponse>>(const v1::WatchBatchRequest&)>);

void Watches::Remove(const std::shared_ptr<WatchStream>& stream) {
  std::lock_guard lock(mutex_);
  streams_.erase(stream);
}

void Watches::Stop() {
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  EndAll(Stopping());
}

void Watches::EndAll(const absl::Status& status) {
  std::set<std::shared_ptr<WatchStream>> streams;
  {
    std::lock_guard lock(mutex_);
    streams = streams_;
  }
  for (const auto& stream : streams) stream->End(status);
}

}  // namespace flair::orchestrator
