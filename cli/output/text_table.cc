// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text_table.h"

#include <algorithm>
#include <numeric>

#include "fmt/format.h"

namespace flair::cli {

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

}  // namespace flair::cli
