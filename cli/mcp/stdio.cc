// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/stdio.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>

namespace flair::cli::mcp {

absl::StatusOr<int> ReserveStandardOutput() {
  std::fflush(stdout);
  const int reserved = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  if (reserved < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    return absl::FailedPreconditionError("standard output is not open");
  }
  return reserved;
}

void Lines::Read(size_t most, const std::function<void(std::string_view)>& see,
                 const std::function<void()>& see_too_long) {
  std::string line;
  bool skipping = false;
  std::array<char, 64 << 10> chunk;
  while (!broken) {
    std::array<pollfd, 2> waited = {pollfd{.fd = in, .events = POLLIN, .revents = 0},
                                    pollfd{.fd = stop, .events = POLLIN, .revents = 0}};
    if (::poll(waited.data(), waited.size(), -1) < 0) continue;
    if (waited[1].revents != 0) return;
    const ssize_t count = ::read(in, chunk.data(), chunk.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return;
    std::string_view rest(chunk.data(), static_cast<size_t>(count));
    while (!rest.empty()) {
      const size_t end = rest.find('\n');
      if (!skipping) line.append(rest.substr(0, end));
      if (line.size() > most) {
        skipping = true;
        line.clear();
        line.shrink_to_fit();
        see_too_long();
      }
      if (end == std::string_view::npos) break;
      if (!skipping) see(line);
      skipping = false;
      line.clear();
      rest.remove_prefix(end + 1);
    }
  }
}

void Lines::Write(std::string line) {
  line += '\n';
  std::string_view rest = line;
  while (!rest.empty() && !broken) {
    // A pipe that is ready takes so much without waiting; a socket says how much it takes.
    ssize_t count = ::send(out, rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) {
      pollfd ready = {.fd = out, .events = POLLOUT, .revents = 0};
      errno = EAGAIN;
      if (::poll(&ready, 1, 0) > 0) count = ::write(out, rest.data(), std::min<size_t>(rest.size(), PIPE_BUF));
    }
    if (count >= 0) {
      rest.remove_prefix(static_cast<size_t>(count));
      continue;
    }
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) {
      broken = true;
      break;
    }
    std::array<pollfd, 3> waited = {pollfd{.fd = out, .events = POLLOUT, .revents = 0},
                                    pollfd{.fd = stop, .events = POLLIN, .revents = 0},
                                    pollfd{.fd = in, .events = POLLRDHUP, .revents = 0}};
    if (::poll(waited.data(), waited.size(), -1) < 0) continue;
    broken = waited[1].revents != 0 || (waited[2].revents != 0 && waited[0].revents == 0);
  }
}

}  // namespace flair::cli::mcp
