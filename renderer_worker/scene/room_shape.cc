// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/room_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

bool Plausible(double value) { return std::isfinite(value) && std::abs(value) <= 1e4; }

absl::Status ReadFloor(const v1::Room& room, RoomShape& shape) {
  const int count = room.floor().vertices_size();
  if (count < 3) return InvalidArgument("graph.room.floor.vertices: {} vertices; at least 3", count);
  double twice_area = 0;
  for (int i = 0; i < count; ++i) {
    const v1::Point2 &p = room.floor().vertices(i), &q = room.floor().vertices((i + 1) % count);
    if (!Plausible(p.x_m()) || !Plausible(p.y_m())) {
      return InvalidArgument("graph.room.floor.vertices[{}]: ({}, {}) is not a point of a room", i, p.x_m(), p.y_m());
    }
    twice_area += p.x_m() * q.y_m() - q.x_m() * p.y_m();
    shape.floor.push_back({static_cast<float>(p.x_m()), static_cast<float>(p.y_m())});
  }
  if (!(twice_area > 2e-3))
    return InvalidArgument("graph.room.floor.vertices: must run counter-clockwise around an area");
  return absl::OkStatus();
}

// How far beyond a corner the outer face of a wall runs: t tan(half the turn), long spikes cut short.
float MitreOf(Vec3 along_before, Vec3 along_after, float thickness) {
  const float turn = along_before.x * along_after.y - along_before.y * along_after.x;
  const float cosine = Dot(along_before, along_after);
  return std::clamp(turn / std::max(1 + cosine, 0.2F), -3.0F, 3.0F) * thickness;
}

absl::Status ReadWalls(const v1::Room& room, RoomShape& shape) {
  const size_t count = shape.floor.size();
  for (size_t i = 0; i < count; ++i) {
    const Vec2 a = shape.floor[i], b = shape.floor[(i + 1) % count];
    ShapedWall wall;
    wall.name = static_cast<int>(i) < room.walls_size() ? room.walls(static_cast<int>(i)).name()
                                                        : fmt::format("wall_{}", i + 1);
    wall.length_m = std::hypot(b.x - a.x, b.y - a.y);
    if (!(wall.length_m > 1e-5F)) {
      return InvalidArgument("graph.room.floor.vertices[{}]: repeats the vertex before it", (i + 1) % count);
    }
    const Vec3 along{(b.x - a.x) / wall.length_m, (b.y - a.y) / wall.length_m, 0};
    wall.axes = {{a.x, a.y, 0}, along, {along.y, -along.x, 0}, {0, 0, 1}};
    shape.walls.push_back(std::move(wall));
  }
  for (size_t i = 0; i < count; ++i) {
    ShapedWall& wall = shape.walls[i];
    const Vec3 along = wall.axes.along;
    wall.outer_start = -MitreOf(shape.walls[(i + count - 1) % count].axes.along, along, shape.wall_thickness_m);
    wall.outer_end = wall.length_m + MitreOf(along, shape.walls[(i + 1) % count].axes.along, shape.wall_thickness_m);
  }
  return absl::OkStatus();
}

absl::Status ReadOpenings(const v1::Room& room, RoomShape& shape) {
  for (int i = 0; i < room.openings_size(); ++i) {
    const v1::Opening& opening = room.openings(i);
    const auto wall = std::ranges::find_if(shape.walls, [&](const ShapedWall& w) { return w.name == opening.wall(); });
    if (wall == shape.walls.end()) {
      return InvalidArgument("graph.room.openings[{}].wall: there is no wall \"{}\"", i, opening.wall());
    }
    for (double value : {opening.offset_m(), opening.width_m(), opening.sill_height_m(), opening.head_height_m()}) {
      if (!Plausible(value)) return InvalidArgument("graph.room.openings[{}]: sizes must be finite", i);
    }
    ShapedOpening shaped;
    shaped.opening = &opening;
    shaped.u0 = std::clamp(static_cast<float>(opening.offset_m()), 0.0F, wall->length_m);
    shaped.u1 = std::clamp(static_cast<float>(opening.offset_m() + opening.width_m()), shaped.u0, wall->length_m);
    shaped.w0 = opening.kind() == v1::OPENING_KIND_DOOR
                    ? 0
                    : std::clamp(static_cast<float>(opening.sill_height_m()), 0.0F, shape.height_m);
    shaped.w1 = std::clamp(static_cast<float>(opening.head_height_m()), shaped.w0, shape.height_m);
    if (shaped.u1 - shaped.u0 > 0.02F && shaped.w1 - shaped.w0 > 0.02F) wall->openings.push_back(shaped);
  }
  return absl::OkStatus();
}

