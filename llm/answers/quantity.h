// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace flair::llm {

// A number as people write it, in `unit`: "1.2", "1,2", "about 1.2 m", "1 1/2", "1½ m", "two metres". For "m" also "120
// cm", "1200 mm", "48 in", "4 ft", "5'6\"", "5 ft 6 in", "1 m 20 cm"; for "deg" also "90°" and radians in "1.57 rad";
// words up to twelve. Nothing when the meaning is not certain ("1,200", "1-2", "1.2 x 0.6").
std::optional<double> ReadQuantity(std::string_view text, std::string_view unit);

// A number of things: as ReadQuantity without a unit, also "2x", "x2", "2 pieces".
std::optional<double> ReadCount(std::string_view text);

// "2-3", "1.4 to 1.6 m": two numbers, the smaller first.
struct QuantityRange {
  double least = 0;
  double most = 0;
};
std::optional<QuantityRange> ReadRange(std::string_view text, std::string_view unit);

// The name of a length's or an angle's unit, as it is written in `bare` letters ("cm", "inches"), for ReadQuantity;
// empty when it is none of `unit`'s kind.
std::string_view UnitNamed(std::string_view bare, std::string_view unit);

}  // namespace flair::llm
