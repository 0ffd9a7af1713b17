// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms and layouts as short strings, for tests, examples and logs. Items are separated by ';', words by blanks:
//   4x3 room                                  a rectangle, 4 m wide (x) and 3 m deep (y)
//   room 0,0 4,0 4,2 2,2 2,4 0,4              any simple polygon, counter-clockwise
//   door south 0.5 0.9 [hinge_end] [outward | sliding | open]     wall, offset, width
//   window east 1 1.2 [sill 0.9] [head 2.1]
//   socket north 2 [height 0.3]
//   zone sleeping [at 1,1]                    with its mean point
//   desk 1.2x0.6 at 2,0.3,90 [words]          id, width x depth, centre and heading in degrees
// Words of an object: wall | ceiling | surface | rug, tertiary | primary, height H, elevation H, zone ID, on ID (host),
// rim W W (beside an opening in its top: at the sides, at front and back).
// Lengths are metres. The room comes first; hosts and zones before they are named.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "room/scene/scene.h"

namespace flair {

struct SceneText {
  Scene scene;
  Layout layout;
  // One per zone; the centre of the room for those without "at".
  std::vector<Vec2<double>> zone_centers;
};

// INVALID_ARGUMENT with the item that cannot be read.
absl::StatusOr<SceneText> ParseScene(std::string_view text);

}  // namespace flair
