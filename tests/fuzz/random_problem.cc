// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/random_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/validation/validate.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

constexpr int kMostObjects = 7;
constexpr int kMostEdges = 10;

double Length(ByteSource& bytes, double least, double most) {
  return bytes.Rarely(64) ? Nasty(bytes) : bytes.Between(least, most);
}

void AddWalls(const std::vector<std::pair<double, double>>& corners, v1::Room& room) {
  for (const auto& [x, y] : corners) {
    v1::Point2& p = *room.mutable_floor()->add_vertices();
    p.set_x_m(x);
    p.set_y_m(y);
    room.add_walls()->set_name(fmt::format("wall_{}", room.walls_size()));
  }
}

// A rectangle, an L, a T or a slanted room.
void AddFloor(ByteSource& bytes, v1::Room& room) {
  const double w = Length(bytes, 1, 7);
  const double d = Length(bytes, 1, 7);
  const double a = w * bytes.Between(0.05, 0.45);
  const double b = d * bytes.Between(0.05, 0.95);
  switch (bytes.Below(5)) {
    case 0:
      return AddWalls({{0, 0}, {w, 0}, {w, b}, {a, b}, {a, d}, {0, d}}, room);
    case 1:
      return AddWalls({{0, 0}, {w, 0}, {w, b}, {w - a, b}, {w - a, d}, {a, d}, {a, b}, {0, b}}, room);
    case 2:
      return AddWalls({{0, 0}, {w - a, 0}, {w, b}, {w, d}, {0, d}}, room);
    default:
      return AddWalls({{0, 0}, {w, 0}, {w, d}, {0, d}}, room);
  }
}

double WallLength(const v1::Room& room, int wall) {
  const v1::Point2& from = room.floor().vertices(wall);
  const v1::Point2& to = room.floor().vertices((wall + 1) % room.floor().vertices_size());
  return std::hypot(to.x_m() - from.x_m(), to.y_m() - from.y_m());
}

void AddOpening(ByteSource& bytes, v1::Room& room) {
  v1::Opening& opening = *room.add_openings();
  const bool door = bytes.Below(2) == 0;
  const int wall = bytes.Below(room.walls_size());
  opening.set_id(fmt::format("opening_{}", room.openings_size()));
  opening.set_wall(room.walls(wall).name());
  const double length = WallLength(room, wall);
  const double offset = length * bytes.Between(0, 0.9);
  opening.set_offset_m(offset);
  opening.set_width_m(std::min(Length(bytes, 0.1, 1.5), length - offset));
  opening.set_kind(door ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW);
  opening.set_sill_height_m(door ? 0 : bytes.Between(0, 1.2));
  opening.set_head_height_m(2);
  if (!door) return;
  opening.mutable_leaf()->set_hinge(bytes.Below(2) == 0 ? v1::HINGE_SIDE_START : v1::HINGE_SIDE_END);
  opening.mutable_leaf()->set_swing(static_cast<v1::DoorSwing>(1 + bytes.Below(4)));
  opening.mutable_leaf()->set_swing_angle_rad(bytes.Between(0.01, 3.14));
}

// A name that an argument may hold: of an object, opening, wall, zone, side or nothing at all.
std::string Name(ByteSource& bytes, const v1::LayoutGraph& graph, v1::ParameterKind kind) {
  if (bytes.Rarely(40)) return "nobody";
  switch (kind) {
    case v1::PARAMETER_KIND_ZONE:
      return graph.zone_plan().zones(bytes.Below(graph.zone_plan().zones_size())).id();
    case v1::PARAMETER_KIND_FEATURE:
      return fmt::format("opening_{}", 1 + bytes.Below(3));
    case v1::PARAMETER_KIND_WALL:
      return graph.room().walls(bytes.Below(graph.room().walls_size())).name();
    case v1::PARAMETER_KIND_SIDE:
    case v1::PARAMETER_KIND_SIDES: {
      constexpr const char* kSides[] = {"front", "back", "left", "right", "any", "top"};
      return kSides[bytes.Below(std::size(kSides))];
    }
    case v1::PARAMETER_KIND_CORNER: {
      constexpr const char* kCorners[] = {"front_left", "front_right", "back_left", "back_right"};
      return kCorners[bytes.Below(std::size(kCorners))];
    }
    default:
      return fmt::format("object_{}", 1 + bytes.Below(kMostObjects));
  }
}

