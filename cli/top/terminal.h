// SPDX-License-Identifier: GPL-3.0-or-later
// A terminal: lines with colours, and the whole screen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/time/time.h"

namespace flair::cli {

enum class Style { kPlain, kBold, kDim, kGood, kWarning, kBad };

// A line of so many characters at most, put together from left to right; what would go beyond is cut. Text is counted
// in characters of UTF-8; control characters become spaces.
class StyledLine {
 public:
  StyledLine(int width, bool color) : width_(width), color_(color) {}

  StyledLine& Add(std::string_view text, Style style = Style::kPlain);
  // In a column so wide, set to the left or to the right, and cut with "…" where it is longer.
  StyledLine& Left(std::string_view text, int column_width, Style style = Style::kPlain);
  StyledLine& Right(std::string_view text, int column_width, Style style = Style::kPlain);

  const std::string& text() const { return text_; }

 private:
  const int width_;
  const bool color_;
  int used_ = 0;
  std::string text_;
};

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
