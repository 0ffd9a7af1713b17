// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/printable.h"

#include <utility>

#include "cli/output/wrapped_text.h"

namespace flair::cli {

std::string Printable(std::string text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7f) text[i] = ' ';
    // U+0080 to U+009F.
    if (c == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0) {
      text[i] = text[i + 1] = ' ';
    }
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

}  // namespace flair::cli
