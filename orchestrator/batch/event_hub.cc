// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/event_hub.h"

#include <utility>
#include <vector>

namespace flair::orchestrator {

int EventHub::Subscribe(const std::string& job_id, Callback callback) {
  std::lock_guard lock(mutex_);
  subscriptions_[next_key_] = {job_id, std::make_shared<Callback>(std::move(callback))};
  return next_key_++;
}

void EventHub::Unsubscribe(int key) {
  std::lock_guard lock(mutex_);
  subscriptions_.erase(key);
}

void EventHub::Notify(const std::string& job_id) { Call(&job_id); }

void EventHub::NotifyAll() { Call(nullptr); }

void EventHub::Call(const std::string* job_id) {
  std::vector<std::shared_ptr<Callback>> callbacks;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [key, subscription] : subscriptions_) {
      if (job_id == nullptr || subscription.job_id == *job_id) callbacks.push_back(subscription.callback);
    }
  }
  for (const auto& callback : callbacks) (*callback)();
}

}  // namespace flair::orchestrator
