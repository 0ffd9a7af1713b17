// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/shortfall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr double kLeast_m = 1e-3, kLeast_deg = 0.1, kMetresPerDegree = 0.02;

double Degrees(double angle_rad) { return angle_rad * 180 / kPi; }

bool IsMissed(const Shortfall& s) { return s.missed_by > (s.unit == "deg" ? kLeast_deg : kLeast_m); }
double Weight(const Shortfall& s) { return s.unit == "deg" ? kMetresPerDegree * s.missed_by : s.missed_by; }

// "the desk and the chair", the objects that the call names.
std::string AllNamed(const v1::ConstraintEdge& edge, const Scene& scene) {
  std::string names;
  for (int object : NamedObjects(edge, scene)) names += (names.empty() ? "" : " and ") + NameForPeople(scene, object);
  return names.empty() ? "the room" : names;
}

}  // namespace

std::optional<Shortfall> Explain(const v1::ConstraintEdge& edge, const Furnished& where) {
  const ConstraintFacts* const facts = FindConstraint(edge.type());
  if (facts == nullptr) return std::nullopt;
  const absl::StatusOr<Arguments> arguments = Arguments::Resolve(facts->type, edge, where.scene);
  if (!arguments.ok()) return std::nullopt;
  const PlacedCall call(edge, *arguments, where);
  const double missed = call.CostRoot();
  if (missed == 0) return std::nullopt;
  if (facts->code.shortfall != nullptr) {
    if (std::optional<Shortfall> shortfall = facts->code.shortfall(call)) return shortfall;
  } else if (facts->code.place != nullptr) {
    if (std::optional<Shortfall> shortfall = Worst({OffBy(call.NameOf("object"), facts->code.place, missed)}))
      return shortfall;
  }
  if (facts->type.built_in()) return std::nullopt;
  // Several small misses may add up to what none of them is; and a new type may measure none.
  return Worst(
      {{fmt::format("what is asked of {} is missed by {:.2f} m", AllNamed(edge, where.scene), missed), missed, "m"}});
}

double PlacedCall::CostRoot() const {
  const absl::StatusOr<std::unique_ptr<Cost>> cost =
      Bind(edge_, BindContext{where_.scene, where_.zone_centers, where_.linked});
  if (!cost.ok()) return 0;
  std::vector<Pose<double>> poses;
  for (int object : (*cost)->objects()) poses.push_back(where_.layout[static_cast<size_t>(object)]);
  return std::sqrt((*cost)->Value(poses));
}

std::vector<int> PlacedCall::WallsMeant() const {
  std::vector<int> walls = arguments_.Walls("wall");
  if (walls.empty()) {
    walls.resize(scene().room.walls.size());
    std::iota(walls.begin(), walls.end(), 0);
  }
  return walls;
}

const Wall& PlacedCall::MeantWall(Side side) const {
  const std::vector<Wall>& walls = scene().room.walls;
  const std::vector<int> named = WallsMeant();
  const bool is_named = !arguments_.Walls("wall").empty();
  const Vec2<double> middle = MiddleOf(FootprintOf(object()), FrameOf(object()), side);
  const double length_m = SideLength(FootprintOf(object()), side);
  const auto unlikely = [&](int i) {
    const Wall& wall = walls[static_cast<size_t>(i)];
    return std::pair(is_named && wall.length_m < length_m - kLeast_m,
                     DistanceTo(Segment{wall.start, wall.end}, middle));
  };
  return walls[static_cast<size_t>(*std::ranges::min_element(named, {}, unlikely))];
}

double PlacedCall::NearestFeatureGap() const {
  const std::optional<Side> side = arguments_.Has("side") ? arguments_.MaybeSide("side") : std::optional<Side>();
  const Box<double> box = SideBoxOf(object(), side);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& segment : FeatureSegments(scene().room, arguments_.Feature("feature"))) {
    nearest = std::min(nearest, Gap<double>(box, ConvexPiece(segment)));
  }
  return nearest;
}

std::string PlacedCall::FeatureName() const {
  const RoomFeature feature = arguments_.Feature("feature");
  const std::string name = optimizer::FeatureName(scene().room, feature);
  if (feature.opening >= 0) return name;
  return fmt::format("the {}{}", FeatureSegments(scene().room, feature).size() > 1 ? "nearest " : "", name);
}

std::string SideOf(const std::string& object, Side side) {
  return fmt::format("the {} of {}", std::string(SideName(side)), object);
}

std::string WhoLooks(const PlacedCall& call, int object, Look look) {
  return look == Look::kOwn ? SideOf(call.Name(object), Side::kFront) : "whoever uses " + call.Name(object);
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

std::vector<Shortfall> OffWall(const PlacedCall& call, int object, Side side, const Wall& wall) {
  const Footprint& footprint = call.FootprintOf(object);
  const Frame<double> frame = call.FrameOf(object);
  const Vec2<double> middle = MiddleOf(footprint, frame, side);
  const std::string what = SideOf(call.Name(object), side), place = WallName(call.scene().room, wall);
  const double overhang = std::sqrt(SquaredOverhang(footprint, middle, side, wall));
  return {OffBy(what, place, wall.Height(middle)),
          Turned(what, place, AngleOf(NormalOf(frame, side), -wall.inward_normal)),
          {fmt::format("{} reaches {:.2f} m beyond the end of {}", call.Name(object), overhang, place), overhang, "m"}};
}

std::optional<Shortfall> OffMiddle(const PlacedCall& call, int object, int target) {
  return Worst({OffBy(call.Name(object), "the middle of " + call.Name(target),
                      Norm(call.FrameOf(object).center - call.FrameOf(target).center))});
}

std::optional<Shortfall> OffZone(const PlacedCall& call) {
  const Zone& zone = call.scene().zones[static_cast<size_t>(call.arguments().Zone("zone"))];
  return Worst({OffBy(call.NameOf("object"), fmt::format("the {} zone", zone.name), call.CostRoot() / 2)});
}

std::optional<Shortfall> Worst(const std::vector<Shortfall>& shortfalls) {
  std::optional<Shortfall> worst;
  for (const Shortfall& shortfall : shortfalls) {
    if (IsMissed(shortfall) && (!worst || Weight(shortfall) > Weight(*worst))) worst = shortfall;
  }
  return worst;
}

double AngleOf(const Vec2<double>& a, const Vec2<double>& b) { return std::abs(std::atan2(Cross(a, b), Dot(a, b))); }

}  // namespace flair::optimizer
