// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/printable.h"

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

}  // namespace flair::cli
