// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/counted.h"

#include <fmt/format.h>

namespace flair::llm {

std::string Counted(int64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace flair::llm
