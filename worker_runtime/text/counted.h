// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace flair {

// A number and its noun: "1 job", "2 jobs".
std::string Counted(int64_t count, std::string_view noun);

// With both forms said, for what does not just take an s: Counted(2, "battery", "batteries"), or for the verb that
// follows: Counted(1, "stage agrees", "stages agree").
std::string Counted(int64_t count, std::string_view one, std::string_view many);

// The form that goes with a number: Form(1, "is", "are").
inline std::string_view Form(int64_t count, std::string_view one, std::string_view many) {
  return count == 1 ? one : many;
}

}  // namespace flair
