// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "absl/time/time.h"
#include "orchestrator/jetstream/nats_message.h"

namespace flair::orchestrator {

class NatsInbox;

// Brings each answer to who waits for it: all of a connection come to one inbox, under a number each. cnats has the
// same in natsConnection_Request; but its version 3.4 loses answers when several threads ask and some give up waiting.
// Thread-safe.
class Answers {
 public:
  explicit Answers(std::unique_ptr<NatsInbox> inbox);
  // Nobody waits any more.
  ~Answers();

  // One answer that is waited for; forgotten when destroyed.
  class Expected {
   public:
    explicit Expected(Answers& answers);
    ~Expected();
    Expected(const Expected&) = delete;
    Expected& operator=(const Expected&) = delete;

    // Where it is to be sent.
    std::string reply() const;
    // Nothing when it does not come in time.
    std::optional<NatsMessage> Wait(absl::Duration limit);

   private:
    friend class Answers;
    Answers& answers_;
    const int64_t number_;
    std::condition_variable arrived_;
    std::optional<NatsMessage> message_;
  };

 private:
  void Run();

  const std::unique_ptr<NatsInbox> inbox_;
  std::mutex mutex_;
  int64_t next_number_ = 1;
  std::map<int64_t, Expected*> expected_;
  std::thread thread_;
};

}  // namespace flair::orchestrator
