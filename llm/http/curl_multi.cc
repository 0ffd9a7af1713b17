// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/curl_multi.h"

#include <utility>

#include "worker_runtime/clock/clock.h"

namespace flair::llm {

CurlMulti::CurlMulti(EventLoop& loop)
    : loop_(loop), pacer_(loop, [this](int fd) { return Read(fd); }), multi_(curl_multi_init()) {
  // As many as the server takes; beyond that, each request gets a connection of its own.
  curl_multi_setopt(multi_, CURLMOPT_MAX_CONCURRENT_STREAMS, 1000L);
  curl_multi_setopt(multi_, CURLMOPT_SOCKETDATA, this);
  curl_multi_setopt(
      multi_, CURLMOPT_SOCKETFUNCTION, +[](CURL*, curl_socket_t fd, int what, void* self, void*) {
        const bool removed = what == CURL_POLL_REMOVE;
        static_cast<CurlMulti*>(self)->pacer_.Watch(fd, !removed && (what & CURL_POLL_IN) != 0,
                                                    !removed && (what & CURL_POLL_OUT) != 0);
        return 0;
      });
  curl_multi_setopt(multi_, CURLMOPT_TIMERDATA, this);
  curl_multi_setopt(
      multi_, CURLMOPT_TIMERFUNCTION, +[](CURLM*, long milliseconds, void* self) {
        static_cast<CurlMulti*>(self)->SetCurlTimer(milliseconds);
        return 0;
      });
}

CurlMulti::~CurlMulti() {
  // Closing the connections that were kept may call back; nothing is watched any more by then.
  curl_multi_cleanup(multi_);
}

void CurlMulti::Start(int64_t id, std::unique_ptr<Transfer> transfer, Done done) {
  CURL* const handle = transfer->handle();
  curl_easy_setopt(handle, CURLOPT_PRIVATE, reinterpret_cast<void*>(id));
  Running& running = running_[id];
  running.transfer = std::move(transfer);
  running.transfer->Join(&round_, id);
  running.done = std::move(done);
  if (curl_multi_add_handle(multi_, handle) != CURLM_OK) {
    Abort(id, absl::ResourceExhaustedError("no memory for an HTTP request"));
    return;
  }
  Check(id);
}

void CurlMulti::Abort(int64_t id, const absl::Status& status) {
  const auto found = running_.find(id);
  if (found == running_.end()) return;
  Running running = Release(found);
  // Closes the connection before anybody is told.
  running.transfer.reset();
  running.done(status);
}

void CurlMulti::AbortAll(const absl::Status& status) {
  while (!running_.empty()) Abort(running_.begin()->first, status);
}

void CurlMulti::OnSocket(int fd, bool readable, bool writable) {
  if (writable) Act(fd, CURL_CSELECT_OUT | (readable ? CURL_CSELECT_IN : 0));
  if (readable && !writable) pacer_.OnReadable(fd);
}

int64_t CurlMulti::Read(int fd) {
  Act(fd, CURL_CSELECT_IN);
  return round_.body_byte_count;
}

void CurlMulti::Act(curl_socket_t fd, int events) {
  round_.now = runtime::SystemClock().Elapsed();
  round_.body_byte_count = 0;
  int running_count = 0;
  curl_multi_socket_action(multi_, fd, events, &running_count);
  round_.Deliver();
  FinishDone();
  AbortRefused();
}

void CurlMulti::FinishDone() {
  int message_count = 0;
  while (CURLMsg* const message = curl_multi_info_read(multi_, &message_count)) {
    if (message->msg != CURLMSG_DONE) continue;
    const CURLcode code = message->data.result;
    void* id = nullptr;
    curl_easy_getinfo(message->easy_handle, CURLINFO_PRIVATE, &id);
    const auto found = running_.find(reinterpret_cast<int64_t>(id));
    if (found == running_.end()) continue;
    Running running = Release(found);
    auto response = running.transfer->Finish(code);
    running.transfer.reset();
    running.done(std::move(response));
  }
}

void CurlMulti::AbortRefused() {
  for (const int64_t id : std::exchange(round_.refused, {})) {
    const auto found = running_.find(id);
    if (found != running_.end()) Abort(id, absl::Status(found->second.transfer->status()));
  }
}

void CurlMulti::Check(int64_t id) {
  auto found = running_.find(id);
  if (found == running_.end()) return;
  const absl::Duration now = runtime::SystemClock().Elapsed();
  if (found->second.transfer->Expired(now)) {
    // What it waits for may lie in a socket that rests.
    pacer_.ReadResting();
    found = running_.find(id);
    if (found == running_.end()) return;
  }
  if (const auto expired = found->second.transfer->Expired(now)) {
    Abort(id, *expired);
    return;
  }
  found->second.check =
      loop_.RunAfter(found->second.transfer->NextCheck(now) - now, [this, id](const absl::Status& time) {
        if (time.ok()) Check(id);
      });
}

void CurlMulti::SetCurlTimer(long milliseconds) {
  if (curl_timer_ != 0) loop_.Drop(curl_timer_);
  curl_timer_ = 0;
  if (milliseconds < 0) return;
  curl_timer_ = loop_.RunAfter(absl::Milliseconds(milliseconds), [this](const absl::Status& time) {
    // At the end of the loop nothing of this is left.
    if (!time.ok()) return;
    curl_timer_ = 0;
    Act(CURL_SOCKET_TIMEOUT, 0);
  });
}

CurlMulti::Running CurlMulti::Release(std::unordered_map<int64_t, Running>::iterator running) {
  Running released = std::move(running->second);
  running_.erase(running);
  loop_.Drop(released.check);
  curl_multi_remove_handle(multi_, released.transfer->handle());
  return released;
}

}  // namespace flair::llm
