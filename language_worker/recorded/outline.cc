// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/outline.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "language_worker/recorded/object_names.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

constexpr size_t kMostLines = 2000, kLongestLine = 2000;
// Depths: headings 1 to 6, then titles in bold or plain text, then items by their indent.
constexpr int kBoldDepth = 7, kTextDepth = 8, kItemDepth = 10;

std::string_view Strip(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return "";
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

// Without stars, underscores at words' ends stay, and code marks.
std::string WithoutMarks(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (c != '*' && c != '`') plain += c;
  }
  return std::string(Strip(plain));
}

bool EndsWithColon(std::string_view text) { return !text.empty() && text.back() == ':'; }

std::string WithoutColon(std::string text) {
  while (EndsWithColon(text)) text = std::string(Strip(std::string_view(text).substr(0, text.size() - 1)));
  return text;
}

// "- ", "* ", "• ", "3. ", "b) ": the number of bytes; 0 when it does not begin so.
size_t ItemMark(std::string_view line, bool& numbered) {
  numbered = false;
  constexpr std::string_view kDot = "•";
  if (line.starts_with(kDot)) return kDot.size();
  if (line.size() > 1 && (line[0] == '-' || line[0] == '*' || line[0] == '+') && (line[1] == ' ' || line[1] == '\t')) {
    return 1;
  }
  size_t digits = 0;
  while (digits < line.size() && digits < 3 && absl::ascii_isdigit(line[digits])) ++digits;
  if (digits == 0 || digits + 1 >= line.size() || (line[digits] != '.' && line[digits] != ')')) return 0;
  // "3.2 m" is no item.
  if (line[digits + 1] != ' ' && line[digits + 1] != '*') return 0;
  numbered = true;
  return digits + 1;
}

// Splits "**Label**: text" and "*Label*: text".
void SplitLabel(std::string_view line, OutlineLine& to) {
  const size_t stars = std::min(line.find_first_not_of('*'), line.size());
  const size_t end = stars == 0 || stars > 3 ? std::string_view::npos : line.find(line.substr(0, stars), stars);
  if (end == std::string_view::npos) {
    to.text = WithoutMarks(line);
    return;
  }
  const std::string inside = WithoutMarks(line.substr(stars, end - stars));
  std::string rest = WithoutMarks(line.substr(end + stars));
  if (rest.empty() && inside.ends_with('.')) {
    to.text = inside;  // a whole sentence in italics
    return;
  }
  to.title = rest.empty() || rest == ":";
  if (to.title || EndsWithColon(inside) || rest.starts_with(':') || rest.starts_with('-') || rest.starts_with('(')) {
    to.label = WithoutColon(inside);
    const size_t begin = rest.find_first_not_of(":- \t");
    to.text = begin == std::string::npos ? "" : rest.substr(begin);
  } else {
    to.text = WithoutMarks(line);  // bold words within a sentence
  }
}

OutlineLine ReadLine(std::string_view raw) {
  OutlineLine line;
  int indent = 0;
  for (const char c : raw) {
    if (c != ' ' && c != '\t') break;
    indent += c == '\t' ? 4 : 1;
  }
  std::string_view rest = Strip(raw);
  const size_t hashes = std::min(rest.find_first_not_of('#'), rest.size());
  bool numbered = false;
  if (hashes > 0 && hashes < 7 && hashes < rest.size() && rest[hashes] == ' ') {
    line.kind = LineKind::kHeading;
    line.depth = static_cast<int>(hashes);
    rest = Strip(rest.substr(hashes));
    // "### 1. Living Area"
    rest = Strip(rest.substr(ItemMark(rest, numbered)));
    SplitLabel(rest, line);
    line.title = true;
  } else if (const size_t mark = ItemMark(rest, numbered); mark > 0) {
    line.kind = LineKind::kItem;
    line.depth = kItemDepth + 2 * std::min(indent, 40) + (numbered ? 0 : 1);
    SplitLabel(Strip(rest.substr(mark)), line);
  } else {
    SplitLabel(rest, line);
    // Text that is indented goes on with what is above it.
    line.depth = indent >= 2 ? kItemDepth + 2 * std::min(indent, 40) + 1 : (line.title ? kBoldDepth : kTextDepth);
  }
  line.title = line.title || EndsWithColon(line.text);
  line.text = WithoutColon(std::move(line.text));
  return line;
}

}  // namespace

std::string OutlineLine::All() const {
  if (label.empty() || text.empty()) return label + text;
  return label + ": " + text;
}

std::vector<OutlineLine> ReadOutline(std::string_view text) {
  std::vector<OutlineLine> lines;
  std::vector<int> open;  // the lines that the next one may stand under
  int number = 0;
  while (!text.empty() && lines.size() < kMostLines) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string raw = llm::CutBytes(llm::ToUtf8(text.substr(0, std::min(end, 2 * kLongestLine))), kLongestLine);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    OutlineLine line = ReadLine(raw);
    // "---", "```" and the like say nothing.
    if (ReadWords(line.All()).empty()) continue;
    line.number = number;
    while (!open.empty() && lines[static_cast<size_t>(open.back())].depth >= line.depth) open.pop_back();
    // Plain text closes a list but is no title of the next one unless it says so.
    if (!open.empty()) {
      line.parent = open.back();
      lines[static_cast<size_t>(open.back())].has_children = true;
    }
    open.push_back(static_cast<int>(lines.size()));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace flair::language
