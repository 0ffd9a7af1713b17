// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

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
