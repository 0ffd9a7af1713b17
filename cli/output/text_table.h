// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of text in columns; lines can be printed while later ones are still being worked out.
#pragma once

#include <string>
#include <vector>

namespace flair::cli {

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

}  // namespace flair::cli
