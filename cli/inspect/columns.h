// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace flair::cli {

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

// At most `most` characters, the last of them "…" when it was longer.
std::string Shortened(const std::string& text, size_t most);

}  // namespace flair::cli
