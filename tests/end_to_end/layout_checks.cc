// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/layout_checks.h"

#include <algorithm>
#include <cmath>

#include "evaluation/metrics/layout_metrics.h"
#include "fmt/format.h"
#include "room/conversion/conversion.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair::testing {
namespace {

// Share of the room's area that counts as nothing.
constexpr double kNothing = 1e-6;
constexpr double kHeadGap_m = 0.05;
constexpr double kFacing_rad = 0.35;

using Faults = std::vector<std::string>;

bool HasWord(const Object& object, const std::string& word) {
  const std::string text = " " + object.name + " ";
  return text.find(" " + word + " ") != std::string::npos || text.find(" " + word + "s ") != std::string::npos;
}

void CheckSizes(const Scene& scene, Faults& faults) {
  for (const Object& object : scene.objects) {
    const double longest = std::max(object.footprint.width_m, object.footprint.depth_m);
    if (longest < 0.02 || longest > 8 || object.height_m > 3.5) {
      faults.push_back(fmt::format("{} is {} x {} x {} m", object.id, object.footprint.width_m,
                                   object.footprint.depth_m, object.height_m));
    }
    if (object.kind == ObjectKind::kFloor && object.height_m > scene.room.height_m) {
      faults.push_back(fmt::format("{} is higher than the room", object.id));
    }
  }
}

void CheckAreas(const evaluation::LayoutView& view, Faults& faults) {
  const double room_m2 = Area(view.scene.room.floor);
  for (const evaluation::Outside& outside : evaluation::FindOutside(view)) {
    if (outside.area_m2 > kNothing * room_m2) {
      faults.push_back(fmt::format("{} is {:.4g} m2 outside the room", outside.object, outside.area_m2));
    }
  }
  for (const evaluation::Overlap& overlap : evaluation::FindOverlaps(view)) {
    if (overlap.area_m2 > kNothing * room_m2) {
      faults.push_back(fmt::format("{} is {:.4g} m2 in {}", overlap.first, overlap.area_m2, overlap.second));
    }
  }
}

// A strip just inside every door must stay free, whichever way its leaf opens.
void CheckLandings(const evaluation::LayoutView& view, Faults& faults) {
  for (const Opening& door : view.scene.room.openings) {
    if (door.kind != OpeningKind::kDoor) continue;
    const Polygon landing = PassageArea(view.scene.room, door, 0.3, -0.05);
    for (size_t i = 0; i < view.scene.objects.size(); ++i) {
      if (!IsSolid(view.scene.objects[i])) continue;
      const auto corners = Corners(view.scene.objects[i].footprint, view.layout[i]);
      if (ConvexIntersectionArea(corners, landing.vertices) > 1e-4) {
        faults.push_back(fmt::format("{} stands before {}", view.scene.objects[i].id, door.id));
      }
    }
  }
}

void CheckBeds(const evaluation::LayoutView& view, Faults& faults) {
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    const Object& object = view.scene.objects[i];
    const bool bed = (HasWord(object, "bed") || HasWord(object, "crib") || object.name.ends_with(" bed")) &&
                     IsSolid(object) && object.footprint.area_m2() > 0.5;
    if (!bed || HasWord(object, "bench") || HasWord(object, "table")) continue;
    const SideEdge<double> head = EdgeOf(object.footprint, view.layout[i], Side::kBack);
    const bool at_wall = std::ranges::any_of(view.scene.room.walls, [&](const Wall& wall) {
      return std::abs(wall.Height(head.first)) < kHeadGap_m && std::abs(wall.Height(head.second)) < kHeadGap_m;
    });
    if (!at_wall) faults.push_back(fmt::format("{} has its head in the room", object.id));
  }
}

// The chair's way to the table's outline, and whether it looks along it.
bool LooksAt(const evaluation::LayoutView& view, size_t chair, size_t table) {
  const Frame<double> frame = FrameOf(view.layout[table]);
  const Footprint& top = view.scene.objects[table].footprint;
  const Vec2<double> local = frame.ToObject(Center(view.layout[chair]));
  const Vec2<double> nearest = frame.ToRoom(std::clamp(local.x, -top.width_m / 2, top.width_m / 2),
                                            std::clamp(local.y, -top.depth_m / 2, top.depth_m / 2));
  const Vec2<double> way = nearest - Center(view.layout[chair]);
  return Norm(way) < 1.2 && AngleBetween(view.layout[chair].theta_rad, HeadingOf(way)) < kFacing_rad;
}

void CheckChairs(const evaluation::LayoutView& view, Faults& faults) {
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    const Object& chair = view.scene.objects[i];
    if (!IsSolid(chair) || !chair.name.ends_with("chair") || chair.name.ends_with("armchair")) continue;
    if (HasWord(chair, "reading") || HasWord(chair, "accent") || HasWord(chair, "easy") || HasWord(chair, "rocking") ||
        HasWord(chair, "nursing") || HasWord(chair, "lounge")) {
      continue;
    }
    bool has_table = false, faces_one = false;
    for (size_t k = 0; k < view.scene.objects.size(); ++k) {
      const Object& table = view.scene.objects[k];
      if (k == i || table.zone != chair.zone || !IsSolid(table)) continue;
      if (!HasWord(table, "table") && !HasWord(table, "desk")) continue;
      if (HasWord(table, "bedside") || HasWord(table, "side") || HasWord(table, "coffee")) continue;
      has_table = true;
      faces_one = faces_one || LooksAt(view, i, k);
    }
    if (has_table && !faces_one) faults.push_back(fmt::format("{} faces no table", chair.id));
  }
}

}  // namespace

std::vector<std::string> FindFaults(const v1::SolvedLayout& message) {
  const absl::StatusOr<Scene> scene = SceneFromProto(message.graph());
  if (!scene.ok()) return {std::string(scene.status().message())};
  const absl::StatusOr<PartialLayout> partial = PosesFromPlacements(*scene, message.placements());
  if (!partial.ok()) return {std::string(partial.status().message())};
  Faults faults;
  for (size_t i = 0; i < scene->objects.size(); ++i) {
    // What nobody asked for may be left out.
    if (!partial->placed[i] && !message.graph().object_list().objects(static_cast<int>(i)).spare()) faults.push_back(scene->objects[i].id + " is not placed");
  }
  const evaluation::LayoutView view{*scene, partial->layout, partial->placed};
  CheckSizes(*scene, faults);
  CheckAreas(view, faults);
  CheckLandings(view, faults);
  CheckBeds(view, faults);
  CheckChairs(view, faults);
  return faults;
}

}  // namespace flair::testing
