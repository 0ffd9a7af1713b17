// SPDX-License-Identifier: GPL-3.0-or-later
// One call in its layout, and the phrases that explanations are made of.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/explain/explain.h"

namespace flair::optimizer {

class Scope {
 public:
  Scope(const v1::ConstraintEdge& edge, const Arguments& arguments, const Furnished& where)
      : edge_(edge), arguments_(arguments), where_(where) {}

  const Arguments& arguments() const { return arguments_; }
  const Scene& scene() const { return where_.scene; }
  const Furnished& where() const { return where_; }

  std::string Name(int object) const { return NameForPeople(where_.scene, object); }
  std::string NameOf(std::string_view parameter) const { return Name(arguments_.Object(parameter)); }
  const Footprint& FootprintOf(int object) const { return where_.scene.objects[static_cast<size_t>(object)].footprint; }
  Frame<double> FrameOf(int object) const { return flair::FrameOf(where_.layout[static_cast<size_t>(object)]); }
  Box<double> BoxOf(int object) const { return {FootprintOf(object), FrameOf(object)}; }
  // Root of the call's cost, a length: for calls whose parts say no more.
  double CostRoot() const;
  double GapBetween(int a, int b) const { return Gap<double>(BoxOf(a), BoxOf(b)); }

 private:
  const v1::ConstraintEdge& edge_;
  const Arguments& arguments_;
  const Furnished& where_;
};

// "the south wall"; a wall that is just numbered keeps its name.
std::string WallName(const Wall& wall);
// "the front of the desk".
std::string SideOf(const std::string& object, Side side);

// All may be negative or 0: then nothing is missed.
Shortfall TooFar(const std::string& what, const std::string& from, double distance_m, double most_m);
Shortfall TooNear(const std::string& what, const std::string& from, double distance_m, double least_m);
Shortfall OffBy(const std::string& what, const std::string& from, double distance_m);
// `angle_rad` from where it should look.
Shortfall Turned(const std::string& what, const std::string& from, double angle_rad, double most_rad = 0);

// The one that is missed by most, a degree counting as much as 2 cm; nullopt when none is missed by 1 mm or 0.1
// degrees.
std::optional<Shortfall> Worst(const std::vector<Shortfall>& shortfalls);
std::optional<Shortfall> Worst(std::initializer_list<Shortfall> shortfalls);

// Angle between two directions, [0, pi].
double AngleOf(const Vec2<double>& a, const Vec2<double>& b);

using Explainer = std::optional<Shortfall> (*)(const Scope& scope);
// By family; null for types that are not of it.
Explainer FindPlaceExplainer(std::string_view type);
Explainer FindPairExplainer(std::string_view type);
Explainer FindTertiaryExplainer(std::string_view type);

}  // namespace flair::optimizer