void SetValue(ByteSource& bytes, const v1::LayoutGraph& graph, const v1::ParameterSpec& parameter,
              v1::ArgumentValue& value) {
  switch (parameter.kind()) {
    case v1::PARAMETER_KIND_NUMBER: {
      const double least = parameter.has_min_number() ? parameter.min_number() : -1;
      const double most = parameter.has_max_number() ? parameter.max_number() : 10;
      value.set_number(bytes.Rarely(20) ? Nasty(bytes) : bytes.Between(least, most));
      break;
    }
    case v1::PARAMETER_KIND_BOOLEAN:
      value.set_flag(bytes.Below(2) == 0);
      break;
    case v1::PARAMETER_KIND_OBJECTS:
    case v1::PARAMETER_KIND_SIDES:
      value.mutable_texts();
      for (int i = bytes.Below(5); i >= 0; --i) value.mutable_texts()->add_items(Name(bytes, graph, parameter.kind()));
      break;
    default:
      value.set_text(Name(bytes, graph, parameter.kind()));
  }
}

void AddPin(ByteSource& bytes, v1::LayoutGraph& graph) {
  v1::Placement& pin = *graph.add_pinned_placements();
  pin.set_object_id(fmt::format("object_{}", 1 + bytes.Below(kMostObjects)));
  pin.set_x_m(Length(bytes, -1, 7));
  pin.set_y_m(Length(bytes, -1, 7));
  pin.set_theta_rad(bytes.Between(0, 6.28));
}

// What the metrics may see of shapes that touch: rounding over some metres.
constexpr double kTouching_m = 2e-6;
constexpr double kTouching_percent = 1e-3;

void CheckFinite(const v1::LayoutMetrics& metrics) {
  for (double value : {metrics.oob_percent(), metrics.oor_percent(), metrics.reachable_floor_share(),
                       metrics.reachable_front_share(), metrics.pathway_cost_m3(), metrics.deepest_overlap_m()}) {
    Require(std::isfinite(value) && value >= 0, "metrics are finite and not negative");
  }
}

void CheckNamed(const v1::SolvedLayout& layout) {
  std::set<std::string> named;
  std::set<std::string> placed;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) named.insert(diagnostic.subject_id());
  for (const v1::Placement& placement : layout.placements()) placed.insert(placement.object_id());
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    Require(placed.contains(object.id()) || named.contains(object.id()), "every object is placed or said why not");
  }
  const v1::LayoutMetrics& metrics = layout.metrics();
  const bool exact = metrics.deepest_overlap_m() <= kTouching_m && metrics.oob_percent() <= kTouching_percent &&
                     metrics.oor_percent() <= kTouching_percent;
  Require(exact || !layout.diagnostics().empty(),
          fmt::format("what does not fit is named: {}", metrics.ShortDebugString()));
}

void CheckLayout(const v1::LayoutGraph& graph, const v1::SolvedLayout& layout) {
  Require(Validate(layout).ok(), "a solved layout is valid");
  Require(layout.edge_outcomes_size() == graph.edges_size(), "every edge has its outcome");
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    Require(std::isfinite(outcome.missed_by()), "what an edge misses by is finite");
    Require(outcome.status() != v1::OUTCOME_STATUS_DROPPED || !outcome.reason().empty(), "a dropped edge says why");
  }
  CheckFinite(layout.metrics());
  CheckNamed(layout);
}

}  // namespace

double Nasty(ByteSource& bytes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kNumbers[] = {0, -0.0, -1, 1e-300, 1e-9, 1e9, 1e300, kInfinity, -kInfinity, kNan};
  return kNumbers[bytes.Below(std::size(kNumbers))];
}

void AddRandomObject(ByteSource& bytes, v1::LayoutGraph& graph) {
  v1::Object& object = *graph.mutable_object_list()->add_objects();
  const int number = graph.object_list().objects_size();
  object.set_id(fmt::format("object_{}", bytes.Rarely(100) ? 1 : number));
  object.set_name(object.id());
  object.set_role(static_cast<v1::ObjectRole>(1 + bytes.Below(3)));
  const bool tertiary = object.role() == v1::OBJECT_ROLE_TERTIARY;
  object.set_kind(tertiary ? static_cast<v1::ObjectKind>(1 + bytes.Below(4)) : v1::OBJECT_KIND_FLOOR);
  object.set_walk_over(object.kind() == v1::OBJECT_KIND_FLOOR && bytes.Rarely(6));
  object.set_zone_id(graph.zone_plan().zones(bytes.Below(graph.zone_plan().zones_size())).id());
  object.set_width_m(Length(bytes, 0.01, 3));
  object.set_depth_m(Length(bytes, 0.01, 2));
  object.set_height_m(Length(bytes, 0.01, 2.5));
  if (object.kind() == v1::OBJECT_KIND_WALL) object.set_elevation_m(bytes.Between(0, 2.5));
  if (bytes.Rarely(5)) object.set_host_id(fmt::format("object_{}", 1 + bytes.Below(number)));
}

