// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/fill.h"

namespace flair::language {

std::string Fill(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string filled;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t close = text[i] == '{' ? text.find('}', i) : std::string_view::npos;
    const auto value = close == std::string_view::npos ? values.end() : values.find(text.substr(i + 1, close - i - 1));
    if (value == values.end()) {
      filled += text[i++];
    } else {
      filled += value->second;
      i = close + 1;
    }
  }
  return filled;
}

}  // namespace flair::language
