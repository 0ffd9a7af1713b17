// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/object_size.h"

#include <fmt/format.h>

#include <algorithm>

namespace flair::language {

bool FitsFloor(const ObjectSize& size, const FloorExtent& floor) {
  return std::max(size.width_m, size.depth_m) <= std::max(floor.width_m, floor.depth_m) &&
         std::min(size.width_m, size.depth_m) <= std::min(floor.width_m, floor.depth_m);
}

std::string OddSize(const ObjectSize& size, const hb::Furniture* furniture) {
  if (furniture == nullptr) return "";
  constexpr double kFactor = 2.5;
  const auto odd = [](double value_m, const hb::Extent& extent) {
    const double low = extent.min() > 0 ? extent.min() : extent.typical();
    const double high = extent.max() > 0 ? extent.max() : extent.typical();
    return value_m > 0 && high > 0 && (value_m > kFactor * high || value_m < low / kFactor);
  };
  // Width and depth may be meant the other way round.
  const double along_m = std::max(size.width_m, size.depth_m), across_m = std::min(size.width_m, size.depth_m);
  const bool wide = furniture->width_m().typical() >= furniture->depth_m().typical();
  const hb::Extent& longer = wide ? furniture->width_m() : furniture->depth_m();
  const hb::Extent& shorter = wide ? furniture->depth_m() : furniture->width_m();
  if (!odd(along_m, longer) && !odd(across_m, shorter)) return "";
  return fmt::format("is {}; a {} usually measures {:g} m x {:g} m", FootprintText(size), furniture->name(),
                     furniture->width_m().typical(), furniture->depth_m().typical());
}

std::string FootprintText(const ObjectSize& size) { return fmt::format("{:g} m x {:g} m", size.width_m, size.depth_m); }

}  // namespace flair::language
