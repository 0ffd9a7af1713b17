// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

namespace flair::orchestrator {

// Tells those who watch a job or a batch that something may have happened to it; they read the queue to see what. Calls
// come from a thread of its own, so that who notifies never waits for a reader, and many notifications of one id while
// a call runs are one. Thread-safe.
class EventHub {
 public:
  using Callback = std::function<void()>;

  EventHub();
  // Callbacks have ended then.
  ~EventHub();

  // Calls `callback` until Unsubscribe; a call that has begun may still run then, so it keeps alive what it uses.
  int Subscribe(const std::string& id, Callback callback);
  void Unsubscribe(int key);

  // Empty: whatever the id.
  void Notify(const std::string& id);

 private:
  void Run();
  void Call(const std::set<std::string>& ids);

  std::mutex mutex_;
  std::condition_variable wake_;
  std::set<std::string> changed_;
  bool stopping_ = false;
  // By id, then key; shared with a call that is under way.
  std::map<std::string, std::map<int, std::shared_ptr<Callback>>> subscriptions_;
  std::map<int, std::string> ids_;
  int next_key_ = 1;
  std::thread thread_;
};

}  // namespace flair::orchestrator
