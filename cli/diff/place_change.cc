// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diff/place_change.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

constexpr double kVisible_m = 1e-3;
constexpr double kVisible_deg = 0.1;
constexpr double kDegrees = 180 / std::numbers::pi;

// Of eight, counted counter-clockwise from the east.
const char* Direction(double east_m, double north_m) {
  constexpr const char* kNames[] = {"east", "north-east", "north", "north-west",
                                    "west", "south-west", "south", "south-east"};
  const double eighths = std::atan2(north_m, east_m) / (std::numbers::pi / 4);
  return kNames[(static_cast<int>(std::lround(eighths)) + 8) % 8];
}

// Small moves in millimetres: "0.00 m" says nothing.
std::string Length(double length_m) {
  return length_m < 0.01 ? fmt::format("{:.0f} mm", 1e3 * length_m) : fmt::format("{:.2f} m", length_m);
}

}  // namespace

double PlaceChange::distance_m() const { return std::hypot(east_m, north_m); }

bool PlaceChange::is_any() const { return east_m != 0 || north_m != 0 || up_m != 0 || turn_rad != 0; }

bool PlaceChange::is_visible() const { return !InWords().empty(); }

std::string PlaceChange::InWords() const {
  std::vector<std::string> words;
  if (distance_m() >= kVisible_m) {
    words.push_back(fmt::format("moved {} {}", Length(distance_m()), Direction(east_m, north_m)));
  }
  if (const double turn_deg = turn_rad * kDegrees; std::abs(turn_deg) >= kVisible_deg) {
    const double shown = std::round(10 * std::abs(turn_deg)) / 10;
    words.push_back(shown == 180 ? "turned round"
                                 : fmt::format("turned {:g}° {}", shown, turn_deg > 0 ? "left" : "right"));
  }
  if (std::abs(up_m) >= kVisible_m) {
    words.push_back(fmt::format("{} {}", Length(std::abs(up_m)), up_m > 0 ? "higher" : "lower"));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

nlohmann::json PlaceChange::ToJson() const {
  return {{"distance_m", distance_m()},
          {"east_m", east_m},
          {"north_m", north_m},
          {"up_m", up_m},
          {"turn_deg", turn_rad * kDegrees}};
}

PlaceChange ChangeOf(const v1::Placement& a, const v1::Placement& b) {
  return {.east_m = b.x_m() - a.x_m(),
          .north_m = b.y_m() - a.y_m(),
          .up_m = b.z_m() - a.z_m(),
          .turn_rad = std::remainder(b.theta_rad() - a.theta_rad(), 2 * std::numbers::pi)};
}

}  // namespace flair::cli
