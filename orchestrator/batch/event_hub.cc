// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/event_hub.h"

#include <utility>
#include <vector>

namespace flair::orchestrator {

EventHub::EventHub() : thread_([this] { Run(); }) {}

EventHub::~EventHub() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    wake_.notify_all();
  }
  thread_.join();
}

int EventHub::Subscribe(const std::string& id, Callback callback) {
  std::lock_guard lock(mutex_);
  subscriptions_[id][next_key_] = std::make_shared<Callback>(std::move(callback));
  ids_[next_key_] = id;
  return next_key_++;
}

void EventHub::Unsubscribe(int key) {
  std::lock_guard lock(mutex_);
  const auto found = ids_.find(key);
  if (found == ids_.end()) return;
  const auto subscription = subscriptions_.find(found->second);
  subscription->second.erase(key);
  if (subscription->second.empty()) subscriptions_.erase(subscription);
  ids_.erase(found);
}

void EventHub::Notify(const std::string& id) {
  std::lock_guard lock(mutex_);
  // Most ids are watched by nobody.
  if (!id.empty() && !subscriptions_.contains(id)) return;
  changed_.insert(id);
  wake_.notify_all();
}

void EventHub::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [&] { return stopping_ || !changed_.empty(); });
    if (stopping_) return;
    const std::set<std::string> changed = std::exchange(changed_, {});
    lock.unlock();
    Call(changed);
    lock.lock();
  }
}

void EventHub::Call(const std::set<std::string>& ids) {
  std::vector<std::shared_ptr<Callback>> callbacks;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [id, subscriptions] : subscriptions_) {
      if (!ids.contains("") && !ids.contains(id)) continue;
      for (const auto& [key, callback] : subscriptions) callbacks.push_back(callback);
    }
  }
  for (const auto& callback : callbacks) (*callback)();
}

}  // namespace flair::orchestrator
