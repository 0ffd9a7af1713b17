// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/scene/room_shape.h"
#include "room/geometry/polygon.h"

namespace flair::renderer {
namespace {

constexpr float kLeafThickness_m = 0.042F;
constexpr float kAjar_rad = 0.42F;
constexpr float kArchitrave_m = 0.06F;

// A flat frame of bars round [u0, u1] x [w0, w1], `bar` wide, from v0 to v1; without its lower bar for doors.
void AddFrame(const Material& material, const Axes& axes, Vec3 low, Vec3 high, float bar, bool bottom,
              MeshBuilder& builder) {
  const float lift = bottom ? bar : 0;
  builder.Box(material, axes, {low.x, low.y, low.z + lift}, {low.x + bar, high.y, high.z - bar});
  builder.Box(material, axes, {high.x - bar, low.y, low.z + lift}, {high.x, high.y, high.z - bar});
  builder.Box(material, axes, {low.x, low.y, high.z - bar}, {high.x, high.y, high.z});
  if (bottom) builder.Box(material, axes, low, {high.x, high.y, low.z + bar});
}

// A leaf in its own axes: u from the hinge to the strike, v through the leaf, w up. Two raised panels and a handle on
// each side.
void AddLeaf(const Axes& axes, float width, float height, const Material& body, const ShellMaterials& materials,
             MeshBuilder& builder) {
  const float half = kLeafThickness_m / 2;
  builder.Box(body, axes, {0, -half, 0.008F}, {width, half, height});
  const float rim = std::min(0.11F, width / 6), middle = height * 0.42F;
  Material panel = body;
  panel.name += " panel";
  panel.colour = panel.colour * 0.93F;
  for (const auto& [low, high] : {std::pair{rim * 1.6F, middle - rim / 2}, {middle + rim / 2, height - rim}}) {
    if (high - low < 0.1F || width < 0.35F) continue;
    builder.Box(panel, axes, {rim, -half - 0.006F, low}, {width - rim, half + 0.006F, high});
  }
  const float u = width - std::min(0.06F, width / 8), w = std::min(1.02F, height * 0.5F);
  for (const float side : {-1.0F, 1.0F}) {
    const float out = side * (half + 0.05F);
    builder.Bar(materials.metal, axes.At(u, side * half, w), axes.At(u, out, w), 0.011F, 8);
    builder.Bar(materials.metal, axes.At(u + 0.008F, out, w), axes.At(u - 0.12F, out, w), 0.010F, 8);
  }
}

// Where the leaf is: closed against the frame's inner or outer face, or ajar about its hinge.
Axes LeafAxes(const ShapedWall& wall, const ShapedOpening& door, float from, float to, float depth) {
  const v1::DoorLeaf& leaf = door.opening->leaf();
  const bool at_start = leaf.hinge() != v1::HINGE_SIDE_END;
  const bool outward = leaf.swing() == v1::DOOR_SWING_OUTWARD;
  const double most = leaf.swing_angle_rad();
  const float angle = leaf.swing() == v1::DOOR_SWING_SLIDING ? 0
                      : most > 0 && most < kAjar_rad         ? static_cast<float>(most)
                                                             : kAjar_rad;
  const Vec3 closed = wall.axes.along * (at_start ? 1.0F : -1.0F);
  const Vec3 open = outward ? wall.axes.outward : -wall.axes.outward;
  const Vec3 along = closed * std::cos(angle) + open * std::sin(angle);
  const Vec3 through = open * std::cos(angle) - closed * std::sin(angle);
  return {wall.axes.At(at_start ? from : to, depth, 0), along, through, wall.axes.up};
}

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
  std::ranges::sort(points);
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
  std::ranges::sort(levels);
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
    if (!up) std::ranges::reverse(corners);
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

Mesh DoorMesh(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& door,
              const ShellMaterials& materials, const Material& leaf) {
  MeshBuilder builder;
  const float t = shape.wall_thickness_m, lip = 0.012F, bar = 0.03F;
  const v1::DoorSwing swing = door.opening->has_leaf() ? door.opening->leaf().swing() : v1::DOOR_SWING_NONE;
  const Material& trim = materials.trim;
  // Architraves on both faces, a lining between them.
  const float head = std::min(door.w1 + kArchitrave_m, shape.height_m);
  for (const auto& [v0, v1] : {std::pair{-lip, 0.0F}, {t, t + lip}}) {
    AddFrame(trim, wall.axes, {door.u0 - kArchitrave_m, v0, 0}, {door.u1 + kArchitrave_m, v1, head}, kArchitrave_m,
             false, builder);
  }
  if (swing == v1::DOOR_SWING_NONE || swing == v1::DOOR_SWING_UNSPECIFIED) return builder.Take();
  AddFrame(trim, wall.axes, {door.u0, 0, 0}, {door.u1, t, door.w1}, bar, false, builder);
  const float from = door.u0 + bar, to = door.u1 - bar, width = to - from, height = door.w1 - bar - 0.004F;
  if (width < 0.1F || height < 0.3F) return builder.Take();
  if (swing == v1::DOOR_SWING_SLIDING) {
    // On a rail along the inner face, closed.
    const Axes axes = LeafAxes(wall, door, from, to, -kLeafThickness_m / 2 - lip - 0.012F);
    AddLeaf(axes, width, height, leaf, materials, builder);
    builder.Bar(materials.metal, wall.axes.At(door.u0 - 0.05F, -0.05F, head + 0.03F),
                wall.axes.At(door.u1 + 0.05F, -0.05F, head + 0.03F), 0.014F, 8);
    return builder.Take();
  }
  const float depth = swing == v1::DOOR_SWING_OUTWARD ? t - kLeafThickness_m / 2 : kLeafThickness_m / 2;
  // Wide openings have two leaves; the one at the hinge is ajar.
  if (width < 1.3F) {
    AddLeaf(LeafAxes(wall, door, from, to, depth), width, height, leaf, materials, builder);
    return builder.Take();
  }
  v1::Opening other = *door.opening;
  other.mutable_leaf()->set_hinge(door.opening->leaf().hinge() == v1::HINGE_SIDE_END ? v1::HINGE_SIDE_START
                                                                                     : v1::HINGE_SIDE_END);
  other.mutable_leaf()->set_swing_angle_rad(1e-6);
  const ShapedOpening second{&other, door.u0, door.u1, door.w0, door.w1};
  AddLeaf(LeafAxes(wall, door, from, to, depth), width / 2 - 0.002F, height, leaf, materials, builder);
  AddLeaf(LeafAxes(wall, second, from, to, depth), width / 2 - 0.002F, height, leaf, materials, builder);
  return builder.Take();
}

std::optional<Axes> OpenLeafAxes(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& door) {
  const v1::DoorSwing swing = door.opening->has_leaf() ? door.opening->leaf().swing() : v1::DOOR_SWING_NONE;
  if (!door.door() || (swing != v1::DOOR_SWING_INWARD && swing != v1::DOOR_SWING_OUTWARD)) return std::nullopt;
  return LeafAxes(wall, door, door.u0, door.u1, swing == v1::DOOR_SWING_OUTWARD ? shape.wall_thickness_m : 0);
}

Mesh WindowMesh(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& window,
                const ShellMaterials& materials, const Material& frame) {
  MeshBuilder builder;
  const Axes& axes = wall.axes;
  const float t = shape.wall_thickness_m, width = window.u1 - window.u0, height = window.w1 - window.w0;
  const float bar = std::min(0.055F, std::min(width, height) / 5), v0 = 0.3F * t, v1 = 0.65F * t, glass = 0.48F * t;
  AddFrame(frame, axes, {window.u0, v0, window.w0}, {window.u1, v1, window.w1}, bar, true, builder);
  // Casements of 0.9 m at most; a transom where they are tall.
  const int casements = std::clamp(static_cast<int>(std::ceil((width - 0.2F) / 0.9F)), 1, 24);
  const float mullion = 0.045F;
  for (int i = 1; i < casements; ++i) {
    const float u = window.u0 + width * static_cast<float>(i) / static_cast<float>(casements);
    builder.Box(frame, axes, {u - mullion / 2, v0 + 0.01F, window.w0 + bar},
                {u + mullion / 2, v1 - 0.01F, window.w1 - bar});
  }
  if (height > 1.5F) {
    const float w = window.w0 + height * 0.68F;
    for (int i = 0; i < casements; ++i) {
      const float low = window.u0 + width * static_cast<float>(i) / static_cast<float>(casements) + mullion / 2;
      const float high = window.u0 + width * static_cast<float>(i + 1) / static_cast<float>(casements) - mullion / 2;
      builder.Box(frame, axes, {std::max(low, window.u0 + bar), v0 + 0.01F, w - mullion / 2},
                  {std::min(high, window.u1 - bar), v1 - 0.01F, w + mullion / 2});
    }
  }
  const float u0 = window.u0 + bar, u1 = window.u1 - bar, w0 = window.w0 + bar, w1 = window.w1 - bar;
  builder.Quad(materials.glass, axes.At(u1, glass, w0), axes.At(u0, glass, w0), axes.At(u0, glass, w1),
               axes.At(u1, glass, w1));
  if (window.w0 > 0.05F) {  // the sill board inside, the weathered one outside
    const Vec3 inner_low{std::max(0.0F, window.u0 - 0.05F), -0.05F, window.w0 - 0.03F};
    builder.Box(materials.trim, axes, inner_low, {std::min(wall.length_m, window.u1 + 0.05F), 0, window.w0 + 0.004F});
    builder.Box(materials.trim, axes, {window.u0, 0, window.w0}, {window.u1, v0, window.w0 + 0.004F});
    builder.Box(materials.trim, axes, {window.u0 - 0.03F, v1, window.w0 - 0.03F},
                {window.u1 + 0.03F, t + 0.035F, window.w0 + 0.004F});
  }
  return builder.Take();
}

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

std::vector<ShellPart> BuildShell(const RoomShape& shape, const v1::LayoutGraph& graph) {
  const ShellMaterials materials = ShellMaterialsOf(graph);
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
    AddOpenings(shape, i, graph.style_sheet(), materials, shell);
  }
  return shell;
}

}  // namespace flair::renderer
