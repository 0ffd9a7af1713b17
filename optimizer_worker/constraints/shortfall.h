// SPDX-License-Identifier: GPL-3.0-or-later
// Why a call does not hold, in the terms of its sentence: what was measured, and what would be right. Each type
// measures its own shortfall beside its formula, with the phrases below.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "room/geometry/gap.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// The part of a call that is missed by most.
struct Shortfall {
  // "the desk is 0.92 m from the window, at most 0.50 m". No capital, no full stop.
  std::string sentence;
  double missed_by = 0;
  // "m" or "deg".
  std::string unit;
};

// What a call is measured in.
struct Furnished {
  const Scene& scene;
  const Layout& layout;
  // Mean point of each zone.
  std::span<const Vec2<double>> zone_centers;
  // As for BindContext.
  const LinkedPairs* linked = nullptr;
};

// For a call that binds and whose objects all have poses; in general terms for a type without a shortfall of its own.
// nullopt when its cost is 0, when no measure of it is off by more than 1 mm or 0.1 degrees, and for whole-room terms.
// Pure; safe to call from several threads.
std::optional<Shortfall> Explain(const v1::ConstraintEdge& edge, const Furnished& where);

// One call in its layout.
class PlacedCall {
 public:
  PlacedCall(const v1::ConstraintEdge& edge, const Arguments& arguments, const Furnished& where)
      : edge_(edge), arguments_(arguments), where_(where) {}

  const Arguments& arguments() const { return arguments_; }
  const Scene& scene() const { return where_.scene; }
  const LinkedPairs* linked() const { return where_.linked; }
  int object() const { return arguments_.Object("object"); }
  int target() const { return arguments_.Object("target"); }

  std::string Name(int object) const { return NameForPeople(where_.scene, object); }
  std::string NameOf(std::string_view parameter) const { return Name(arguments_.Object(parameter)); }
  const Footprint& FootprintOf(int object) const { return where_.scene.objects[static_cast<size_t>(object)].footprint; }
  Frame<double> FrameOf(int object) const { return flair::FrameOf(where_.layout[static_cast<size_t>(object)]); }
  Box<double> BoxOf(int object) const { return {FootprintOf(object), FrameOf(object)}; }
  // The strip of no depth along a side, or the whole object.
  Box<double> SideBoxOf(int object, std::optional<Side> side) const {
    return side ? Box<double>::Before(FootprintOf(object), FrameOf(object), *side, 0) : BoxOf(object);
  }
  double GapBetween(int a, int b) const { return Gap<double>(BoxOf(a), BoxOf(b)); }
  // Root of the call's cost, a length: for calls whose parts say no more.
  double CostRoot() const;
  // The wall of least `cost(wall)`, of those that the call names if it does.
  template <typename WallCost>
  const Wall& BestWall(const WallCost& cost) const {
    const std::vector<Wall>& walls = scene().room.walls;
    const std::vector<int> named = WallsMeant();
    const auto cost_of = [&](int wall) { return cost(walls[static_cast<size_t>(wall)]); };
    return walls[static_cast<size_t>(*std::ranges::min_element(named, {}, cost_of))];
  }
  // The wall that people take to be meant, of those that the call names if it does: the one nearest to the middle of
  // that side of the object, to which a line is drawn; of those that the call names none that is too short for it.
  const Wall& MeantWall(Side side) const;
  // Gap from the object, or its side when the call names one, to the nearest feature of the call's kind.
  double NearestFeatureGap() const;
  // "the door", "the nearest window".
  std::string FeatureName() const;

 private:
  // Indices of the walls that the call names; all when it names none.
  std::vector<int> WallsMeant() const;

  const v1::ConstraintEdge& edge_;
  const Arguments& arguments_;
  const Furnished& where_;
};

// "the front of the desk".
std::string SideOf(const std::string& object, Side side);
// "the front of the armchair", "whoever uses the desk".
std::string WhoLooks(const PlacedCall& call, int object, Look look);

// All may be negative or 0: then nothing is missed.
Shortfall TooFar(const std::string& what, const std::string& from, double distance_m, double most_m);
Shortfall TooNear(const std::string& what, const std::string& from, double distance_m, double least_m);
Shortfall OffBy(const std::string& what, const std::string& from, double distance_m);
// `angle_rad` from where it should look.
Shortfall Turned(const std::string& what, const std::string& from, double angle_rad, double most_rad = 0);
// How a side misses lying on a wall.
std::vector<Shortfall> OffWall(const PlacedCall& call, int object, Side side, const Wall& wall);
// From the middle of one to the middle of the other.
std::optional<Shortfall> OffMiddle(const PlacedCall& call, int object, int target);
// From the zone that the call names.
std::optional<Shortfall> OffZone(const PlacedCall& call);

// The one that is missed by most, a degree counting as much as 2 cm; nullopt when none is missed by 1 mm or 0.1
// degrees.
std::optional<Shortfall> Worst(const std::vector<Shortfall>& shortfalls);

// Angle between two directions, [0, pi].
double AngleOf(const Vec2<double>& a, const Vec2<double>& b);

}  // namespace flair::optimizer
