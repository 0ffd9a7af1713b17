// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/comparison/draw_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "renderer_worker/comparison/arrange.h"
#include "renderer_worker/comparison/change_list.h"
#include "renderer_worker/comparison/marks.h"
#include "renderer_worker/comparison/names.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/on_surface.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/plan_sheet.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

// How far what is drawn steps back where something is marked.
constexpr double kPale = 0.3;

void DrawPaper(Canvas& canvas, const Sheet& sheet) {
  canvas.Rectangle({0, 0, sheet.size_mm.width, sheet.size_mm.height});
  canvas.Fill(kWhite);
  canvas.Rectangle(Box{0, 0, sheet.size_mm.width, sheet.size_mm.height}.Grown(-6));
  canvas.Draw({Hex(0x8A8379), 0.25});
}

void DrawCaption(Canvas& canvas, const ComparisonPanel& panel, const Box& box) {
  DrawText(canvas, {panel.caption, {.size_mm = 5.4, .colour = kPanelInk, .serif = true}, box.width()},
           {box.x0, box.y0});
  DrawText(canvas, {panel.remark, {.size_mm = 3.1, .colour = kPanelSoft}, box.width()}, {box.x0, box.y0 + 7.6});
  Rule(canvas, box.x0, box.x1, box.y0 + 13);
}

void DrawPanel(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet) {
  DrawCaption(canvas, panel, sheet.side_mm);
  canvas.Rectangle(sheet.plan_mm.Grown(2));
  canvas.Clip();
  DrawRoom(canvas, panel.plan, sheet);
  if (!panel.changes.empty() || !panel.removed.empty()) {
    std::vector<Point> floor;
    for (const Point vertex : panel.plan.floor) floor.push_back(sheet.ToSheet(vertex));
    canvas.Polygon(floor);
    canvas.Fill(kWhite, kPale);
  }
  DrawBlocked(canvas, panel.plan, sheet);
  if (panel.plan.layers.constraints) DrawConstraints(canvas, panel.plan, sheet);
  DrawMarks(canvas, panel, sheet);
  DrawNames(canvas, panel, sheet);
  canvas.Unclip();
}

void DrawFoot(Canvas& canvas, const Comparison& comparison, const ComparisonSheet& sheet) {
  const Box& box = sheet.foot_mm;
  Rule(canvas, box.x0, box.x1, box.y0 + 1);
  double x = box.x0;
  std::set<ChangeKind> kinds;
  for (const ComparisonPanel& panel : comparison.panels) {
    for (const PlanChange& change : panel.changes) kinds.insert(change.kind);
  }
  constexpr std::pair<ChangeKind, const char*> kSigns[] = {{ChangeKind::kMoved, "moved"},
                                                           {ChangeKind::kResized, "another size"},
                                                           {ChangeKind::kAdded, "added"},
                                                           {ChangeKind::kRemoved, "removed"}};
  for (const auto& [kind, words] : kSigns) {
    if (!kinds.contains(kind)) continue;
    DrawMarkSign(canvas, kind, {x + 1, box.y0 + 3.6, x + 13, box.y0 + 7});
    const TextBlock text{words, {.size_mm = 3, .colour = kPanelInk}};
    DrawText(canvas, text, {x + 15.5, box.y0 + 3.2});
    x += 15.5 + Measure(canvas, text).width + 8;
  }
  const TextBlock scale{
      fmt::format("{}1:{} at {}", comparison.title.empty() ? "" : Capital(comparison.title) + "   ·   ",
                  sheet.paper.scale, sheet.paper.paper),
      {.size_mm = 3, .colour = kPanelSoft},
      box.x1 - x,
      1,
      Align::kRight};
  DrawText(canvas, scale, {x, box.y0 + 3.2});
}

struct Made {
  Comparison comparison;
  ComparisonSheet sheet;

  void Draw(Canvas& canvas) const {
    DrawPaper(canvas, sheet.paper);
    for (size_t i = 0; i < comparison.panels.size(); ++i) DrawPanel(canvas, comparison.panels[i], sheet.panels[i]);
    DrawChangeList(canvas, comparison, sheet.list_mm);
    DrawFoot(canvas, comparison, sheet);
  }
};

absl::StatusOr<Made> Make(const v1::RenderRequest& request) {
  absl::StatusOr<Comparison> comparison = ReadComparison(request);
  if (!comparison.ok()) return comparison.status();
  absl::StatusOr<ComparisonSheet> sheet = ArrangeComparison(*comparison, request.options());
  if (!sheet.ok()) return sheet.status();
  if (absl::Status status = CheckFonts(); !status.ok()) return status;
  return Made{*std::move(comparison), *std::move(sheet)};
}

}  // namespace

absl::StatusOr<DrawnPlan> DrawComparison(const v1::RenderRequest& request) {
  const absl::StatusOr<Made> made = Make(request);
  if (!made.ok()) return made.status();
  const absl::StatusOr<double> px_per_mm = PixelsPerMm(made->sheet.paper, request.options());
  if (!px_per_mm.ok()) return px_per_mm.status();
  absl::StatusOr<Pixels> pixels =
      DrawOnPixels(made->sheet.paper, *px_per_mm, [&](Canvas& canvas) { made->Draw(canvas); });
  if (!pixels.ok()) return pixels.status();
  return DrawnPlan{.pixels = *std::move(pixels),
                   .title = made->comparison.title,
                   .scale = made->sheet.paper.scale,
                   .paper = made->sheet.paper.paper};
}

absl::StatusOr<std::string> DrawComparisonDocument(const v1::RenderRequest& request, const DrawingMetadata& metadata) {
  const absl::StatusOr<Made> made = Make(request);
  if (!made.ok()) return made.status();
  return DrawInDocument(made->sheet.paper, made->comparison.title, request.options(), metadata,
                        [&](Canvas& canvas) { made->Draw(canvas); });
}

}  // namespace flair::renderer