// Points all over the floor, a little off the walls.
std::vector<Vec3> FloorSamples(const RoomShape& shape) {
  constexpr int kPerSide = 24;
  const auto [low, high] = Bounds2(shape.floor);
  std::vector<Vec3> samples;
  for (int i = 0; i < kPerSide; ++i) {
    for (int k = 0; k < kPerSide; ++k) {
      const float x = low.x + (high.x - low.x) * (static_cast<float>(i) + 0.5F) / kPerSide;
      const float y = low.y + (high.y - low.y) * (static_cast<float>(k) + 0.5F) / kPerSide;
      if (Inside(shape, x, y)) samples.push_back({x, y, 0});
    }
  }
  return samples;
}

// Whether the wall, up to the ceiling, stands between the eye and the point.
bool Hides(const ShapedWall& wall, float height_m, Vec3 eye, Vec3 point) {
  const float from = Dot(eye - wall.axes.origin, wall.axes.outward),
              to = Dot(point - wall.axes.origin, wall.axes.outward);
  if ((from > 0) == (to > 0) || std::abs(from - to) < 1e-6F) return false;
  const Vec3 at = eye + (point - eye) * (from / (from - to));
  const float along = Dot(at - wall.axes.origin, wall.axes.along);
  return along > 0 && along < wall.length_m && at.z < height_m;
}

