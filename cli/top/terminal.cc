// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "absl/time/clock.h"
#include "cli/output/output_folder.h"
#include "cli/output/text.h"

namespace flair::cli {
namespace {

// The first so many characters.
std::string_view First(std::string_view text, int count) {
  size_t end = 0;
  for (; end < text.size(); ++end) {
    const bool begins = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (begins && --count < 0) break;
  }
  return text.substr(0, end);
}

std::string_view Code(Style style) {
  constexpr std::string_view kCodes[] = {"", "\x1b[1m", "\x1b[2m", "\x1b[32m", "\x1b[33m", "\x1b[31m"};  // by Style
  return kCodes[static_cast<size_t>(style)];
}

std::string Fitted(std::string_view text, int width) {
  return Shortened(PrintableLine(std::string(text)), static_cast<size_t>(std::max(0, width)));
}

std::string Padding(std::string_view text, int width) {
  return std::string(static_cast<size_t>(std::max(0, width - static_cast<int>(ColumnsOf(text)))), ' ');
}

volatile std::sig_atomic_t end_wanted = 0;
volatile std::sig_atomic_t resized = 0;
termios former_mode;

void OnEnd(int) { end_wanted = 1; }
void OnResize(int) { resized = 1; }

// Without SA_RESTART, so that waiting ends.
void Handle(int number, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  ::sigaction(number, &action, nullptr);
}

}  // namespace

StyledLine& StyledLine::Add(std::string_view text, Style style) {
  const std::string line = PrintableLine(std::string(text));
  const std::string_view fitting = First(line, width_ - used_);
  if (fitting.empty()) return *this;
  used_ += static_cast<int>(ColumnsOf(fitting));
  const bool styled = color_ && style != Style::kPlain;
  if (styled) text_ += Code(style);
  text_ += fitting;
  if (styled) text_ += "\x1b[0m";
  return *this;
}

StyledLine& StyledLine::Left(std::string_view text, int column_width, Style style) {
  const std::string fitted = Fitted(text, column_width);
  return Add(fitted, style).Add(Padding(fitted, column_width));
}

StyledLine& StyledLine::Right(std::string_view text, int column_width, Style style) {
  const std::string fitted = Fitted(text, column_width);
  return Add(Padding(fitted, column_width)).Add(fitted, style);
}

bool TerminalScreen::IsThere() {
  const char* kind = std::getenv("TERM");
  return ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0 && kind != nullptr &&
         std::string_view(kind) != "dumb";
}

TerminalScreen::TerminalScreen() {
  ::tcgetattr(STDIN_FILENO, &former_mode);
  termios mode = former_mode;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  // Stopped, it would leave its picture to the shell.
  mode.c_cc[VSUSP] = _POSIX_VDISABLE;
  ::tcsetattr(STDIN_FILENO, TCSANOW, &mode);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) Handle(number, OnEnd);
  Handle(SIGWINCH, OnResize);
  // The other screen, without cursor, without wrapping.
  WriteAll(STDOUT_FILENO, "\x1b[?1049h\x1b[?25l\x1b[?7l");
}

TerminalScreen::~TerminalScreen() {
  WriteAll(STDOUT_FILENO, "\x1b[?7h\x1b[?25h\x1b[?1049l");
  ::tcsetattr(STDIN_FILENO, TCSANOW, &former_mode);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGWINCH}) Handle(number, SIG_DFL);
}

TerminalScreen::Size TerminalScreen::size() const {
  winsize size = {};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {80, 24};
  return {size.ws_col, size.ws_row};
}

void TerminalScreen::Show(const std::vector<std::string>& lines) {
  const size_t count = std::min(lines.size(), static_cast<size_t>(size().height));
  // Erased before and not after it is written: behind the last column of a full line that would take its last
  // character. Between 2026h and 2026l terminals that can show nothing half drawn.
  std::string frame = "\x1b[?2026h\x1b[H";
  for (size_t i = 0; i < count; ++i) frame += (i + 1 < count ? "\x1b[K" + lines[i] + "\r\n" : "\x1b[J" + lines[i]);
  WriteAll(STDOUT_FILENO, frame + "\x1b[?2026l");
}

TerminalScreen::Event TerminalScreen::Wait(absl::Duration timeout) {
  const absl::Time end = absl::Now() + timeout;
  while (end_wanted == 0) {
    if (resized != 0) {
      resized = 0;
      return Event::kResized;
    }
    const int left_ms = static_cast<int>(std::max(int64_t{0}, absl::ToInt64Milliseconds(end - absl::Now())));
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&input, 1, left_ms);
    if (ready == 0) return Event::kTimeout;
    if (ready < 0) continue;
    char key = 0;
    if (::read(STDIN_FILENO, &key, 1) <= 0) return Event::kQuit;
    if (key == 'q' || key == 'Q' || key == '\x1b') return Event::kQuit;
  }
  return Event::kQuit;
}

}  // namespace flair::cli
