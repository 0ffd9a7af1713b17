// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"

namespace flair::renderer {
namespace {

constexpr double kBandM = 0.6;
const Rgb kBand = Hex(0x3E8E9E);
const Rgb kBlocked = Hex(0xB3372C);

}  // namespace

void DrawRoutes(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  if (plan.routes_m.empty()) return;
  std::vector<Point> floor;
  for (Point vertex : plan.floor) floor.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(floor);
  canvas.Clip();
  // One path, so that ways that share the floor do not darken it.
  for (const std::vector<Point>& route : plan.routes_m) {
    canvas.MoveTo(sheet.ToSheet(route.front()));
    for (size_t i = 1; i < route.size(); ++i) canvas.LineTo(sheet.ToSheet(route[i]));
  }
  canvas.Draw({kBand, kBandM * sheet.mm_per_m(), 0.26, Dash::kSolid, true}, true);
  canvas.Draw({LineColourFor(kBand), 0.22, 0.9, Dash::kDashed});
  for (const std::vector<Point>& route : plan.routes_m) {
    canvas.Ellipse(sheet.ToSheet(route.back()), 0.75, 0.75);
    canvas.Fill(LineColourFor(kBand));
  }
  canvas.Unclip();
}

void DrawBlocked(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (!object.blocked) continue;
    std::vector<Point> corners;
    for (Point corner : object.Corners()) corners.push_back(sheet.ToSheet(corner));
    const Box box = BoundsOf(corners);
    canvas.Polygon(corners);
    canvas.Clip();
    constexpr double kPitchMm = 2.2;
    const double height = box.height();
    // At 45 degrees, in step over the whole sheet, so that neighbours look alike.
    const double first = std::floor((box.x0 + box.y0) / kPitchMm) * kPitchMm;
    for (double sum = first; sum < box.x1 + box.y1; sum += kPitchMm)
      canvas.Line({sum - box.y0, box.y0}, {sum - box.y0 - height, box.y1});
    canvas.Draw({kBlocked, 0.3, 0.75});
    canvas.Unclip();
    canvas.Polygon(corners);
    canvas.Draw({kBlocked, 0.5});
  }
}

void DrawRouteSign(Canvas& canvas, const Box& box, bool blocked) {
  const double y = box.centre().y;
  if (!blocked) {
    canvas.Line({box.x0 + 1, y}, {box.x1 - 1, y});
    canvas.Draw({kBand, box.height(), 0.26}, true);
    canvas.Draw({LineColourFor(kBand), 0.22, 0.9, Dash::kDashed});
    return;
  }
  canvas.Rectangle(box);
  canvas.Clip();
  for (double x = box.x0; x < box.x1 + box.height(); x += 1.4) canvas.Line({x, box.y0}, {x - box.height(), box.y1});
  canvas.Draw({kBlocked, 0.3, 0.75});
  canvas.Unclip();
  canvas.Rectangle(box);
  canvas.Draw({kBlocked, 0.4});
}

}  // namespace flair::renderer
