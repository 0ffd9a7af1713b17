// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/labels.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// What is drawn and where on the paper, whatever becomes of it.
struct PlanSheet {
  Plan plan;
  Sheet sheet;
};

// Reads the layout and chooses the sheet. Errors as DrawPlan.
absl::StatusOr<PlanSheet> MakePlanSheet(const v1::SolvedLayout& layout, const v1::RenderOptions& options);

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
// The whole paper.
absl::StatusOr<Pixels> DrawOnPixels(const Sheet& sheet, double px_per_mm, const Drawing& draw);

// The whole paper as SVG or PDF, see DrawPlanDocument; `title` and the scale go into the metadata unless they are
// there.
absl::StatusOr<std::string> DrawInDocument(const Sheet& sheet, const std::string& title,
                                           const v1::RenderOptions& options, const DrawingMetadata& metadata,
                                           const Drawing& draw);

}  // namespace flair::renderer
