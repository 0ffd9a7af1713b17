// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fmt/format.h"

namespace flair {

// The form that goes with a number: Form(1, "is", "are").
inline std::string_view Form(int64_t count, std::string_view one, std::string_view many) {
  return count == 1 ? one : many;
}

// With both forms said, for what does not just take an s: Counted(2, "battery", "batteries"), or for the verb that
// follows: Counted(1, "stage agrees", "stages agree").
inline std::string Counted(int64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, Form(count, one, many));
}

// A number and its noun: "1 job", "2 jobs".
inline std::string Counted(int64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace flair
