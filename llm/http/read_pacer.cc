// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/read_pacer.h"

#include <algorithm>

#include "worker_runtime/clock/clock.h"

namespace flair::llm {

absl::Duration ReadPause(absl::Duration elapsed) {
  const absl::Duration pause = std::min(elapsed / 20, absl::Milliseconds(250));
  return pause < absl::Milliseconds(1) ? absl::ZeroDuration() : pause;
}

void ReadPacer::Watch(int fd, bool readable, bool writable) {
  const auto [found, added] = sockets_.try_emplace(fd);
  Socket& socket = found->second;
  if (added || writable) socket.start = runtime::SystemClock().Elapsed();
  if (!readable && !writable) {
    if (socket.pause != 0) loop_.Drop(socket.pause);
    sockets_.erase(found);
    loop_.Watch(fd, false, false);
    return;
  }
  socket.readable = readable;
  socket.writable = writable;
  loop_.Watch(fd, readable && socket.pause == 0, writable);
}

void ReadPacer::OnRead(int fd) {
  const auto found = sockets_.find(fd);
  if (found == sockets_.end() || !found->second.readable || found->second.pause != 0) return;
  Socket& socket = found->second;
  const absl::Duration pause = ReadPause(runtime::SystemClock().Elapsed() - socket.start);
  if (pause == absl::ZeroDuration()) return;
  loop_.Watch(fd, false, socket.writable);
  socket.pause = loop_.RunAfter(pause, [this, fd](const absl::Status& time) {
    if (!time.ok()) return;
    const auto paused = sockets_.find(fd);
    if (paused == sockets_.end()) return;
    paused->second.pause = 0;
    loop_.Watch(fd, paused->second.readable, paused->second.writable);
  });
}

}  // namespace flair::llm
