// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/object_size.h"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace flair::language {
namespace {

// Whether a length is at most so many times as large as a class gets, and at least as small as that allows.
bool IsWithin(double value_m, const hb::Extent& extent, double factor) {
  const double low_m = extent.min() > 0 ? extent.min() : extent.typical();
  const double high_m = extent.max() > 0 ? extent.max() : extent.typical();
  return high_m <= 0 || (value_m <= factor * high_m && value_m >= low_m / factor);
}

// Longer and shorter side of a class: width and depth of an object may be meant the other way round.
std::pair<const hb::Extent&, const hb::Extent&> SidesOf(const hb::Furniture& furniture) {
  const hb::Extent &width = furniture.width_m(), &depth = furniture.depth_m();
  if (width.typical() >= depth.typical()) return {width, depth};
  return {depth, width};
}

}  // namespace

bool IsRugName(std::string_view name) {
  static const std::set<std::string, std::less<>> kRugs = {"rug",  "rugs",   "carpet",    "carpets", "mat",
                                                           "mats", "runner", "sheepskin", "doormat", "tatami"};
  const std::string words = PlainName(name);
  const size_t space = words.rfind(' ');
  const std::string last = space == std::string::npos ? words : words.substr(space + 1);
  // A table runner lies on a table, a place mat too.
  if (words.starts_with("table ") || words.starts_with("place ") || words.starts_with("desk ")) return false;
  return kRugs.contains(last);
}

std::string OddSize(const ObjectSize& size, const hb::Furniture* furniture) {
  if (furniture == nullptr) return "";
  constexpr double kFactor = 2.5;
  const auto [longer, shorter] = SidesOf(*furniture);
  const auto odd = [](double value_m, const hb::Extent& extent) {
    return value_m > 0 && !IsWithin(value_m, extent, kFactor);
  };
  if (!odd(std::max(size.width_m, size.depth_m), longer) && !odd(std::min(size.width_m, size.depth_m), shorter)) {
    return "";
  }
  return fmt::format("is {}; a {} usually measures {:g} m x {:g} m", FootprintText(size), furniture->name(),
                     furniture->width_m().typical(), furniture->depth_m().typical());
}

std::optional<llm::Fault> FootprintFault(const std::string& path, const ObjectSize& size, const FloorExtent& floor,
                                         const hb::Furniture* furniture) {
  const bool fits = std::max(size.width_m, size.depth_m) <= std::max(floor.width_m, floor.depth_m) &&
                    std::min(size.width_m, size.depth_m) <= std::min(floor.width_m, floor.depth_m);
  if (!fits) {
    return llm::Fault{path + ".width_m", fmt::format("{} is larger than the room of {:g} m x {:g} m",
                                                     FootprintText(size), floor.width_m, floor.depth_m)};
  }
  std::string odd = OddSize(size, furniture);
  if (odd.empty()) return std::nullopt;
  return llm::Fault{path + ".width_m", std::move(odd), llm::FaultKind::kDoubtful};
}

std::string FootprintText(const ObjectSize& size) { return fmt::format("{:g} m x {:g} m", size.width_m, size.depth_m); }

}  // namespace flair::language
