// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "fmt/format.h"
#include "fmt/ranges.h"

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

std::string Line(const std::vector<std::string>& cells, const std::vector<size_t>& widths,
                 const std::vector<bool>& right) {
  std::string line;
  for (size_t i = 0; i < cells.size(); ++i) {
    const std::string space(widths[i] - std::min(widths[i], ColumnsOf(cells[i])), ' ');
    line += (i == 0 ? "" : "  ") + (right[i] ? space + cells[i] : cells[i] + space);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string Printable(std::string text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7f) text[i] = ' ';
    // U+0080 to U+009F.
    if (c == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0) text[i] = text[i + 1] = ' ';
  }
  return text;
}

std::string PrintableLine(std::string text) {
  text = Printable(std::move(text));
  for (char& c : text) {
    if (c == '\n' || c == '\t') c = ' ';
  }
  return text;
}

std::string Shortened(std::string_view text, size_t columns) {
  if (ColumnsOf(text) <= columns) return std::string(text);
  std::string cut;
  size_t count = 0;
  for (const char c : text) {
    const bool begins = (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    if (begins && ++count >= columns) break;
    cut += c;
  }
  return columns == 0 ? "" : cut + "…";
}

std::string MarkdownCell(std::string text) {
  for (char& c : text) {
    if (c == '|' || c == '\n') c = '/';
  }
  return text;
}

std::string MarkdownTable(const std::vector<std::string>& titles, const std::vector<std::vector<std::string>>& rows) {
  std::string text = fmt::format("| {} |\n|", fmt::join(titles, " | "));
  for (size_t i = 0; i < titles.size(); ++i) text += " --- |";
  for (const std::vector<std::string>& row : rows) {
    text += "\n|";
    for (const std::string& cell : row) text += fmt::format(" {} |", MarkdownCell(cell));
  }
  return text + "\n";
}

TextTable::TextTable(std::vector<std::string> titles, size_t first_width, size_t least_width)
    : titles_(std::move(titles)) {
  for (const std::string& title : titles_) widths_.push_back(std::max(least_width, title.size()));
  widths_.front() = std::max(first_width, titles_.front().size());
}

std::string TextTable::Header() const {
  const size_t width = std::accumulate(widths_.begin(), widths_.end(), widths_.size() - 1);
  return Row(titles_) + std::string(width, '-') + "\n";
}

std::string TextTable::Row(const std::vector<std::string>& cells) const {
  std::string row = fmt::format("{:<{}}", cells.front().substr(0, widths_.front()), widths_.front());
  for (size_t i = 1; i < cells.size(); ++i) row += fmt::format(" {:>{}}", cells[i], widths_[i]);
  return row + "\n";
}

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

Columns::Columns(std::vector<std::string> titles) : titles_(std::move(titles)) {
  for (std::string& title : titles_) {
    right_.push_back(title.starts_with(">"));
    if (right_.back()) title.erase(0, 1);
  }
}

void Columns::Add(std::vector<std::string> cells) {
  for (std::string& cell : cells) std::ranges::replace(cell, '\n', ' ');
  cells.resize(titles_.size());
  rows_.push_back(std::move(cells));
}

std::string Columns::Text(size_t most) const {
  const size_t shown = std::min(most, rows_.size());
  std::vector<size_t> widths;
  for (size_t i = 0; i < titles_.size(); ++i) {
    widths.push_back(ColumnsOf(titles_[i]));
    for (size_t k = 0; k < shown; ++k) widths[i] = std::max(widths[i], ColumnsOf(rows_[k][i]));
  }
  std::string text = Line(titles_, widths, right_);
  for (size_t k = 0; k < shown; ++k) text += Line(rows_[k], widths, right_);
  if (rows_.size() > shown) text += fmt::format("… {} more; --all shows them\n", rows_.size() - shown);
  return text;
}

}  // namespace flair::cli
