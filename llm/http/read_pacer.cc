// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/read_pacer.h"

#include <poll.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "worker_runtime/clock/clock.h"

namespace flair::llm {
namespace {

// Reads of fewer bytes than this took all there was but for what came meanwhile, which can wait for the next.
constexpr int64_t kLargeReadByteCount = 8192;

bool HasMore(int fd) {
  pollfd socket{.fd = fd, .events = POLLIN, .revents = 0};
  return poll(&socket, 1, 0) > 0;
}

}  // namespace

absl::Duration ReadPause(absl::Duration elapsed) {
  const absl::Duration most = std::clamp(elapsed / 20, absl::Milliseconds(250), absl::Seconds(2));
  return std::clamp(elapsed / 2, absl::Milliseconds(32), most);
}

absl::Duration PauseEnd(absl::Duration now, absl::Duration pause) {
  // A power of two, so that the moments of long pauses are some of those of short ones.
  const auto eighth = static_cast<uint64_t>(std::max<int64_t>(1, absl::ToInt64Milliseconds(pause / 8)));
  return absl::Floor(now + pause, absl::Milliseconds(std::bit_floor(eighth)));
}

void ReadPacer::Watch(int fd, bool readable, bool writable) {
  const auto [found, added] = sockets_.try_emplace(fd);
  Socket& socket = found->second;
  if (added || writable) {
    socket.start = runtime::SystemClock().Elapsed();
    EndPause(socket);
  }
  if (!readable && !writable) {
    EndPause(socket);
    sockets_.erase(found);
    loop_.Watch(fd, false, false);
    return;
  }
  socket.readable = readable;
  socket.writable = writable;
  loop_.Watch(fd, readable && socket.pause == 0, writable);
}

void ReadPacer::OnReadable(int fd) { ReadAndGoOn(fd, true); }

void ReadPacer::ReadResting() {
  std::vector<int> resting;
  for (const auto& [fd, socket] : sockets_) {
    if (socket.pause != 0) resting.push_back(fd);
  }
  for (const int fd : resting) {
    // Reading another may have ended this one's rest.
    const auto found = sockets_.find(fd);
    if (found == sockets_.end() || found->second.pause == 0) continue;
    EndPause(found->second);
    ReadAndGoOn(fd, false);
  }
}

void ReadPacer::ReadAndGoOn(int fd, bool watched) {
  const int64_t byte_count = read_(fd);
  const auto found = sockets_.find(fd);
  if (found == sockets_.end() || !found->second.readable || found->second.pause != 0) return;
  if (byte_count > 0 && (byte_count < kLargeReadByteCount || !HasMore(fd))) {
    Pause(fd, found->second);
  } else if (!watched) {
    loop_.Watch(fd, true, found->second.writable);
  }
}

void ReadPacer::EndPause(Socket& socket) {
  if (socket.pause != 0) loop_.Drop(socket.pause);
  socket.pause = 0;
}

void ReadPacer::Pause(int fd, Socket& socket) {
  loop_.Watch(fd, false, socket.writable);
  const absl::Duration now = runtime::SystemClock().Elapsed();
  socket.pause = loop_.RunAfter(PauseEnd(now, pause_(now - socket.start)) - now, [this, fd](const absl::Status& time) {
    if (!time.ok()) return;
    sockets_.at(fd).pause = 0;
    // Without asking whether there is anything: of a slow answer there nearly always is, and then one wake-up does.
    ReadAndGoOn(fd, false);
  });
}

}  // namespace flair::llm
