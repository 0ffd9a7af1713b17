// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <thread>

#include "orchestrator/store/job_store.h"

namespace flair::orchestrator {

// Notices what other processes do to a store: that they wrote to it, and that one of them ended. Woken by the kernel
// (inotify on the write-ahead log and on the owner locks); where that does not work, such as on network file systems,
// it looks once a second. The store outlives it.
class StoreMonitor {
 public:
  struct Callbacks {
    // Another process changed the store.
    std::function<void()> changed;
    // An owner may have died, or the store was not looked at for a second.
    std::function<void()> owner_gone;
  };

  // Calls back from a thread of its own, one call at a time.
  StoreMonitor(JobStore& store, Callbacks callbacks);
  ~StoreMonitor();

 private:
  void Watch();
  bool ChangedElsewhere();

  JobStore& store_;
  const Callbacks callbacks_;
  int notify_file_ = -1;
  int owners_watch_ = -1;
  int stop_file_ = -1;
  int64_t version_ = -1;
  std::thread thread_;
};

}  // namespace flair::orchestrator
