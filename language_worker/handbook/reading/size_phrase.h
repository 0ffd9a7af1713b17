// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// What a brief says about the room's size. Everything in metres; unset where it says nothing.
struct SizeRequest {
  std::optional<double> width_m;  // west to east
  std::optional<double> depth_m;  // south to north
  std::optional<double> area_m2;
  std::optional<double> height_m;
  double area_factor = 1;            // of words such as "small"
  std::optional<double> side_ratio;  // shorter by longer side, of words such as "narrow"

  bool in_numbers() const { return width_m || depth_m || area_m2; }
};

// Reads sizes as people write them: "4m x 5m", "12ft by 10ft", "12'6\" x 14'", "20 square metres", "5 m square",
// "small", "2.7m ceiling". INVALID_ARGUMENT with the value and what would be right for sides outside [1, 100] m, areas
// outside [1.5, 2000] m2 and ceilings outside [2, 12] m. Marks the tokens that it has used.
absl::StatusOr<SizeRequest> ReadSize(const std::vector<Token>& tokens, const Handbook& handbook,
                                     std::vector<bool>& used);

}  // namespace flair::language
