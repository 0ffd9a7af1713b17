// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "renderer_worker/furniture/classes.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

absl::StatusOr<PlanLayers> LayersOf(const v1::RenderOptions& options) {
  if (options.layers().empty()) return PlanLayers{};
  constexpr bool PlanLayers::*kLayers[] = {&PlanLayers::floor_pieces, &PlanLayers::tertiary,
                                           &PlanLayers::zones,        &PlanLayers::dimensions,
                                           &PlanLayers::constraints,  &PlanLayers::circulation};
  PlanLayers layers{false, false, false, false, false, false};
  for (int i = 0; i < options.layers_size(); ++i) {
    const int layer = options.layers(i) - v1::PLAN_LAYER_FLOOR_PIECES;
    if (layer < 0 || layer >= static_cast<int>(std::size(kLayers))) {
      return InvalidArgument("options.layers[{}]: {} is not a layer", i, static_cast<int>(options.layers(i)));
    }
    layers.*kLayers[layer] = true;
  }
  return layers;
}

namespace {

bool AllFinite(std::initializer_list<double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value) && std::abs(value) < 1e6; });
}

double SignedArea(const std::vector<Point>& polygon) {
  double twice = 0;
  for (size_t i = 0; i < polygon.size(); ++i) twice += Cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

absl::Status ReadFloor(const v1::Room& room, Plan& plan) {
  const int count = room.floor().vertices_size();
  if (count < 3) return InvalidArgument("room.floor.vertices: {} vertices; at least 3", count);
  for (int i = 0; i < count; ++i) {
    const v1::Point2& vertex = room.floor().vertices(i);
    if (!AllFinite({vertex.x_m(), vertex.y_m()})) return InvalidArgument("room.floor.vertices[{}]: must be finite", i);
    plan.floor.push_back({vertex.x_m(), vertex.y_m()});
  }
  plan.bounds_m = BoundsOf(plan.floor);
  plan.area_m2 = SignedArea(plan.floor);
  if (plan.area_m2 < 1e-3) return InvalidArgument("room.floor.vertices: must enclose an area, counter-clockwise");
  for (int i = 0; i < count; ++i) {
    PlanWall wall{plan.floor[i], plan.floor[(i + 1) % count], {}, {}, 0};
    wall.length_m = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
    if (wall.length_m < 1e-6)
      return InvalidArgument("room.floor.vertices[{}]: repeats the vertex before it", (i + 1) % count);
    wall.along = (wall.end - wall.start) * (1 / wall.length_m);
    wall.outward = {wall.along.y, -wall.along.x};
    plan.walls.push_back(wall);
  }
  return absl::OkStatus();
}

int WallNamed(const v1::Room& room, const std::string& name) {
  for (int i = 0; i < room.walls_size() && i < room.floor().vertices_size(); ++i) {
    if (room.walls(i).name() == name) return i;
  }
  return -1;
}

absl::Status ReadOpenings(const v1::Room& room, Plan& plan) {
  for (int i = 0; i < room.openings_size(); ++i) {
    const v1::Opening& opening = room.openings(i);
    const int wall = WallNamed(room, opening.wall());
    if (wall < 0) return InvalidArgument("room.openings[{}].wall: there is no wall \"{}\"", i, opening.wall());
    if (!AllFinite({opening.offset_m(), opening.width_m()}) || opening.width_m() <= 0) {
      return InvalidArgument("room.openings[{}]: offset_m and width_m must be finite, width_m above 0", i);
    }
    PlanOpening read{wall, opening.offset_m(), opening.width_m(), opening.kind() == v1::OPENING_KIND_DOOR};
    if (read.door) {
      read.swing = opening.has_leaf() ? opening.leaf().swing() : v1::DOOR_SWING_NONE;
      read.hinge_at_start = opening.leaf().hinge() != v1::HINGE_SIDE_END;
      const double angle = opening.leaf().swing_angle_rad();
      read.swing_angle_rad = angle > 0 && angle <= std::numbers::pi ? angle : std::numbers::pi / 2;
    }
    read.id = opening.id();
    read.name = opening.description();
    plan.openings.push_back(read);
  }
  for (int i = 0; i < room.sockets_size(); ++i) {
    const int wall = WallNamed(room, room.sockets(i).wall());
    if (wall < 0) return InvalidArgument("room.sockets[{}].wall: there is no wall \"{}\"", i, room.sockets(i).wall());
    if (!AllFinite({room.sockets(i).offset_m()}))
      return InvalidArgument("room.sockets[{}].offset_m: must be finite", i);
    plan.sockets.push_back({wall, room.sockets(i).offset_m()});
  }
  return absl::OkStatus();
}

void ReadStyle(const v1::LayoutGraph& graph, Plan& plan) {
  const v1::StyleSheet& style = graph.style_sheet();
  plan.style_name = style.name();
  plan.style_summary = style.summary();
  for (const v1::Colour& colour : style.palette()) plan.palette.emplace_back(colour.name(), FromProto(colour));
  for (const v1::SurfaceStyle& surface : style.surfaces()) {
    if (surface.surface() == "floor") plan.floor_material = surface.material();
    if (surface.surface() == "walls") plan.wall_material = surface.material();
  }
  const ShellMaterials shell = ShellMaterialsOf(graph);
  plan.floor_look = shell.floor;
  plan.floor_tint = TintForPrint(FromLinear(shell.floor.colour));
  plan.wall_tint = SoftenForPrint(FromLinear(shell.wall.colour));
}

absl::Status ReadZones(const v1::SolvedLayout& layout, Plan& plan) {
  const auto& zones = layout.graph().zone_plan().zones();
  for (int i = 0; i < zones.size(); ++i) {
    // Hues a golden angle apart, so that neighbours in the list never look alike.
    PlanZone zone{zones[i].name().empty() ? zones[i].id() : zones[i].name(), ZoneTint(i), {}};
    for (int r = 0; r < layout.zone_regions_size(); ++r) {
      const v1::ZoneRegion& region = layout.zone_regions(r);
      if (region.zone_id() != zones[i].id()) continue;
      for (const v1::Polygon& part : region.parts()) {
        std::vector<Point> vertices;
        for (const v1::Point2& vertex : part.vertices()) {
          if (!AllFinite({vertex.x_m(), vertex.y_m()}))
            return InvalidArgument("zone_regions[{}].parts: must be finite", r);
          vertices.push_back({vertex.x_m(), vertex.y_m()});
        }
        if (vertices.size() >= 3) zone.parts.push_back(std::move(vertices));
      }
    }
    plan.zones.push_back(std::move(zone));
  }
  return absl::OkStatus();
}

// Objects of one name, size, zone and kind share a legend line.
void CountKey(const v1::Object& object, int zone, Plan& plan, PlanObject& read) {
  const auto same = [&](const PlanKey& key) {
    return key.name == object.name() && key.zone == zone && key.kind == object.kind() &&
           key.walk_over == object.walk_over() && key.width_m == object.width_m() && key.depth_m == object.depth_m();
  };
  const auto at = std::ranges::find_if(plan.keys, same);
  read.key = static_cast<int>(at - plan.keys.begin());
  if (at == plan.keys.end()) {
    plan.keys.push_back(
        {object.name(), zone, object.kind(), object.walk_over(), object.width_m(), object.depth_m(), 0});
  }
  ++plan.keys[read.key].count;
}

int Layer(const PlanObject& object) {
  if (object.walk_over) return 0;
  return object.kind == v1::OBJECT_KIND_SURFACE   ? 2
         : object.kind == v1::OBJECT_KIND_WALL    ? 3
         : object.kind == v1::OBJECT_KIND_CEILING ? 4
                                                  : 1;
}

// Rugs first, largest below; then the floor from low to high; then what stands on it, hangs on walls, hangs above.
bool DrawnBefore(const PlanObject& a, const PlanObject& b) {
  if (Layer(a) != Layer(b)) return Layer(a) < Layer(b);
  if (Layer(a) == 0) return a.width_m * a.depth_m > b.width_m * b.depth_m;
  return a.level_m < b.level_m;
}

// Legend order: by zone, whole-room lines last, otherwise as listed.
void SortKeys(Plan& plan) {
  std::vector<int> order(plan.keys.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto rank = [&plan](int key) {
    return plan.keys[key].zone < 0 ? static_cast<int>(plan.zones.size()) : plan.keys[key].zone;
  };
  std::ranges::stable_sort(order, [&rank](int a, int b) { return rank(a) < rank(b); });
  std::vector<PlanKey> sorted;
  std::vector<int> place(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = static_cast<int>(i);
    sorted.push_back(plan.keys[order[i]]);
  }
  plan.keys = std::move(sorted);
  for (PlanObject& object : plan.objects) object.key = place[object.key];
}

absl::Status ReadObjects(const v1::SolvedLayout& layout, Plan& plan) {
  const v1::LayoutGraph& graph = layout.graph();
  std::map<std::string, const v1::Placement*> placements;
  for (const v1::Placement& placement : layout.placements()) placements[placement.object_id()] = &placement;
  std::map<std::string, const v1::ObjectStyle*> styles;
  for (const v1::ObjectStyle& style : graph.style_sheet().objects()) styles[style.subject_id()] = &style;
  for (int i = 0; i < graph.object_list().objects_size(); ++i) {
    const v1::Object& object = graph.object_list().objects(i);
    const auto at = placements.find(object.id());
    if (at == placements.end()) {
      if (!object.spare()) plan.unplaced.push_back(object.name());
      continue;
    }
    const v1::Placement& pose = *at->second;
    if (!AllFinite({object.width_m(), object.depth_m(), object.height_m(), pose.x_m(), pose.y_m(), pose.z_m(),
                    pose.theta_rad()}) ||
        object.width_m() <= 0 || object.depth_m() <= 0) {
      return InvalidArgument(
          "object_list.objects[{}] \"{}\": pose and sizes must be finite, width_m and depth_m above 0", i, object.id());
    }
    // Lying, hanging and standing on something is what the layer of tertiaries shows, whatever their role.
    const bool tertiary = object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over();
    if (tertiary ? !plan.layers.tertiary : !plan.layers.floor_pieces) continue;
    PlanObject read;
    read.id = object.id();
    read.name = object.name();
    read.shown_as = &ClassNamed(ClassOf(object));
    const auto style = styles.find(object.id());
    const Palette palette =
        PaletteOf(read.shown_as->materials(), object, style != styles.end() ? style->second : nullptr);
    read.ink.fill = SoftenForPrint(FromLinear(palette.colour));
    read.ink.line = LineColourFor(read.ink.fill);
    read.ink.hard = SoftenForPrint(FromLinear(palette.hard.colour));
    read.ink.soft = SoftenForPrint(FromLinear(palette.soft.colour));
    read.kind = object.kind();
    read.walk_over = object.walk_over();
    read.centre_m = {pose.x_m(), pose.y_m()};
    read.theta_rad = pose.theta_rad();
    read.width_m = object.width_m();
    read.depth_m = object.depth_m();
    read.low_m = pose.z_m();
    read.top_m = pose.z_m() + object.height_m();
    const double level_m = read.shown_as->plan_level_m();
    read.level_m = level_m > 0 && object.kind() == v1::OBJECT_KIND_FLOOR ? level_m : read.top_m;
    int zone = -1;
    for (int z = 0; z < graph.zone_plan().zones_size(); ++z) {
      if (!object.zone_id().empty() && graph.zone_plan().zones(z).id() == object.zone_id()) zone = z;
    }
    CountKey(object, zone, plan, read);
    plan.objects.push_back(std::move(read));
  }
  for (const v1::Omission& omission : graph.object_list().omissions()) {
    if (omission.requested()) plan.unplaced.push_back(omission.name());
  }
  SortKeys(plan);
  std::ranges::stable_sort(plan.objects, DrawnBefore);
  return absl::OkStatus();
}

}  // namespace

std::vector<Point> PlanObject::Corners() const {
  const Point u{std::cos(theta_rad), std::sin(theta_rad)}, v{-u.y, u.x};
  const Point half_u = u * (width_m / 2), half_v = v * (depth_m / 2);
  return {centre_m - half_u - half_v, centre_m + half_u - half_v, centre_m + half_u + half_v,
          centre_m - half_u + half_v};
}

absl::StatusOr<Plan> ReadPlan(const v1::SolvedLayout& layout, const PlanLayers& layers) {
  Plan plan;
  plan.layers = layers;
  const v1::Room& room = layout.graph().room();
  plan.room_type = room.room_type();
  plan.title = room.title().empty() ? (room.room_type().empty() ? "Room" : room.room_type()) : room.title();
  plan.height_m = std::isfinite(room.height_m()) ? room.height_m() : 0;
  ReadStyle(layout.graph(), plan);
  RETURN_IF_ERROR(ReadFloor(room, plan));
  RETURN_IF_ERROR(ReadOpenings(room, plan));
  RETURN_IF_ERROR(ReadZones(layout, plan));
  RETURN_IF_ERROR(ReadObjects(layout, plan));
  if (layers.constraints) ReadEdges(layout, plan);
  if (layers.circulation) RETURN_IF_ERROR(ReadRoutes(layout, plan));
  return plan;
}

}  // namespace flair::renderer
