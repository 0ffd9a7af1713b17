// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/explain/scope.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr double kLeast_m = 1e-3, kLeast_deg = 0.1, kMetresPerDegree = 0.02;

double Degrees(double angle_rad) { return angle_rad * 180 / kPi; }

bool IsMissed(const Shortfall& s) { return s.missed_by > (s.unit == "deg" ? kLeast_deg : kLeast_m); }
double Weight(const Shortfall& s) { return s.unit == "deg" ? kMetresPerDegree * s.missed_by : s.missed_by; }

}  // namespace

double Scope::CostRoot() const {
  const absl::StatusOr<std::unique_ptr<Cost>> cost =
      Bind(edge_, BindContext{where_.scene, where_.zone_centers, where_.linked});
  if (!cost.ok()) return 0;
  std::vector<Pose<double>> poses;
  for (int object : (*cost)->objects()) poses.push_back(where_.layout[static_cast<size_t>(object)]);
  return std::sqrt((*cost)->Value(poses));
}

std::string WallName(const Wall& wall) {
  for (const char* name : {"north", "east", "south", "west"}) {
    if (wall.name == name) return fmt::format("the {} wall", name);
  }
  return wall.name;
}

std::string SideOf(const std::string& object, Side side) {
  return fmt::format("the {} of {}", std::string(SideName(side)), object);
}

Shortfall TooFar(const std::string& what, const std::string& from, double distance_m, double most_m) {
  return {fmt::format("{} is {:.2f} m from {}, at most {:.2f} m", what, distance_m, from, most_m), distance_m - most_m,
          "m"};
}

Shortfall TooNear(const std::string& what, const std::string& from, double distance_m, double least_m) {
  return {fmt::format("{} is {:.2f} m from {}, at least {:.2f} m", what, std::max(0.0, distance_m), from, least_m),
          least_m - distance_m, "m"};
}

Shortfall OffBy(const std::string& what, const std::string& from, double distance_m) {
  return {fmt::format("{} is {:.2f} m off {}", what, std::abs(distance_m), from), std::abs(distance_m), "m"};
}

Shortfall Turned(const std::string& what, const std::string& from, double angle_rad, double most_rad) {
  const std::string limit = most_rad > 0 ? fmt::format(", at most {:.0f}", Degrees(most_rad)) : "";
  return {fmt::format("{} is turned {:.0f} degrees from {}{}", what, Degrees(angle_rad), from, limit),
          Degrees(angle_rad - most_rad), "deg"};
}

std::optional<Shortfall> Worst(const std::vector<Shortfall>& shortfalls) {
  std::optional<Shortfall> worst;
  for (const Shortfall& shortfall : shortfalls) {
    if (IsMissed(shortfall) && (!worst || Weight(shortfall) > Weight(*worst))) worst = shortfall;
  }
  return worst;
}

std::optional<Shortfall> Worst(std::initializer_list<Shortfall> shortfalls) {
  return Worst(std::vector<Shortfall>(shortfalls));
}

double AngleOf(const Vec2<double>& a, const Vec2<double>& b) { return std::abs(std::atan2(Cross(a, b), Dot(a, b))); }

}  // namespace flair::optimizer