void AddRandomEdge(ByteSource& bytes, v1::LayoutGraph& graph) {
  const v1::ConstraintCatalog& catalog = optimizer::MakeCatalog();
  const v1::ConstraintType& type = catalog.types(bytes.Below(catalog.types_size()));
  v1::ConstraintEdge& edge = *graph.add_edges();
  edge.set_id(fmt::format("edge_{}", graph.edges_size()));
  edge.set_type(bytes.Rarely(50) ? "no_such_type" : type.name());
  edge.set_weight(Length(bytes, 0.01, 100));
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (parameter.required() ? bytes.Rarely(50) : bytes.Below(2) == 0) continue;
    v1::Argument& argument = *edge.add_arguments();
    argument.set_name(parameter.name());
    SetValue(bytes, graph, parameter, *argument.mutable_value());
  }
}

v1::LayoutGraph RandomGraph(ByteSource& bytes) {
  v1::LayoutGraph graph;
  graph.mutable_room()->set_room_type("room");
  graph.mutable_room()->set_height_m(bytes.Between(2, 4));
  AddFloor(bytes, *graph.mutable_room());
  for (int i = bytes.Below(4); i > 0; --i) AddOpening(bytes, *graph.mutable_room());
  for (int i = bytes.Below(3); i >= 0; --i) {
    v1::Zone& zone = *graph.mutable_zone_plan()->add_zones();
    zone.set_id(fmt::format("zone_{}", i));
    zone.set_name(zone.id());
  }
  for (int i = bytes.Below(kMostObjects); i >= 0; --i) AddRandomObject(bytes, graph);
  for (int i = bytes.Below(kMostEdges + 1); i > 0; --i) AddRandomEdge(bytes, graph);
  if (bytes.Rarely(3)) AddPin(bytes, graph);
  return graph;
}

v1::SolveOptions RandomOptions(ByteSource& bytes) {
  v1::SolveOptions options;
  options.set_seed(bytes.Byte());
  options.set_max_restart_count(1 + bytes.Below(2));
  options.set_thread_count(1);
  options.set_path_width_m(bytes.Rarely(4) ? bytes.Between(0, 2) : 0.6);
  options.mutable_tolerances()->set_max_evaluation_count(2 + bytes.Below(20));
  if (bytes.Rarely(4)) options.set_variant_count(1 + bytes.Below(3));
  if (bytes.Rarely(3)) options.set_misfit_policy(v1::MISFIT_POLICY_LEAVE_OUT);
  if (bytes.Rarely(8)) options.set_find_contradictions(true);
  if (bytes.Rarely(8)) options.mutable_lambdas()->set_no_overlap(bytes.Between(0, 1e6));
  return options;
}

// The solver's entry on small problems. What must hold of every result:
//   a refusal is INVALID_ARGUMENT with a reason, and comes exactly when graph or options do not validate;
//   every number is finite, and the layout passes its own validation;
//   every object is placed or named in the diagnostics;
//   what overlaps or lies out of the room according to the metrics is named in the diagnostics.

void SolveProblem(std::string_view bytes) {
  ByteSource source(bytes);
  const v1::LayoutGraph graph = RandomGraph(source);
  const v1::SolveOptions options = RandomOptions(source);
  const bool good = Validate(graph).ok() && Validate(options).ok();
  const optimizer::NloptSolver solver;
  const absl::StatusOr<optimizer::SolveResult> result = optimizer::SolveLayout(graph, options, solver);
  Require(result.ok() == good, "what validates is solved, and nothing else");
  if (!result.ok()) {
    Require(absl::IsInvalidArgument(result.status()) && !result.status().message().empty(), "a refusal says why");
    return;
  }
  CheckLayout(graph, result->layout);
}

}  // namespace flair::fuzz
