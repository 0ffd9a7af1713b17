// SPDX-License-Identifier: GPL-3.0-or-later
// Free text of a model as lines that know what they stand under.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

enum class LineKind { kHeading, kItem, kText };

// One line of Markdown that is not empty, without its marks.
struct OutlineLine {
  // Counted from 1.
  int number = 0;
  LineKind kind = LineKind::kText;
  // Headings, then lines in bold, then items by their indent: a line stands under the nearest one before it with a
  // smaller depth.
  int depth = 0;
  // Index of the line that it stands under; -1 for none.
  int parent = -1;
  bool has_children = false;
  // What is marked bold or italic at the beginning, without a colon behind it; empty when nothing is.
  std::string label;
  // What follows the label; all of the line when there is no label.
  std::string text;
  // It names what stands under it: a heading, a line all in bold, or one that ends in a colon.
  bool title = false;

  // Label and text.
  std::string All() const;
};

// Reads any bytes; what is no UTF-8 becomes U+FFFD. Lines longer than 2,000 bytes are cut, lines after the first 2,000
// left out.
std::vector<OutlineLine> ReadOutline(std::string_view text);

}  // namespace flair::language
