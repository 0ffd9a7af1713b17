// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "renderer_worker/drawing/canvas.h"

namespace flair::renderer {

// The colours one object is drawn in: what says most of it, its lines, its frame, its upholstery.
struct Ink {
  Rgb fill;
  Rgb line;
  Rgb hard = fill;
  Rgb soft = fill;
};

// Draws the plan symbol `plan.NAME` of furniture/pieces/ in object frame O: origin in the middle, x to the right of
// someone who stands behind the object and looks the way it faces, y to its front, metres. Symbols fill exactly
// [-width/2, width/2] x [-depth/2, depth/2]. The canvas must be in frame O already. Where there is no such symbol, or
// its script fails, a plain block is drawn and the error returned. Thread-safe for different canvases.
//
// What scripts draw with; any box {x0, y0, x1, y1} may be given in any corner order, points are {x, y}:
//   area(box, tone, line = "outline", corner radius = 0)
//   oval(centre, radius_x, radius_y, tone, line = "detail")
//   shape(points, tone, line = "outline")
//   segment(from, to, line = "detail")
//   curve(from, control, control, to, line = "detail")
// Tones: none, body, light, pale, dark, deep (of the object's colour), hard, soft (of its parts), water, glass, leaf,
// wood, metal, fire. Lines: none, outline, detail, faint, dashed.
absl::Status DrawSymbol(Canvas& canvas, const Ink& ink, double width_m, double depth_m, std::string_view name);

// Whether there is a symbol of that name.
bool HasSymbol(std::string_view name);

}  // namespace flair::renderer
