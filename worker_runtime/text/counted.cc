// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/text/counted.h"

#include "fmt/format.h"

namespace flair {

std::string Counted(int64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string Counted(int64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, Form(count, one, many));
}

}  // namespace flair
