// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/columns.h"

#include <algorithm>

#include "fmt/format.h"
#include "room/validation/field.h"

namespace flair::cli {
namespace {

size_t WidthOf(const std::string& text) {
  const int characters = validation::CharacterCount(text);
  return characters < 0 ? text.size() : static_cast<size_t>(characters);
}

std::string Line(const std::vector<std::string>& cells, const std::vector<size_t>& widths,
                 const std::vector<bool>& right) {
  std::string line;
  for (size_t i = 0; i < cells.size(); ++i) {
    const std::string space(widths[i] - std::min(widths[i], WidthOf(cells[i])), ' ');
    line += (i == 0 ? "" : "  ") + (right[i] ? space + cells[i] : cells[i] + space);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

Columns::Columns(std::vector<std::string> titles) : titles_(std::move(titles)) {
  for (std::string& title : titles_) {
    right_.push_back(title.starts_with(">"));
    if (right_.back()) title.erase(0, 1);
  }
}

void Columns::Add(std::vector<std::string> cells) {
  for (std::string& cell : cells) std::replace(cell.begin(), cell.end(), '\n', ' ');
  cells.resize(titles_.size());
  rows_.push_back(std::move(cells));
}

std::string Columns::Text(size_t most) const {
  const size_t shown = std::min(most, rows_.size());
  std::vector<size_t> widths;
  for (size_t i = 0; i < titles_.size(); ++i) {
    widths.push_back(WidthOf(titles_[i]));
    for (size_t k = 0; k < shown; ++k) widths[i] = std::max(widths[i], WidthOf(rows_[k][i]));
  }
  std::string text = Line(titles_, widths, right_);
  for (size_t k = 0; k < shown; ++k) text += Line(rows_[k], widths, right_);
  if (rows_.size() > shown) text += fmt::format("… {} more; --all shows them\n", rows_.size() - shown);
  return text;
}

std::string Shortened(const std::string& text, size_t most) {
  size_t characters = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
    if (begins && ++characters == most && WidthOf(text) > most) return text.substr(0, i) + "…";
  }
  return text;
}

}  // namespace flair::cli
