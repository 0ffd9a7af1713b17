// SPDX-License-Identifier: GPL-3.0-or-later
// A furnished room as the measures see it. References must outlive it.
#pragma once

#include <utility>
#include <vector>

#include "room/scene/scene.h"

namespace flair::evaluation {

struct LayoutView {
  LayoutView(const Scene& scene, const Layout& layout, std::vector<bool> placed = {})
      : scene(scene), layout(layout), placed(std::move(placed)) {}
  LayoutView(const Scene& scene, const Layout& layout, const std::vector<char>& placed)
      : LayoutView(scene, layout, std::vector<bool>(placed.begin(), placed.end())) {}

  const Scene& scene;
  const Layout& layout;
  // One per object; objects that are not placed are not measured. All are when it is empty.
  std::vector<bool> placed;

  bool Has(size_t object) const { return placed.empty() || placed[object]; }
};

// Stands on the floor and is in the way.
inline bool IsSolid(const Object& object) { return object.kind == ObjectKind::kFloor && !object.walk_over; }

}  // namespace flair::evaluation
