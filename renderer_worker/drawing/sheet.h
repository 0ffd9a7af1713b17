// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/labels.h"
#include "renderer_worker/drawing/plan.h"

namespace flair::renderer {

// Paper and scale, turned whichever way shows the room larger. The plan has its own area; the key and the title have a
// column on the right (landscape) or a strip below (portrait).
struct Sheet {
  std::string_view paper = "A3";
  Size size_mm;
  Box plan_mm;
  Box side_mm;
  bool portrait = false;
  int scale = 50;   // 1:scale
  Point origin_mm;  // of R

  double mm_per_m() const { return 1000.0 / scale; }
  Point ToSheet(Point point_m) const {
    return {origin_mm.x + point_m.x * mm_per_m(), origin_mm.y - point_m.y * mm_per_m()};
  }
};

inline constexpr double kWallThicknessM = 0.14;
// Thick enough to be seen as a pair of lines at any scale, and no heavier than the drawing can bear.
inline double WallThicknessMm(const Sheet& sheet) { return std::clamp(kWallThicknessM * sheet.mm_per_m(), 2.0, 7.0); }

// How far doors of a wall swing out of the room, millimetres of paper.
double OutwardReachMm(const Plan& plan, const Sheet& sheet, int wall);

// What walls, outward doors and dimension lines take of the paper at the sheet's scale and origin.
Box PaperNeeded(const Plan& plan, const Sheet& sheet);

// The common scales, largest first: 10 for 1:10.
std::span<const int> CommonScales();

// The paper without scale and origin. `paper` is one that is known.
Sheet EmptySheet(v1::PaperSize paper, bool portrait, int scale);

// The paper of the options at their scale, or at the largest common one at which room, outward doors and dimension
// lines fit. INVALID_ARGUMENT when a given scale is out of [5, 1000] or too large for the paper (the message says which
// one would fit), or when no scale is small enough.
absl::StatusOr<Sheet> ChooseSheet(const Plan& plan, const v1::RenderOptions& options = {});

// What is drawn and where on the paper, whatever becomes of it.
struct PlanSheet {
  Plan plan;
  Sheet sheet;
};

// Reads the layout and chooses the sheet. Errors as DrawPlan.
absl::StatusOr<PlanSheet> MakePlanSheet(const v1::SolvedLayout& layout, const v1::RenderOptions& options);

// White paper with its frame.
void DrawPaper(Canvas& canvas, const Sheet& sheet);

// Draws the whole sheet, frame and side panel included, onto a canvas in sheet frame S.
std::vector<PlacedLabel> DrawSheet(Canvas& canvas, const Plan& plan, const Sheet& sheet);

// Draws the room alone: no dimensions, no labels, no paper.
void DrawRoom(Canvas& canvas, const Plan& plan, const Sheet& sheet);

// What becomes of drawing commands: pixels, or a page of a file.

using Drawing = std::function<void(Canvas&)>;

// Resolution of a picture of that paper, by options.size_px or options.dpi, within what memory allows.
absl::StatusOr<double> PixelsPerMm(const Sheet& sheet, const v1::RenderOptions& options);

// A picture of so many pixels, of which `px_per_mm` are a millimetre of paper.
absl::StatusOr<Pixels> DrawOnPixels(int width_px, int height_px, double px_per_mm, const Drawing& draw);
// Puts those of an RGB24 surface below what `pixels` holds already, which must be as wide.
void AppendPixels(cairo_surface_t* surface, Pixels& pixels);
// The whole paper.
absl::StatusOr<Pixels> DrawOnPixels(const Sheet& sheet, double px_per_mm, const Drawing& draw);

// The whole paper as SVG or PDF, see DrawPlanDocument; `title` and the scale go into the metadata unless they are
// there.
absl::StatusOr<std::string> DrawInDocument(const Sheet& sheet, const std::string& title,
                                           const v1::RenderOptions& options, const DrawingMetadata& metadata,
                                           const Drawing& draw);

}  // namespace flair::renderer
