// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// Where the shapes that follow are put: a point p of theirs lands at origin + p.x x + p.y y + p.z z. The axes are unit,
// perpendicular and right-handed.
struct Frame {
  Vec3 origin;
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};
};

// Collects solid shapes into a mesh with one part per material. All lengths in metres. Shapes are closed, wound
// counter-clockwise as seen from outside, smooth where they are round; texture coordinates are metres, the first along
// the grain (the longer way). Sizes may be given in any order and as small as wanted: what has no volume is left out.
class Modeller {
 public:
  // Everything that `body` adds is put into `frame`, within the frames around it.
  void In(const Frame& frame, const std::function<void()>& body);

  // Of all shapes so far.
  size_t vertex_count() const;

  // Where a point of the frame that is being filled lands.
  Vec3 Placed(Vec3 point) const;

  // A box whose edges are cut by `bevel`, and shaded as if they were rounded.
  void Box(const Material& material, Vec3 low, Vec3 high, float bevel = 0.004F);
  // A box with truly round edges, its six faces puffed out by `crown` from the middle: cushions and mattresses. The
  // outermost points stay within the box.
  void Cushion(const Material& material, Vec3 low, Vec3 high, float radius, float crown = 0);
  // Two sheets of cloth sewn together and filled: flat at its edges, full in the middle; thin along its shortest side.
  void Pillow(const Material& material, Vec3 low, Vec3 high);
  // From a rectangle around `bottom` to one around `top`, half sizes given, both level: tapered legs, shades, hoods.
  void Taper(const Material& material, Vec3 bottom, Vec2 bottom_half, Vec3 top, Vec2 top_half);
  // A polygon, simple and counter-clockwise, between two heights; its upper and lower edges cut by `bevel`. Smooth
  // where its corners turn by less than 40 degrees.
  void Slab(const Material& material, std::span<const Vec2> outline, float bottom, float top, float bevel = 0.003F);
  // A profile of (radius, height) turned about a vertical axis, from bottom to top; ends that do not reach the axis are
  // closed by a disc. `stretch` scales x and y. Creases where the profile turns by more than 50 degrees.
  void Lathe(const Material& material, Vec3 base, std::span<const Vec2> profile, int sides = 20, Vec2 stretch = {1, 1});
  // The same with a closed profile that stays off the axis, counter-clockwise with radius to the right: rings, shades.
  void Ring(const Material& material, Vec3 base, std::span<const Vec2> profile, int sides = 24, Vec2 stretch = {1, 1});
  // A round bar through the points, with flat ends. `radii` has one entry for all, or one a point.
  void Tube(const Material& material, std::span<const Vec3> path, std::span<const float> radii, int sides = 8);
  // A sheet of cloth, paper or leaf: `at` maps [0, 1] x [0, 1] to points; the side towards which d/du x d/dv points and
  // its other side are `thickness` apart.
  void Sheet(const Material& material, int columns, int rows, const std::function<Vec3(float u, float v)>& at,
             float thickness = 0.003F);

  // The mesh, stretched along its axes so that it fills [-width/2, width/2] x [-depth/2, depth/2] x [0, height]
  // exactly. Triangles without an area are gone. Empty when nothing was added. Points inside move along through
  // `inside`.
  Mesh Filling(float width, float depth, float height, std::span<Vec3> inside);

 private:
  friend class Patch;
  MeshPart& PartOf(const Material& material);
  Vec3 Directed(Vec3 direction) const;

  std::vector<MeshPart> parts_;
  Frame frame_;
};

// Adds one shape's vertices and triangles to the part of its material, within the modeller's frame. For shapes only.
class Patch {
 public:
  Patch(Modeller& modeller, const Material& material);

  // Index of the new vertex, for Triangle and Quad.
  uint32_t Vertex(Vec3 position, Vec3 normal, Vec2 uv);
  void Triangle(uint32_t a, uint32_t b, uint32_t c);
  void Quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) { Triangle(a, b, c), Triangle(a, c, d); }
  // A flat convex polygon with its own vertices and normal; the texture runs along `grain`.
  void Flat(std::span<const Vec3> corners, Vec3 grain);
  // Gives every vertex of this patch the mean normal of the triangles that meet at its position.
  void SmoothNormals();

 private:
  const Modeller& modeller_;
  MeshPart& part_;
  size_t first_vertex_;
  size_t first_index_;
};

}  // namespace flair::renderer
