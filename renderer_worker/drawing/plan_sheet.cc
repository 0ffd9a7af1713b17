// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/plan_sheet.h"

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

void DrawFrame(Canvas& canvas, const Sheet& sheet) {
  canvas.Rectangle({0, 0, sheet.size_mm.width, sheet.size_mm.height});
  canvas.Fill(Hex(0xFFFFFF));
  canvas.Rectangle(Box{0, 0, sheet.size_mm.width, sheet.size_mm.height}.Grown(-6));
  canvas.Draw({Hex(0x8A8379), 0.25});
}

}  // namespace

absl::StatusOr<PlanSheet> MakePlanSheet(const v1::SolvedLayout& layout, const v1::RenderOptions& options) {
  const absl::StatusOr<PlanLayers> layers = LayersOf(options);
  if (!layers.ok()) return layers.status();
  absl::StatusOr<Plan> plan = ReadPlan(layout, *layers);
  if (!plan.ok()) return plan.status();
  const absl::StatusOr<Sheet> sheet = ChooseSheet(*plan, options);
  if (!sheet.ok()) return sheet.status();
  if (absl::Status status = CheckFonts(); !status.ok()) return status;
  return PlanSheet{*std::move(plan), *sheet};
}

void DrawRoom(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  DrawFloor(canvas, plan, sheet);
  if (plan.layers.zones) DrawZones(canvas, plan, sheet);
  DrawRugs(canvas, plan, sheet);
  if (plan.layers.circulation) DrawRoutes(canvas, plan, sheet);
  DrawFurniture(canvas, plan, sheet);
  DrawWalls(canvas, plan, sheet);
  DrawOpenings(canvas, plan, sheet);
  DrawSockets(canvas, plan, sheet);
  DrawMounted(canvas, plan, sheet);
}

std::vector<PlacedLabel> DrawSheet(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  DrawFrame(canvas, sheet);
  canvas.Rectangle(sheet.plan_mm.Grown(4));
  canvas.Clip();
  DrawRoom(canvas, plan, sheet);
  DrawBlocked(canvas, plan, sheet);
  if (plan.layers.constraints) DrawConstraints(canvas, plan, sheet);
  DrawDimensions(canvas, plan, sheet);
  std::vector<PlacedLabel> labels = DrawLabels(canvas, plan, sheet);
  canvas.Unclip();
  DrawSidePanel(canvas, plan, sheet);
  return labels;
}

}  // namespace flair::renderer
