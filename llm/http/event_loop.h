// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "worker_runtime/clock/clock.h"

namespace flair::llm {

// One thread that waits for sockets, timers and tasks of other threads. Thread-safe but for what says "loop thread".
class EventLoop final : public runtime::Timer {
 public:
  // Called in the loop thread for a socket that is ready.
  using SocketCallback = std::function<void(int fd, bool readable, bool writable)>;

  explicit EventLoop(SocketCallback on_socket);

  // As Stop().
  ~EventLoop() override;

  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  // Runs the task in the loop thread, tasks in their order; false, without keeping it, when the loop has ended.
  bool Post(std::function<void()> task);

  Id RunAfter(absl::Duration delay, runtime::TimerCallback callback) override;
  void Hasten(Id id) override;

  // Forgets a callback that has not run, without calling it.
  void Drop(Id id);

  // Watches a socket for these events from now on, for nothing when both are false. Loop thread.
  void Watch(int fd, bool readable, bool writable);

  // Runs the tasks posted so far, then `last`, then every waiting timer with CANCELLED, all in the loop thread; returns
  // when the thread has ended. Must not be called by the loop thread. Further calls do nothing.
  void Stop(std::function<void()> last = {});

 private:
  using Due = std::pair<absl::Duration, Id>;

  void Run();
  void RunTasks();
  void RunTimers();
  void End();
  void WaitForSockets();
  int WaitMilliseconds();
  void Wake();

  const SocketCallback on_socket_;
  const int epoll_fd_;
  const int wake_fd_;
  // Of the loop thread.
  std::unordered_set<int> watched_;
  std::mutex mutex_;
  std::vector<std::function<void()>> tasks_;
  std::map<Due, runtime::TimerCallback> timers_;
  std::unordered_map<Id, absl::Duration> due_of_;
  Id next_id_ = 1;
  bool stopping_ = false;
  bool ended_ = false;
  std::function<void()> last_;
  std::mutex stop_mutex_;
  std::atomic<std::thread::id> loop_thread_;
  std::thread thread_;
};

}  // namespace flair::llm
