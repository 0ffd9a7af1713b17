// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/placement.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// How far and where something went, in room frame R.
struct PlaceChange {
  double east_m = 0;
  double north_m = 0;
  double up_m = 0;
  double turn_rad = 0;  // counter-clockwise, (-pi, pi]

  double distance_m() const;  // along the floor
  // At all, and by at least 1 mm or 0.1°.
  bool is_any() const;
  bool is_visible() const;
  // "moved 0.35 m west, turned 90° left"; empty when nothing of it is visible.
  std::string InWords() const;
  // distance_m, east_m, north_m, up_m and turn_deg.
  nlohmann::json ToJson() const;
};

PlaceChange ChangeOf(const v1::Placement& a, const v1::Placement& b);

}  // namespace flair::cli
