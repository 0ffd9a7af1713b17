// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::cli {

enum class Style { kPlain, kBold, kDim, kGood, kWarning, kBad };

// A line of so many characters at most, put together from left to right; what would go beyond is cut. Text is counted
// in characters of UTF-8; control characters become spaces.
class StyledLine {
 public:
  StyledLine(int width, bool color) : width_(width), color_(color) {}

  StyledLine& Add(std::string_view text, Style style = Style::kPlain);
  // In a column so wide, set to the left or to the right, and cut with "…" where it is longer.
  StyledLine& Left(std::string_view text, int column_width, Style style = Style::kPlain);
  StyledLine& Right(std::string_view text, int column_width, Style style = Style::kPlain);

  const std::string& text() const { return text_; }

 private:
  const int width_;
  const bool color_;
  int used_ = 0;
  std::string text_;
};

// Characters of UTF-8.
int CharacterCount(std::string_view text);

}  // namespace flair::cli
