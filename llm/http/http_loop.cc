// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/http_loop.h"

#include <curl/curl.h>

#include <atomic>
#include <optional>
#include <utility>

#include "llm/http/curl_multi.h"
#include "llm/http/event_loop.h"
#include "llm/http/transfer.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::llm {
namespace {

// Once in a process, before any other use of libcurl.
void InitCurl() {
  static const CURLcode done = curl_global_init(CURL_GLOBAL_DEFAULT);
  (void)done;
}

absl::Status Stopped() { return absl::CancelledError("the HTTP client has stopped"); }

// What a request needs until it is answered.
struct Job {
  std::unique_ptr<Transfer> transfer;
  HttpCallback done;
  std::optional<runtime::OnCancel> on_cancel;
};

}  // namespace

class HttpLoop::Impl {
 public:
  Impl()
      : loop_([this](int fd, bool readable, bool writable) { multi_->OnSocket(fd, readable, writable); }),
        multi_(std::make_unique<CurlMulti>(loop_)) {}

  EventLoop& loop() { return loop_; }

  void Start(std::shared_ptr<Job> job, runtime::CallContext& call) {
    const int64_t id = next_id_++;
    const bool posted = loop_.Post([this, id, job, &call] {
      // First, as the call may end with the start.
      job->on_cancel.emplace(call.cancellation(), [this, id] {
        loop_.Post([this, id] { multi_->Abort(id, absl::CancelledError("the caller cancelled the call")); });
      });
      multi_->Start(id, std::move(job->transfer), [job](absl::StatusOr<HttpResponse> response) {
        job->on_cancel.reset();
        job->done(std::move(response));
      });
    });
    if (!posted) job->done(Stopped());
  }

  void Stop() {
    loop_.Stop([this] {
      multi_->AbortAll(Stopped());
      // Here, as closing connections tells the loop and writes to them.
      multi_.reset();
    });
  }

 private:
  std::atomic<int64_t> next_id_ = 1;
  EventLoop loop_;
  std::unique_ptr<CurlMulti> multi_;
};

HttpLoop::HttpLoop(const runtime::Clock& clock) : clock_(clock) {
  InitCurl();
  impl_ = std::make_unique<Impl>();
}

HttpLoop::~HttpLoop() { Stop(); }

runtime::Timer::Id HttpLoop::RunAfter(absl::Duration delay, runtime::TimerCallback callback) {
  return impl_->loop().RunAfter(delay, std::move(callback));
}

void HttpLoop::Hasten(Id id) { impl_->loop().Hasten(id); }

void HttpLoop::Stop() { impl_->Stop(); }

void HttpLoop::Start(HttpRequest request, const HttpOptions& options, runtime::CallContext& call, HttpCallback done) {
  if (auto status = call.CheckAlive(); !status.ok()) return done(std::move(status));
  const absl::Duration now = runtime::SystemClock().Elapsed();
  const absl::Duration deadline = now + (call.deadline() - clock_.Now());
  auto job = std::make_shared<Job>();
  job->transfer = std::make_unique<Transfer>(std::move(request), options, now, deadline);
  if (!job->transfer->status().ok()) return done(job->transfer->status());
  job->done = std::move(done);
  impl_->Start(std::move(job), call);
}

HttpClient::HttpClient(HttpLoop& loop, HttpOptions options) : loop_(loop), options_(std::move(options)) {}

void HttpClient::Send(HttpRequest request, runtime::CallContext& call, HttpCallback done) {
  if (auto status = CheckRequest(request); !status.ok()) return done(std::move(status));
  loop_.Start(std::move(request), options_, call, std::move(done));
}

}  // namespace flair::llm
