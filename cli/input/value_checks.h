// SPDX-License-Identifier: GPL-3.0-or-later
// What values of flags must be. Errors read "--seed: abc: expected a whole number, 0 to 100"; the help texts say the
// same in their own words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"

namespace flair::cli {

// The largest seed: what JSON and double precision keep exactly.
inline constexpr int64_t kLargestSeed = (int64_t{1} << 53) - 1;

CLI::Validator WholeNumber(int64_t least, int64_t most);
CLI::Validator Number(double least, double most);
CLI::Validator OneOf(std::vector<std::string> words);

inline CLI::Validator Seed() { return WholeNumber(0, kLargestSeed); }

}  // namespace flair::cli
