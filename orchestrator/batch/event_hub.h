// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "orchestrator/batch/repeater.h"

namespace flair::orchestrator {

// Tells those who watch a job or a batch that something may have happened to it; they read the queue to see what. Calls
// come from a thread of its own, so that who notifies never waits for a reader, and many notifications of one id while
// a call runs are one. Thread-safe.
class EventHub {
 public:
  using Callback = std::function<void()>;

  // Calls `callback` until Unsubscribe; a call that has begun may still run then, so it keeps alive what it uses.
  int Subscribe(const std::string& id, Callback callback) {
    std::lock_guard lock(mutex_);
    subscriptions_[id][next_key_] = std::make_shared<Callback>(std::move(callback));
    ids_[next_key_] = id;
    return next_key_++;
  }

  void Unsubscribe(int key) {
    std::lock_guard lock(mutex_);
    const auto found = ids_.find(key);
    if (found == ids_.end()) return;
    const auto subscription = subscriptions_.find(found->second);
    subscription->second.erase(key);
    if (subscription->second.empty()) subscriptions_.erase(subscription);
    ids_.erase(found);
  }

  // Empty: whatever the id.
  void Notify(const std::string& id) {
    {
      std::lock_guard lock(mutex_);
      // Most ids are watched by nobody.
      if (!id.empty() && !subscriptions_.contains(id)) return;
      changed_.insert(id);
    }
    caller_.Wake();
  }

 private:
  absl::Duration Call() {
    std::vector<std::shared_ptr<Callback>> callbacks;
    {
      std::lock_guard lock(mutex_);
      const std::set<std::string> changed = std::exchange(changed_, {});
      for (const auto& [id, subscriptions] : subscriptions_) {
        if (!changed.contains("") && !changed.contains(id)) continue;
        for (const auto& [key, callback] : subscriptions) callbacks.push_back(callback);
      }
    }
    for (const auto& callback : callbacks) (*callback)();
    return absl::Hours(1);
  }

  std::mutex mutex_;
  std::set<std::string> changed_;
  // By id, then key; shared with a call that is under way.
  std::map<std::string, std::map<int, std::shared_ptr<Callback>>> subscriptions_;
  std::map<int, std::string> ids_;
  int next_key_ = 1;
  // Last: callbacks have ended before the rest goes.
  Repeater caller_{[this] { return Call(); }};
};

}  // namespace flair::orchestrator
