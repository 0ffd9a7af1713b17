// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/scene/shell.h"

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

}  // namespace flair::renderer
