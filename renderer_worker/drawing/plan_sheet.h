// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/canvas.h"
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

}  // namespace flair::renderer