// Newell's normal: twice the area long, whatever corners fall together.
Vec3 AreaNormal(std::span<const Vec3> corners) {
  Vec3 sum;
  for (size_t i = 0; i < corners.size(); ++i) sum = sum + Cross(corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

}  // namespace

absl::StatusOr<RoomShape> ShapeOf(const v1::Room& room) {
  RoomShape shape;
  const double height = room.height_m() == 0 ? 3 : room.height_m();
  if (!Plausible(height) || height < 0.5) {
    return InvalidArgument("graph.room.height_m: {} is not a height of a room", room.height_m());
  }
  shape.height_m = static_cast<float>(height);
  RETURN_IF_ERROR(ReadFloor(room, shape));
  RETURN_IF_ERROR(ReadWalls(room, shape));
  RETURN_IF_ERROR(ReadOpenings(room, shape));
  return shape;
}

bool Inside(const RoomShape& shape, float x, float y) {
  bool inside = false;
  for (size_t i = 0, k = shape.floor.size() - 1; i < shape.floor.size(); k = i++) {
    const Vec2 a = shape.floor[i], b = shape.floor[k];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

float WayIn(const RoomShape& shape, Vec3 eye, Vec3 direction) {
  if (Inside(shape, eye.x, eye.y)) return 0;
  float first = std::numeric_limits<float>::infinity();
  for (const ShapedWall& wall : shape.walls) {
    const float rate = Dot(direction, wall.axes.outward);
    if (rate > -1e-6F) continue;
    const float distance = Dot(wall.axes.origin - eye, wall.axes.outward) / rate;
    const Vec3 at = eye + direction * distance;
    const float along = Dot(at - wall.axes.origin, wall.axes.along);
    const bool through = along >= 0 && along <= wall.length_m && at.z >= 0 && at.z <= shape.height_m;
    if (distance > 0 && through) first = std::min(first, distance);
  }
  return first;
}

CutAway CutAwayFor(const RoomShape& shape, Vec3 eye) {
  CutAway cut;
  cut.ceiling = eye.z >= shape.height_m;
  cut.walls.assign(shape.walls.size(), WallCut::kWhole);
  if (!cut.ceiling && Inside(shape, eye.x, eye.y)) return cut;
  const std::vector<Vec3> samples = cut.ceiling ? FloorSamples(shape) : std::vector<Vec3>();
  for (size_t i = 0; i < shape.walls.size(); ++i) {
    const ShapedWall& wall = shape.walls[i];
    if (!cut.ceiling) {
      if (Dot(eye - wall.axes.origin, wall.axes.outward) > 0) cut.walls[i] = WallCut::kGone;
      continue;
    }
    const auto hidden = std::ranges::count_if(samples, [&](Vec3 p) { return Hides(wall, shape.height_m, eye, p); });
    if (hidden * 200 > static_cast<int64_t>(samples.size())) cut.walls[i] = WallCut::kStub;
  }
  return cut;
}

MeshPart& MeshBuilder::PartOf(const Material& material) {
  for (MeshPart& part : mesh_.parts) {
    if (part.material == material) return part;
  }
  mesh_.parts.emplace_back().material = material;
  return mesh_.parts.back();
}

void MeshBuilder::Polygon(const Material& material, std::span<const Vec3> corners, Vec3 u_axis) {
  const Vec3 area = AreaNormal(corners);
  if (corners.size() < 3 || !(Length(area) > 1e-9F)) return;
  const Vec3 normal = Normalized(area), v_axis = Cross(normal, u_axis);
  MeshPart& part = PartOf(material);
  const uint32_t first = static_cast<uint32_t>(part.positions.size());
  for (const Vec3& corner : corners) {
    part.positions.push_back(corner);
    part.normals.push_back(normal);
    part.uvs.push_back({Dot(corner, u_axis), Dot(corner, v_axis)});
  }
  for (uint32_t i = 2; i < corners.size(); ++i)
    part.indices.insert(part.indices.end(), {first, first + i - 1, first + i});
}

void MeshBuilder::Quad(const Material& material, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 corners[] = {a, b, c, d};
  const Vec3 first = b - a, second = d - a;
  if (!(Length(first) > 1e-6F) || !(Length(second) > 1e-6F)) return;
  Polygon(material, corners, Normalized(first));
}

void MeshBuilder::Box(const Material& material, const Axes& axes, Vec3 low, Vec3 high) {
  const auto at = [&](int u, int v, int w) {
    return axes.At(u == 0 ? low.x : high.x, v == 0 ? low.y : high.y, w == 0 ? low.z : high.z);
  };
  // Seen from outside each face runs counter-clockwise when (along, outward, up) is right-handed, clockwise otherwise.
  const bool right_handed = Dot(Cross(axes.along, axes.outward), axes.up) > 0;
  const int faces[6][4][3] = {
      {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}},
      {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}},
      {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}};
  for (const auto& face : faces) {
    Vec3 p[4];
    for (int i = 0; i < 4; ++i) p[i] = at(face[i][0], face[i][1], face[i][2]);
    if (right_handed) {
      Quad(material, p[0], p[1], p[2], p[3]);
    } else {
      Quad(material, p[3], p[2], p[1], p[0]);
    }
  }
}

void MeshBuilder::Bar(const Material& material, Vec3 a, Vec3 b, float radius, int sides) {
  const Vec3 axis = Normalized(b - a);
  const Vec3 side = Normalized(Cross(axis, std::abs(axis.z) < 0.9F ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  const Vec3 other = Cross(axis, side);
  std::vector<Vec3> low, high;
  for (int i = 0; i < sides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
    const Vec3 out = (side * std::cos(angle) + other * std::sin(angle)) * radius;
    low.push_back(a + out);
    high.push_back(b + out);
  }
  for (int i = 0; i < sides; ++i) {
    const int k = (i + 1) % sides;
    Quad(material, low[i], low[k], high[k], high[i]);
  }
  Polygon(material, high, side);
  std::ranges::reverse(low);
  Polygon(material, low, side);
}

void MeshBuilder::Append(const Mesh& mesh) {
  for (const MeshPart& from : mesh.parts) {
    MeshPart& to = PartOf(from.material);
    const uint32_t first = static_cast<uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
    for (uint32_t index : from.indices) to.indices.push_back(first + index);
  }
}

}  // namespace flair::renderer
