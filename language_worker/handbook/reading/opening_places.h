// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace flair::language {

// What doors lead to, as lists separated by spaces.
inline constexpr std::string_view kOpenAir =
    "garden terrace patio yard backyard courtyard deck veranda balcony outside outdoors lawn porch pool";
inline constexpr std::string_view kInnerRooms =
    "kitchen bathroom ensuite en suite closet wardrobe dressing pantry larder utility laundry cellar basement bedroom "
    "bedrooms living dining study office storeroom store cupboard connecting adjoining internal interior workshop "
    "garage "
    "wc toilet shower lounge library lobby stairs staircase attic loft stage backstage fire emergency service side "
    "back";
inline constexpr std::string_view kWaysIn =
    "hall hallway corridor landing street entrance entry front main passage passageway vestibule";

}  // namespace flair::language
