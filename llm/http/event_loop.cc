// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/event_loop.h"

#include <signal.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "worker_runtime/clock/clock.h"

namespace flair::llm {

EventLoop::EventLoop(SocketCallback on_socket)
    : on_socket_(std::move(on_socket)),
      epoll_fd_(epoll_create1(EPOLL_CLOEXEC)),
      wake_fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = wake_fd_;
  epoll_ctl(epoll_fd_, EPOLL_CTL_ADD, wake_fd_, &event);
  thread_ = std::thread([this] { Run(); });
}

EventLoop::~EventLoop() {
  Stop();
  close(wake_fd_);
  close(epoll_fd_);
}

bool EventLoop::Post(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    if (ended_) return false;
    tasks_.push_back(std::move(task));
  }
  Wake();
  return true;
}

runtime::Timer::Id EventLoop::RunAfter(absl::Duration delay, runtime::TimerCallback callback) {
  const absl::Duration due = runtime::SystemClock().Elapsed() + delay;
  Id id = 0;
  {
    const std::lock_guard lock(mutex_);
    id = next_id_++;
    if (!ended_) {
      timers_.emplace(Due(due, id), std::move(callback));
      due_of_.emplace(id, due);
      callback = nullptr;
    }
  }
  if (callback) {
    callback(absl::CancelledError("the timer has ended"));
  } else if (std::this_thread::get_id() != loop_thread_.load(std::memory_order_relaxed)) {
    Wake();
  }
  return id;
}

void EventLoop::Hasten(Id id) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = due_of_.find(id);
    if (found == due_of_.end()) return;
    auto node = timers_.extract(Due(found->second, id));
    found->second = absl::ZeroDuration();
    node.key() = Due(found->second, id);
    timers_.insert(std::move(node));
  }
  Wake();
}

void EventLoop::Drop(Id id) {
  // Destroyed after the lock is given back: what a callback holds may want the lock.
  runtime::TimerCallback callback;
  const std::lock_guard lock(mutex_);
  const auto found = due_of_.find(id);
  if (found == due_of_.end()) return;
  auto node = timers_.extract(Due(found->second, id));
  callback = std::move(node.mapped());
  due_of_.erase(found);
}

void EventLoop::Watch(int fd, bool readable, bool writable) {
  if (!readable && !writable) {
    // Fails when the socket is closed already, which is as good.
    if (watched_.erase(fd) != 0) epoll_ctl(epoll_fd_, EPOLL_CTL_DEL, fd, nullptr);
    return;
  }
  epoll_event event{};
  event.events = (readable ? uint32_t{EPOLLIN} : 0) | (writable ? uint32_t{EPOLLOUT} : 0);
  event.data.fd = fd;
  const bool added = watched_.insert(fd).second;
  // A socket that was closed and opened again under its old number is not watched, whatever we remember.
  if (added || epoll_ctl(epoll_fd_, EPOLL_CTL_MOD, fd, &event) != 0) epoll_ctl(epoll_fd_, EPOLL_CTL_ADD, fd, &event);
}

void EventLoop::Stop(std::function<void()> last) {
  const std::lock_guard stop_lock(stop_mutex_);
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    last_ = std::move(last);
  }
  Wake();
  thread_.join();
}

void EventLoop::Run() {
  // Writing to a connection that the server has closed is an error of that connection, not the end of the process.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  loop_thread_.store(std::this_thread::get_id(), std::memory_order_relaxed);
  while (true) {
    RunTasks();
    RunTimers();
    {
      const std::lock_guard lock(mutex_);
      // From here on nothing is taken any more.
      if (stopping_ && tasks_.empty()) ended_ = true;
      if (ended_) break;
    }
    WaitForSockets();
  }
  End();
}

void EventLoop::RunTasks() {
  std::vector<std::function<void()>> tasks;
  {
    const std::lock_guard lock(mutex_);
    tasks.swap(tasks_);
  }
  for (auto& task : tasks) task();
}

void EventLoop::RunTimers() {
  const absl::Duration now = runtime::SystemClock().Elapsed();
  while (true) {
    runtime::TimerCallback callback;
    {
      const std::lock_guard lock(mutex_);
      if (timers_.empty() || timers_.begin()->first.first > now) return;
      auto node = timers_.extract(timers_.begin());
      due_of_.erase(node.key().second);
      callback = std::move(node.mapped());
    }
    callback(absl::OkStatus());
  }
}

void EventLoop::End() {
  if (last_) last_();
  std::map<Due, runtime::TimerCallback> timers;
  {
    const std::lock_guard lock(mutex_);
    timers.swap(timers_);
    due_of_.clear();
  }
  for (auto& [due, callback] : timers) callback(absl::CancelledError("the timer has ended"));
}

void EventLoop::WaitForSockets() {
  std::array<epoll_event, 64> events;
  const int count = epoll_wait(epoll_fd_, events.data(), static_cast<int>(events.size()), WaitMilliseconds());
  for (int i = 0; i < count; ++i) {
    const epoll_event& event = events[i];
    if (event.data.fd == wake_fd_) {
      uint64_t ignored = 0;
      [[maybe_unused]] const ssize_t size = read(wake_fd_, &ignored, sizeof(ignored));
      continue;
    }
    const bool broken = (event.events & (EPOLLERR | EPOLLHUP)) != 0;
    on_socket_(event.data.fd, broken || (event.events & EPOLLIN) != 0, broken || (event.events & EPOLLOUT) != 0);
  }
}

int EventLoop::WaitMilliseconds() {
  const std::lock_guard lock(mutex_);
  if (!tasks_.empty()) return 0;
  if (timers_.empty()) return -1;
  const absl::Duration wait = timers_.begin()->first.first - runtime::SystemClock().Elapsed();
  // Rounded up, so that the timer is due after the wait.
  return static_cast<int>(absl::ToInt64Milliseconds(
      absl::Ceil(std::clamp(wait, absl::ZeroDuration(), absl::Hours(1)), absl::Milliseconds(1))));
}

void EventLoop::Wake() {
  const uint64_t one = 1;
  [[maybe_unused]] const ssize_t size = write(wake_fd_, &one, sizeof(one));
}

}  // namespace flair::llm
