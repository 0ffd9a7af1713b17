// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <utility>

#include "flair/v1/studio_service.pb.h"

namespace flair::session {

// Tells everybody who listens what happens to documents. Thread-safe.
class DocumentEvents {
 public:
  // Called one event at a time, by whoever changes a document: it must not wait, nor call these methods.
  using Listener = std::function<void(const v1::WatchDocumentsResponse&)>;

  int Subscribe(Listener listener) {
    const std::lock_guard lock(mutex_);
    listeners_.emplace(next_, std::move(listener));
    return next_++;
  }
  // The listener is not called any more once this has returned.
  void Unsubscribe(int key) {
    const std::lock_guard lock(mutex_);
    listeners_.erase(key);
  }
  void Tell(const v1::WatchDocumentsResponse& event) {
    const std::lock_guard lock(mutex_);
    for (const auto& [key, listener] : listeners_) listener(event);
  }

 private:
  std::mutex mutex_;
  std::map<int, Listener> listeners_;
  int next_ = 1;
};

}  // namespace flair::session
