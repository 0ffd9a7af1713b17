// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/store_monitor.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <utility>

namespace flair::orchestrator {
namespace {

constexpr int kLookAnywayMs = 1000;
constexpr int kBurstMs = 20;

// Empties the queue of a non-blocking inotify file; true when one of the events came from `watch`.
bool Drain(int file, int watch) {
  alignas(inotify_event) char buffer[4096];
  bool seen = false;
  ssize_t size;
  while ((size = ::read(file, buffer, sizeof buffer)) > 0) {
    for (ssize_t at = 0; at < size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
      seen |= event->wd == watch;
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    }
  }
  return seen;
}

}  // namespace

StoreMonitor::StoreMonitor(JobStore& store, Callbacks callbacks) : store_(store), callbacks_(std::move(callbacks)) {
  stop_file_ = ::eventfd(0, EFD_CLOEXEC);
  notify_file_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ::inotify_add_watch(notify_file_, store.path().c_str(), IN_MODIFY);
  owners_watch_ = ::inotify_add_watch(notify_file_, store.owners_path().c_str(), IN_CLOSE_WRITE | IN_DELETE);
  ChangedElsewhere();
  thread_ = std::thread([this] { Watch(); });
}

StoreMonitor::~StoreMonitor() {
  ::eventfd_write(stop_file_, 1);
  thread_.join();
  if (notify_file_ >= 0) ::close(notify_file_);
  ::close(stop_file_);
}

void StoreMonitor::Watch() {
  pollfd files[] = {{stop_file_, POLLIN, 0}, {notify_file_, POLLIN, 0}};
  while (true) {
    const int ready = ::poll(files, 2, kLookAnywayMs);
    if ((files[0].revents & POLLIN) != 0) return;
    // A burst of writes, most of which are our own, is worth one look.
    if (ready > 0 && ::poll(files, 1, kBurstMs) > 0) return;
    const bool owner_gone = Drain(notify_file_, owners_watch_) || ready == 0;
    if (owner_gone) callbacks_.owner_gone();
    if (ChangedElsewhere()) callbacks_.changed();
  }
}

bool StoreMonitor::ChangedElsewhere() {
  const auto lock = store_.database().lock();
  Statement version = store_.database().Prepare("PRAGMA data_version");
  const absl::StatusOr<bool> row = version.Step();
  if (!row.ok() || !*row) return false;
  const int64_t seen = std::exchange(version_, version.Int(0));
  return seen != version_;
}

}  // namespace flair::orchestrator
