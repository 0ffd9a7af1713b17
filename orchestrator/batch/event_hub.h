// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace flair::orchestrator {

// Tells those who watch a job that it may have new events; they read them from the store. Thread-safe.
class EventHub {
 public:
  using Callback = std::function<void()>;

  // Calls `callback`, from any thread and possibly more than once at a time, until Unsubscribe; a call that has begun
  // may still run then, so it keeps alive what it uses.
  int Subscribe(const std::string& job_id, Callback callback);
  void Unsubscribe(int key);

  void Notify(const std::string& job_id);
  void NotifyAll();

 private:
  struct Subscription {
    std::string job_id;
    // Shared with a call that is under way.
    std::shared_ptr<Callback> callback;
  };
  void Call(const std::string* job_id);

  std::mutex mutex_;
  std::map<int, Subscription> subscriptions_;
  int next_key_ = 1;
};

}  // namespace flair::orchestrator
