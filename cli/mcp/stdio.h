// SPDX-License-Identifier: GPL-3.0-or-later
// Lines from and to a client at the other end of standard input and output.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace flair::cli::mcp {

// Keeps standard output for messages: whatever else this process prints there goes to standard error from now on.
// Returns the descriptor that messages go to.
absl::StatusOr<int> ReserveStandardOutput();

struct Lines {
  int in;
  int out;
  // Readable once the program is to end.
  int stop;
  // Set once nothing can be written any more.
  std::atomic<bool> broken = false;

  // Calls `see` for every line of at most `most` bytes, without its end, and `see_too_long` for every longer one, whose
  // bytes are not kept; until the input ends, `stop` can be read, or the client reads no more.
  void Read(size_t most, const std::function<void(std::string_view)>& see, const std::function<void()>& see_too_long);
  // The line and its end. Waits while the client reads other lines, but not for one that is gone or once `stop` can be
  // read: the rest is lost then. One at a time.
  void Write(std::string line);
};

}  // namespace flair::cli::mcp
