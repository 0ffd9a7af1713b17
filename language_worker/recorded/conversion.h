// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the lines of recorded texts. Nothing is lost without a word: a line is converted, frames the others,
// or is kept here with the reason.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flair::language {

// A line that has no place in a typed answer.
struct ConversionRemark {
  // Name of the text, such as "secondary_inter".
  std::string source;
  // Counted from 1; 0 when it is about no line.
  int line = 0;
  std::string text;
  std::string reason;
};

struct Conversion {
  // Lines that say something, that is all but headings and what frames a list ("Certainly! Here is ...").
  int lines = 0;
  // Of them, those that are in an answer.
  int converted = 0;
  std::vector<ConversionRemark> remarks;

  void Convert() {
    ++lines;
    ++converted;
  }
  void Keep(std::string_view source, int line, std::string text, std::string reason) {
    ++lines;
    remarks.push_back({std::string(source), line, std::move(text), std::move(reason)});
  }
  // A sentence of a converted line has no place after all.
  void Unconvert(std::string_view source, std::string text, std::string reason) {
    if (converted > 0) --converted;
    remarks.push_back({std::string(source), 0, std::move(text), std::move(reason)});
  }
  void Add(const Conversion& other) {
    lines += other.lines;
    converted += other.converted;
    remarks.insert(remarks.end(), other.remarks.begin(), other.remarks.end());
  }
};

}  // namespace flair::language
