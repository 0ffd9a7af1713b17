// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace flair::llm {

// A number and its noun: "1 call", "2 calls".
std::string Counted(int64_t count, std::string_view noun);

// The form that goes with a number: Form(1, "is", "are").
inline std::string_view Form(int64_t count, std::string_view one, std::string_view many) {
  return count == 1 ? one : many;
}

}  // namespace flair::llm
