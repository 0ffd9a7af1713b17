// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/time/time.h"

namespace flair::cli {

// The whole terminal, until this object is destroyed: then it looks as before. One at a time; it takes SIGINT, SIGTERM,
// SIGHUP and SIGWINCH.
class TerminalScreen {
 public:
  TerminalScreen();
  ~TerminalScreen();
  TerminalScreen(const TerminalScreen&) = delete;
  TerminalScreen& operator=(const TerminalScreen&) = delete;

  struct Size {
    int width;
    int height;
  };
  // As it is now.
  Size size() const;

  // Draws over what was there, in one write. Lines are no wider than the screen.
  void Show(const std::vector<std::string>& lines);

  enum class Event { kTimeout, kQuit, kResized };
  // Waits for "q", Escape, a signal to end, another size, or the time.
  Event Wait(absl::Duration timeout);

  // Whether standard input and output are a terminal that understands us.
  static bool IsThere();
};

}  // namespace flair::cli
