// SPDX-License-Identifier: GPL-3.0-or-later
// Text for a terminal: safe to print, in columns, in lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::cli {

// What a stranger wrote must not steer the terminal: control characters but line break and tab become spaces.
std::string Printable(std::string text);

// Line breaks and tabs, too: for a cell of a table.
std::string PrintableLine(std::string text);

// At most `columns` characters; what is longer ends in "…".
std::string Shortened(std::string_view text, size_t columns);

// JSON, on one line or indented; what is not UTF-8 in it is replaced.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// Safe in a cell of a Markdown table.
std::string MarkdownCell(std::string text);

// A table in Markdown; its cells are made safe.
std::string MarkdownTable(const std::vector<std::string>& titles, const std::vector<std::vector<std::string>>& rows);

// Rows of text in columns; lines can be printed while later ones are still being worked out.

class TextTable {
 public:
  // The first column is set to the left, at `first_width`; the others to the right, as wide as their titles or
  // `least_width`.
  TextTable(std::vector<std::string> titles, size_t first_width, size_t least_width = 6);

  // Titles and a rule, each line ending in a newline.
  std::string Header() const;
  // As many cells as there are columns; a first cell that is too long is cut.
  std::string Row(const std::vector<std::string>& cells) const;

 private:
  std::vector<std::string> titles_;
  std::vector<size_t> widths_;
};

// The width in columns of a terminal: bytes that begin a character, which is right for the letters and signs that
// Flair writes itself.
size_t ColumnsOf(std::string_view text);

// Lines of at most `width` columns, each after the first begun with `indent`; `column` is where the first begins.
// Words longer than that stand alone, and figures stay with their unit.
std::string Wrapped(std::string_view text, size_t width, std::string_view indent, size_t column = 0);

// Columns that text on standard output should fit: those of the terminal, at most 110, at least 60; 80 where there is
// none.
size_t TextWidth();

// A table for people: columns as wide as what is in them, two spaces apart; numbers to the right, the rest to the left.
class Columns {
 public:
  // A title that begins with ">" is that of a column set to the right.
  explicit Columns(std::vector<std::string> titles);

  // As many cells as there are titles. Line breaks in a cell become spaces.
  void Add(std::vector<std::string> cells);
  bool empty() const { return rows_.empty(); }

  // Titles, then at most `most` rows, and how many more there are; each line ends in a newline.
  std::string Text(size_t most) const;

 private:
  std::vector<std::string> titles_;
  std::vector<bool> right_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace flair::cli
