// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of layouts. The paper's OOB and OOR with its rules put right (areas seen from above, m²):
//   OOB  what lies outside the floor, summed over all objects, rugs and ceiling objects included
//   OOR  what is in the same place as something else:
//        - solid floor objects against each other (rugs and mats exempt; a chair under a table counts)
//        - solid floor objects in the sector that an inward door sweeps (the paper: an enlarged square)
//        - wall, ceiling and surface objects against their own kind, where their heights overlap by more than 1 cm
//          (the paper: at any height), unless one carries the other; things of up to 5 cm on a surface exempt: others
//          stand on them
//        - wall objects behind furniture that reaches up to them by more than 1 cm and does not carry them (the paper:
//          never)
//        - wall objects over a door or window at their height, area along the wall times depth
// Accurate to rounding; door arcs are replaced by 32 tangents (0.01 % too large).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "room/scene/scene.h"

namespace flair::v1 {
class LayoutMetrics;
class SolvedLayout;
}  // namespace flair::v1

namespace flair::evaluation {

// A runner, a tray, a throw: flat enough for other things to stand on.
inline constexpr double kFlat_m = 0.05;
// Tangents that stand for the arc of a door.
inline constexpr int kArcPieces = 32;

// A furnished room as the measures see it. References must outlive it.
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

// Two things in the same place. `second` is an object, or an opening for objects in a door's swing or over an opening.
struct Overlap {
  std::string first;
  std::string second;
  double area_m2 = 0;
};

// Part of an object outside the floor.
struct Outside {
  std::string object;
  double area_m2 = 0;
};

// In order of objects; without those of less than 1e-12 m².
std::vector<Overlap> FindOverlaps(const LayoutView& view);
std::vector<Outside> FindOutside(const LayoutView& view);

// Percent of the room's area.
double OobPercent(const LayoutView& view);
double OorPercent(const LayoutView& view);

// Metres of the opening that the object's footprint, seen along the wall, covers; 0 when it hangs elsewhere.
double CoveredLength(const LayoutView& view, size_t object, const Opening& opening);

// How deep things stand in each other, in lengths instead of areas: an overlap of no depth is none.
// The largest of: the shortest push that parts two solid floor objects, or one from the swing of a door; the distance
// of a corner of any object beyond the floor. Metres, 0 when all is clear.
double DeepestOverlap_m(const LayoutView& view);

// All measures of a layout but uses; see above, measures.h and walk_grid.h for what they mean.
v1::LayoutMetrics MeasureLayout(const LayoutView& view);

// The same of a message, which is validated first, and its uses.
absl::StatusOr<v1::LayoutMetrics> MeasureLayout(const v1::SolvedLayout& layout);

}  // namespace flair::evaluation
