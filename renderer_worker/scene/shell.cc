// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/shell.h"

#include <algorithm>

#include "room/geometry/polygon.h"

namespace flair::renderer {
namespace {

constexpr float kSkirtingHeight_m = 0.08F;
constexpr float kSkirtingDepth_m = 0.014F;

struct Span {
  float low, high;
};

// Parts of [0, top] that no opening over u covers, from below.
std::vector<Span> SolidAt(const ShapedWall& wall, float u, float top) {
  std::vector<Span> solid = {{0, top}};
  for (const ShapedOpening& hole : wall.openings) {
    if (u <= hole.u0 || u >= hole.u1) continue;
    std::vector<Span> rest;
    for (const Span& span : solid) {
      if (span.low < std::min(span.high, hole.w0)) rest.push_back({span.low, std::min(span.high, hole.w0)});
      if (std::max(span.low, hole.w1) < span.high) rest.push_back({std::max(span.low, hole.w1), span.high});
    }
    solid = std::move(rest);
  }
  return solid;
}

std::vector<float> Breakpoints(const ShapedWall& wall) {
  std::vector<float> points = {0, wall.length_m};
  for (const ShapedOpening& hole : wall.openings) points.insert(points.end(), {hole.u0, hole.u1});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Heights up to `top` at which some opening begins or ends. Faces end at all of them: where a corner of one lay on the
// edge of another, rasterizers would let light through between the two.
std::vector<float> Levels(const ShapedWall& wall, float top) {
  std::vector<float> levels = {0, top};
  for (const ShapedOpening& hole : wall.openings) {
    for (float level : {hole.w0, hole.w1}) {
      if (level > 0 && level < top) levels.push_back(level);
    }
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

// The spans, cut at the levels within them.
std::vector<Span> CutAt(const std::vector<float>& levels, const std::vector<Span>& spans) {
  std::vector<Span> pieces;
  for (const Span& span : spans) {
    float low = span.low;
    for (float level : levels) {
      if (level <= low || level >= span.high) continue;
      pieces.push_back({low, level});
      low = level;
    }
    pieces.push_back({low, span.high});
  }
  return pieces;
}

// The floor's triangles at height z, facing up or down.
void AddFloor(const RoomShape& shape, float z, bool up, const Material& material, MeshBuilder& builder) {
  Polygon polygon;
  for (const Vec2& p : shape.floor) polygon.vertices.push_back({p.x, p.y});
  for (const Polygon& triangle : Triangulate(polygon)) {
    std::vector<Vec3> corners;
    for (const auto& p : triangle.vertices) corners.push_back({static_cast<float>(p.x), static_cast<float>(p.y), z});
    if (!up) std::reverse(corners.begin(), corners.end());
    builder.Polygon(material, corners, {1, 0, 0});
  }
}

// Jambs, head and, for windows, the bottom of a hole, as far up as the wall goes.
void AddReveal(const ShapedWall& wall, const ShapedOpening& hole, float thickness, float top, const Material& material,
               const Material& threshold, MeshBuilder& builder) {
  const float head = std::min(hole.w1, top);
  if (head <= hole.w0) return;
  const Axes& a = wall.axes;
  const auto at = [&](float u, float v, float w) { return a.At(u, v, w); };
  const float t = thickness;
  builder.Quad(material, at(hole.u0, 0, hole.w0), at(hole.u0, 0, head), at(hole.u0, t, head), at(hole.u0, t, hole.w0));
  builder.Quad(material, at(hole.u1, t, hole.w0), at(hole.u1, t, head), at(hole.u1, 0, head), at(hole.u1, 0, hole.w0));
  if (hole.w1 <= top) {
    builder.Quad(material, at(hole.u0, 0, head), at(hole.u1, 0, head), at(hole.u1, t, head), at(hole.u0, t, head));
  }
  builder.Quad(hole.door() ? threshold : material, at(hole.u0, 0, hole.w0), at(hole.u0, t, hole.w0),
               at(hole.u1, t, hole.w0), at(hole.u1, 0, hole.w0));
}

Mesh SkirtingOf(const ShapedWall& wall, const ShellMaterials& materials) {
  MeshBuilder builder;
  const std::vector<float> points = Breakpoints(wall);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const std::vector<Span> solid = SolidAt(wall, (points[i] + points[i + 1]) / 2, kSkirtingHeight_m);
    if (solid.empty() || solid[0].low > 0) continue;
    builder.Box(materials.trim, wall.axes, {points[i], -kSkirtingDepth_m, 0}, {points[i + 1], 0, solid[0].high});
  }
  return builder.Take();
}

void AddOpenings(const RoomShape& shape, int index, const v1::StyleSheet& style, const ShellMaterials& materials,
                 std::vector<ShellPart>& shell) {
  const ShapedWall& wall = shape.walls[index];
  for (const ShapedOpening& opening : wall.openings) {
    ShellPart part;
    part.kind = opening.door() ? ShellPart::Kind::kDoor : ShellPart::Kind::kWindow;
    part.id = opening.opening->id();
    part.wall = index;
    const Material body = OpeningMaterialOf(style, part.id, materials.trim);
    part.mesh = opening.door() ? DoorMesh(shape, wall, opening, materials, body)
                               : WindowMesh(shape, wall, opening, materials, body);
    if (!part.mesh.parts.empty()) shell.push_back(std::move(part));
  }
}

}  // namespace

Mesh WallBody(const RoomShape& shape, const ShapedWall& wall, float top_m, const ShellMaterials& materials) {
  MeshBuilder builder;
  const Axes& a = wall.axes;
  const float t = shape.wall_thickness_m, bottom = -kSlabThickness_m;
  const std::vector<float> points = Breakpoints(wall), levels = Levels(wall, top_m);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const float u0 = points[i], u1 = points[i + 1];
    const float o0 = std::max(u0, wall.outer_start), o1 = std::min(u1, wall.outer_end);
    const std::vector<Span> solid = SolidAt(wall, (u0 + u1) / 2, top_m);
    for (const Span& span : CutAt(levels, solid)) {
      builder.Quad(materials.wall, a.At(u1, 0, span.low), a.At(u0, 0, span.low), a.At(u0, 0, span.high),
                   a.At(u1, 0, span.high));
      const float low = span.low == 0 ? bottom : span.low;
      if (o0 < o1) {
        builder.Quad(materials.outside, a.At(o0, t, low), a.At(o1, t, low), a.At(o1, t, span.high),
                     a.At(o0, t, span.high));
      }
      if (span.high == top_m) {
        builder.Quad(materials.section, a.At(u0, 0, top_m), a.At(o0, t, top_m), a.At(o1, t, top_m), a.At(u1, 0, top_m));
      }
    }
    if (o0 < o1 && (solid.empty() || solid[0].low > 0)) {  // the slab below a door
      builder.Quad(materials.outside, a.At(o0, t, bottom), a.At(o1, t, bottom), a.At(o1, t, 0), a.At(o0, t, 0));
    }
  }
  for (const ShapedOpening& hole : wall.openings) {
    AddReveal(wall, hole, t, top_m, materials.trim, materials.floor, builder);
  }
  const float end = wall.length_m;
  // Where mitres make the outer face longer than the inner one.
  for (const Span corner : {Span{wall.outer_start, 0}, Span{end, wall.outer_end}}) {
    if (corner.low >= corner.high) continue;
    builder.Quad(materials.outside, a.At(corner.low, t, bottom), a.At(corner.high, t, bottom),
                 a.At(corner.high, t, top_m), a.At(corner.low, t, top_m));
    const float inner = corner.low < 0 ? 0 : end;
    const Vec3 top[] = {a.At(inner, 0, top_m), a.At(corner.low, t, top_m), a.At(corner.high, t, top_m)};
    builder.Polygon(materials.section, top, a.along);
  }
  // Mitred ends, seen where the neighbour is cut lower.
  builder.Quad(materials.section, a.At(0, 0, bottom), a.At(wall.outer_start, t, bottom),
               a.At(wall.outer_start, t, top_m), a.At(0, 0, top_m));
  builder.Quad(materials.section, a.At(wall.outer_end, t, bottom), a.At(end, 0, bottom), a.At(end, 0, top_m),
               a.At(wall.outer_end, t, top_m));
  return builder.Take();
}

std::vector<ShellPart> BuildShell(const RoomShape& shape, const v1::StyleSheet& style) {
  const ShellMaterials materials = ShellMaterialsOf(style);
  std::vector<ShellPart> shell;
  MeshBuilder floor, ceiling;
  AddFloor(shape, 0, true, materials.floor, floor);
  AddFloor(shape, shape.height_m, false, materials.ceiling, ceiling);
  shell.push_back({ShellPart::Kind::kFloor, "floor", -1, floor.Take(), {}});
  shell.push_back({ShellPart::Kind::kCeiling, "ceiling", -1, ceiling.Take(), {}});
  for (int i = 0; i < static_cast<int>(shape.walls.size()); ++i) {
    const ShapedWall& wall = shape.walls[i];
    shell.push_back({ShellPart::Kind::kWall, wall.name, i, WallBody(shape, wall, shape.height_m, materials),
                     WallBody(shape, wall, kStubHeight_m, materials)});
    Mesh skirting = SkirtingOf(wall, materials);
    if (!skirting.parts.empty()) {
      shell.push_back({ShellPart::Kind::kSkirting, wall.name + "_skirting", i, std::move(skirting), {}});
    }
    AddOpenings(shape, i, style, materials, shell);
  }
  return shell;
}

}  // namespace flair::renderer
