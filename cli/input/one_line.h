// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace flair::cli {

// A request as one line: line breaks and tabs come from copying text; they mean a space.
inline std::string OneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  return text;
}

}  // namespace flair::cli
