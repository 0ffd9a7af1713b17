// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/room.pb.h"
#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// Axes in which the parts of a wall or opening are easily described: a point (u, v, w) is
// origin + u along + v outward + w up. Right-handed when seen with `along` to the right, `outward` away, `up` upwards.
struct Axes {
  Vec3 origin;
  Vec3 along{1, 0, 0};
  Vec3 outward{0, 1, 0};
  Vec3 up{0, 0, 1};
  Vec3 At(float u, float v, float w) const { return origin + along * u + outward * v + up * w; }
};

// Collects flat-shaded polygons into a mesh with one part per material. Polygons without an area are left out.
class MeshBuilder {
 public:
  // A planar polygon, counter-clockwise as seen from outside; the texture runs along `u_axis` (unit, in the plane), its
  // origin at the room's origin. Convex, at least three corners.
  void Polygon(const Material& material, std::span<const Vec3> corners, Vec3 u_axis);
  void Quad(const Material& material, Vec3 a, Vec3 b, Vec3 c, Vec3 d);
  // [low.x, high.x] along, [low.y, high.y] outward, [low.z, high.z] up in `axes`.
  void Box(const Material& material, const Axes& axes, Vec3 low, Vec3 high);
  // A round bar from a to b.
  void Bar(const Material& material, Vec3 a, Vec3 b, float radius, int sides);
  void Append(const Mesh& mesh);

  bool empty() const { return mesh_.parts.empty(); }
  Mesh Take() { return std::move(mesh_); }

 private:
  MeshPart& PartOf(const Material& material);
  Mesh mesh_;
};

// A hole in a wall, in the wall's axes: u along the wall from its start, w above the floor.
struct ShapedOpening {
  const v1::Opening* opening = nullptr;
  float u0 = 0, u1 = 0;
  float w0 = 0, w1 = 0;
  bool door() const { return opening->kind() == v1::OPENING_KIND_DOOR; }
};

// One wall: its inner face runs along the floor's edge, its body outwards. The outer face is mitred with the
// neighbours': it runs from outer_start to outer_end, in the wall's axes.
struct ShapedWall {
  std::string name;
  Axes axes;  // along the edge counter-clockwise, outward, up; left-handed
  float length_m = 0;
  float outer_start = 0;
  float outer_end = 0;
  std::vector<ShapedOpening> openings;  // those with an area, cut to the wall
};

// The room as solids: what shell, cameras and cut-aways are made of.
struct RoomShape {
  std::vector<Vec2> floor;
  float height_m = 3;
  float wall_thickness_m = 0.15F;
  std::vector<ShapedWall> walls;
};

inline constexpr float kSlabThickness_m = 0.12F;

// INVALID_ARGUMENT with the field's path for what is no room.
absl::StatusOr<RoomShape> ShapeOf(const v1::Room& room);

// Strictly inside the floor.
bool Inside(const RoomShape& shape, float x, float y);
// How far along `direction` (unit) an eye is from the room's inside, walls or not, between floor and ceiling; 0 for an
// eye within, infinite where it looks past.
float WayIn(const RoomShape& shape, Vec3 eye, Vec3 direction);

enum class WallCut {
  kWhole,
  kStub,  // cut at kStubHeight_m
  kGone,
};

// What a camera does not see, so that it sees the room.
struct CutAway {
  bool ceiling = false;        // and what hangs from it
  std::vector<WallCut> walls;  // as RoomShape::walls; with them goes what hangs on them
  // Of a wall's index, -1 for no wall.
  bool Takes(int wall) const { return wall >= 0 && walls[wall] != WallCut::kWhole; }
};

// From above the ceiling: no ceiling, stubs of the walls that would hide floor. From outside a wall, below the ceiling:
// the walls seen from behind are gone. From within the room: nothing is cut.
CutAway CutAwayFor(const RoomShape& shape, Vec3 eye);

// Floor, ceiling, then for each wall its body, skirting and openings.
std::vector<ShellPart> BuildShell(const RoomShape& shape, const v1::LayoutGraph& graph);

// The body of a wall up to `top_m`, openings cut, its upper surface of the section's material.
Mesh WallBody(const RoomShape& shape, const ShapedWall& wall, float top_m, const ShellMaterials& materials);

// A door with lining, architrave, leaf and handle; a window with lining, frame, bars, glass and sill.
Mesh DoorMesh(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& door,
              const ShellMaterials& materials, const Material& leaf);
// Where the leaf of a door that stands ajar is: along it from the hinge, through it, up. None for others.
std::optional<Axes> OpenLeafAxes(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& door);
Mesh WindowMesh(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& window,
                const ShellMaterials& materials, const Material& frame);

// An object as the box that it fills.
struct SightBox {
  Vec3 centre;
  Vec3 half;          // right, front, up
  Vec3 right;         // unit
  Vec3 front;         // unit
  bool high = false;  // hangs from the ceiling
  int wall = -1;      // that it hangs on
  bool GoneIn(const CutAway& cut) const { return (high && cut.ceiling) || cut.Takes(wall); }
};

// What can be seen from where, by boxes: good enough to choose a camera. The largest boxes only, so that rooms with
// thousands of objects take no longer.
class Sight {
 public:
  Sight(const RoomShape& shape, const std::vector<SceneObject>& objects);

  const std::vector<SightBox>& boxes() const { return boxes_; }
  // Distance to the first box on the way, `miss` when there is none up to there. Leaves out box `but` and what is cut
  // away.
  float FirstBox(Vec3 eye, Vec3 direction, float miss, int but, const CutAway& cut) const;
  // The share of the box's surface points, as seen from `eye`, that nothing hides and that `inside` accepts.
  template <typename Accepts>
  double VisibleShare(int box, Vec3 eye, const CutAway& cut, const Accepts& accepts) const;
  // Whether a wall that is not cut stands between.
  bool WallBetween(Vec3 eye, Vec3 point, const CutAway& cut) const;

 private:
  const RoomShape& shape_;
  std::vector<SightBox> boxes_;
  std::vector<SightBox> leaves_;  // of open doors: they hide, and nobody looks for them
};

template <typename Accepts>
double Sight::VisibleShare(int box, Vec3 eye, const CutAway& cut, const Accepts& accepts) const {
  const SightBox& b = boxes_[box];
  if (b.GoneIn(cut)) return 0;
  const Vec3 up{0, 0, 1};
  int seen = 0, count = 0;
  for (const float u : {-0.7F, 0.0F, 0.7F}) {
    for (const float v : {-0.7F, 0.7F}) {
      const Vec3 points[] = {b.centre + b.right * (u * b.half.x) + b.front * (v * b.half.y) + up * b.half.z,
                             b.centre + b.right * (u * b.half.x) + b.front * b.half.y + up * (v * b.half.z)};
      for (const Vec3& point : points) {
        ++count;
        const Vec3 way = point - eye;
        const float distance = Length(way);
        if (!accepts(point) || WallBetween(eye, point, cut)) continue;
        if (FirstBox(eye, way * (1 / distance), distance - 0.02F, box, cut) >= distance - 0.03F) ++seen;
      }
    }
  }
  return static_cast<double>(seen) / count;
}

// Three-quarter view from above, from the side from which most of the furniture shows its front; the room with its
// uncut walls fills a square picture up to an even margin.
SceneCamera BirdseyeCamera(const RoomShape& shape, const Sight& sight);

// From eye height, from a corner, a door, or a little behind a wall (which is cut away), where most objects are seen
// and nothing stands right before the eye.
SceneCamera PerspectiveCamera(const RoomShape& shape, const Sight& sight);

}  // namespace flair::renderer
