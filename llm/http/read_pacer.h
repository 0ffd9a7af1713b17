// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>

#include "absl/time/time.h"
#include "llm/http/event_loop.h"

namespace flair::llm {

// How long a socket is left alone that brought a part of an answer, `elapsed` after it was last added or written to:
// half of that, at least 32 ms, at most 250 ms or, when more, a twentieth of it, never more than 2 s. An answer is
// known that much later at most, on average half of it. A model sends a small piece every few milliseconds for many
// seconds, and waking up for a piece costs many times what reading it does: an answer of a second is read ten times,
// one of twenty seconds some fifty times.
absl::Duration ReadPause(absl::Duration elapsed);

// When a pause of that length ends which begins at `now`: up to an eighth earlier, so that many sockets' pauses end at
// the same moments and are woken up for once.
absl::Duration PauseEnd(absl::Duration now, absl::Duration pause);

// Watches sockets on an event loop, with these pauses. The first bytes of an answer, what a connection needs before
// it, and bytes that lie ready already are never waited for; nor is anything but the one socket. Loop thread.
class ReadPacer {
 public:
  // Reads some 16 KiB of what a socket has, which may be nothing; how many bytes of an answer's body came.
  using Read = std::function<int64_t(int fd)>;

  // As ReadPause.
  using PauseRule = std::function<absl::Duration(absl::Duration elapsed)>;

  ReadPacer(EventLoop& loop, Read read, PauseRule pause = ReadPause)
      : loop_(loop), read_(std::move(read)), pause_(std::move(pause)) {}

  // As EventLoop::Watch. Writing, such as the next request over a shared connection, ends a pause.
  void Watch(int fd, bool readable, bool writable);

  // Reads a socket that has something.
  void OnReadable(int fd);

  // Reads every socket that rests, and lets it rest anew. Before something is said to be silent.
  void ReadResting();

 private:
  struct Socket {
    bool readable = false;
    bool writable = false;
    absl::Duration start;
    // The timer that ends the pause; 0 when there is none.
    runtime::Timer::Id pause = 0;
  };

  // `watched`: by the event loop, for reading.
  void ReadAndGoOn(int fd, bool watched);
  void EndPause(Socket& socket);
  void Pause(int fd, Socket& socket);

  EventLoop& loop_;
  const Read read_;
  const PauseRule pause_;
  std::unordered_map<int, Socket> sockets_;
};

}  // namespace flair::llm
