// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace flair::language {

// Words of walls, as lists separated by spaces.
inline constexpr std::string_view kCompassPoints = "north south east west northern southern eastern western";
inline constexpr std::string_view kSiteSides =
    "north south east west northern southern eastern western left right far farthest furthest back rear front near "
    "nearest "
    "long longer longest short shorter shortest narrow opposite entrance";
inline constexpr std::string_view kWallNouns = "wall walls side sides facade elevation";
inline constexpr std::string_view kIntoWords = "in on at along to towards toward onto across facing through from into";

}  // namespace flair::language
