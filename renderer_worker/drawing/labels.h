// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "renderer_worker/drawing/box.h"

namespace flair::renderer {

// Something that wants a label, in S. Turned counter-clockwise by theta as people see it on the sheet.
struct LabelItem {
  Point centre_mm;
  double theta_rad = 0;
  double half_width_mm = 0;
  double half_depth_mm = 0;
  bool ellipse = false;
  Size badge_mm;                 // the number alone
  std::vector<Size> forms_mm;    // richer forms, best first (name on one line, name on two lines, ...)
  bool only_inside = false;      // a zone's name: no badge, no leader
  bool named_beside = false;     // forms that do not fit inside may stand beside it
  int group = -1;                // things that look alike: one label is enough for all of a group
  double shyness = 1;            // factor on the cost of covering obstacles
  std::vector<Point> region_mm;  // when not empty, the label's middle lies in this polygon
};

inline constexpr int kBadgeForm = -1;

// Where a label went. `form` indexes LabelItem::forms_mm or is kBadgeForm.
struct PlacedLabel {
  int item = 0;
  int form = kBadgeForm;
  Box box_mm;
  bool leader = false;
};

// Areas labels should stay clear of, with what it costs to cover them, per mm2.
struct LabelObstacle {
  Box box_mm;
  double cost = 1;
  int owner = -1;  // the item that may cover it
};

// Places at most one name per item or group and a number on each of a few alike, greedily: names inside their pieces
// first where they fit, then beside them, then numbers, smallest pieces first, nearest free place with a leader when
// the piece is too small. No two labels overlap, none covers a box that is `taken`; each lies in `floor_mm`. An item
// that finds no place gets none.
std::vector<PlacedLabel> PlaceLabels(const std::vector<LabelItem>& items, const std::vector<LabelObstacle>& obstacles,
                                     const std::vector<Point>& floor_mm, const std::vector<Box>& taken = {});

}  // namespace flair::renderer
