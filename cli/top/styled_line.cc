// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/styled_line.h"

#include <algorithm>

#include "cli/output/printable.h"
#include "cli/output/wrapped_text.h"

namespace flair::cli {
namespace {

bool Continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// The first so many characters.
std::string_view First(std::string_view text, int count) {
  size_t end = 0;
  while (end < text.size() && count > 0) {
    ++end;
    while (end < text.size() && Continues(text[end])) ++end;
    --count;
  }
  return text.substr(0, end);
}

std::string_view Code(Style style) {
  switch (style) {
    case Style::kBold:
      return "\x1b[1m";
    case Style::kDim:
      return "\x1b[2m";
    case Style::kGood:
      return "\x1b[32m";
    case Style::kWarning:
      return "\x1b[33m";
    case Style::kBad:
      return "\x1b[31m";
    default:
      return "";
  }
}

std::string Fitted(std::string_view text, int width) {
  return Shortened(PrintableLine(std::string(text)), static_cast<size_t>(std::max(0, width)));
}

}  // namespace

int CharacterCount(std::string_view text) { return static_cast<int>(ColumnsOf(text)); }

StyledLine& StyledLine::Add(std::string_view text, Style style) {
  const std::string line = PrintableLine(std::string(text));
  const std::string_view fitting = First(line, width_ - used_);
  if (fitting.empty()) return *this;
  used_ += CharacterCount(fitting);
  const bool styled = color_ && style != Style::kPlain;
  if (styled) text_ += Code(style);
  text_ += fitting;
  if (styled) text_ += "\x1b[0m";
  return *this;
}

StyledLine& StyledLine::Left(std::string_view text, int column_width, Style style) {
  const std::string fitted = Fitted(text, column_width);
  Add(fitted, style);
  return Add(std::string(static_cast<size_t>(std::max(0, column_width - CharacterCount(fitted))), ' '));
}

StyledLine& StyledLine::Right(std::string_view text, int column_width, Style style) {
  const std::string fitted = Fitted(text, column_width);
  Add(std::string(static_cast<size_t>(std::max(0, column_width - CharacterCount(fitted))), ' '));
  return Add(fitted, style);
}

}  // namespace flair::cli
