// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace flair {

// Whether objects and lists of a JSON text are at most so many levels deep: what is deeper may end a parser's stack.
inline bool NestsWithin(std::string_view json, int most) {
  int depth = 0;
  bool in_string = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > most) return false;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return true;
}

}  // namespace flair
