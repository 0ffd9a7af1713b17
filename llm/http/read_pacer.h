// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>

#include "absl/time/time.h"
#include "llm/http/event_loop.h"

namespace flair::llm {

// How long a socket that was read is left alone, when it has been read for `elapsed` since it was last added or written
// to: a twentieth of that, at most 250 ms, nothing below 1 ms. A model sends a small piece every few milliseconds for
// many seconds; so a hundred reads take them all in, and no answer is known later than a twentieth of its time.
absl::Duration ReadPause(absl::Duration elapsed);

// Watches sockets on an event loop, with these pauses. Loop thread.
class ReadPacer {
 public:
  explicit ReadPacer(EventLoop& loop) : loop_(loop) {}

  // As EventLoop::Watch.
  void Watch(int fd, bool readable, bool writable);

  // After the socket was read.
  void OnRead(int fd);

 private:
  struct Socket {
    bool readable = false;
    bool writable = false;
    absl::Duration start;
    // The timer that ends the pause; 0 when there is none.
    runtime::Timer::Id pause = 0;
  };

  EventLoop& loop_;
  std::unordered_map<int, Socket> sockets_;
};

}  // namespace flair::llm
