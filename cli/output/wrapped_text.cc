// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/wrapped_text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>

#include "fmt/format.h"

namespace flair::cli {
namespace {

bool BeginsWithUnit(std::string_view text) {
  for (const std::string_view unit : {"m", "m2", "cm", "degrees"}) {
    if (!text.starts_with(unit)) continue;
    if (text.size() == unit.size() || std::isalnum(static_cast<unsigned char>(text[unit.size()])) == 0) return true;
  }
  return false;
}

// How much of the text may not be parted: a word, or a figure with its unit.
size_t EndOfPiece(std::string_view text) {
  const size_t end = std::min(text.find(' '), text.size());
  const bool figure = end > 0 && end < text.size() && text[end - 1] >= '0' && text[end - 1] <= '9';
  if (!figure || !BeginsWithUnit(text.substr(end + 1))) return end;
  return std::min(text.find(' ', end + 1), text.size());
}

}  // namespace

size_t ColumnsOf(std::string_view text) {
  return static_cast<size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string Wrapped(std::string_view text, size_t width, std::string_view indent, size_t column) {
  std::string lines;
  bool line_begins = true;
  while (!text.empty()) {
    const size_t end = EndOfPiece(text);
    const std::string_view piece = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (piece.empty()) continue;
    const size_t columns = ColumnsOf(piece);
    if (!line_begins && column + 1 + columns > width) {
      lines += fmt::format("\n{}", indent);
      column = ColumnsOf(indent);
    } else if (!line_begins) {
      lines += ' ';
      ++column;
    }
    lines += piece;
    column += columns;
    line_begins = false;
  }
  return lines;
}

size_t TextWidth() {
  winsize size = {};
  if (::isatty(STDOUT_FILENO) == 0 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return std::clamp<size_t>(size.ws_col, 60, 110);
}

}  // namespace flair::cli
