// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <curl/curl.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>

#include "llm/http/event_loop.h"
#include "llm/http/read_pacer.h"
#include "llm/http/transfer.h"

namespace flair::llm {

// Runs transfers on an event loop by libcurl's socket interface, which costs nothing for those that wait. Loop thread.
class CurlMulti {
 public:
  using Done = std::function<void(absl::StatusOr<HttpResponse>)>;

  explicit CurlMulti(EventLoop& loop);
  // No transfer may run any more.
  ~CurlMulti();

  // Starts a transfer. `id` is new. `done` is called once, later.
  void Start(int64_t id, std::unique_ptr<Transfer> transfer, Done done);

  // Ends a transfer that still runs with this error, and closes its connection.
  void Abort(int64_t id, const absl::Status& status);

  // Ends all.
  void AbortAll(const absl::Status& status);

  void OnSocket(int fd, bool readable, bool writable);

 private:
  struct Running {
    std::unique_ptr<Transfer> transfer;
    Done done;
    runtime::Timer::Id check = 0;
  };

  // How many bytes of answers' bodies came.
  int64_t Read(int fd);
  void Act(curl_socket_t fd, int events);
  void FinishDone();
  // Ends those that want no more of their answers.
  void AbortRefused();
  // Ends the transfer when its time is over, or else looks again later.
  void Check(int64_t id);
  void SetCurlTimer(long milliseconds);
  // Takes it off libcurl and off the timers.
  Running Release(std::unordered_map<int64_t, Running>::iterator running);

  EventLoop& loop_;
  ReadPacer pacer_;
  CURLM* const multi_;
  ReadRound round_;
  std::unordered_map<int64_t, Running> running_;
  runtime::Timer::Id curl_timer_ = 0;
};

}  // namespace flair::llm
