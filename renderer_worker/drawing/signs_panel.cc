// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kRowMm = 5.2, kSignMm = 9;

struct Sign {
  const char* words;
  void (*draw)(Canvas& canvas, const Box& box);
};

void Frame(Canvas& canvas, const Box& box) {
  canvas.Rectangle(box);
  canvas.Fill(Hex(0xFFFFFF), 1, true);
  canvas.Draw({kPanelInk, 0.25});
}

void WindowSign(Canvas& canvas, const Box& box) {
  Frame(canvas, {box.x0, box.y0 + 0.4, box.x1, box.y1 - 0.4});
  for (double share : {0.38, 0.62}) {
    const double y = box.y0 + share * box.height();
    canvas.Line({box.x0, y}, {box.x1, y});
  }
  canvas.Draw({kPanelInk, 0.16});
}

void DoorSign(Canvas& canvas, const Box& box) {
  const double r = box.height();
  canvas.Arc({box.x0 + 2.4, box.y1}, r, -1.5708, 0);
  canvas.Draw({kPanelInk, 0.16});
  canvas.Line({box.x0 + 2.4, box.y1}, {box.x0 + 2.4, box.y0});
  canvas.Draw({kPanelInk, 0.45});
}

void SlidingSign(Canvas& canvas, const Box& box) {
  const double y = box.centre().y;
  canvas.Line({box.x0, y - 1}, {box.x1, y - 1});
  canvas.Line({box.x0, y + 1}, {box.x1, y + 1});
  canvas.Draw({kPanelInk, 0.16});
  Frame(canvas, {box.x0, y - 0.35, box.centre().x, y + 0.35});
}

void PassageSign(Canvas& canvas, const Box& box) {
  for (double y : {box.y0 + 0.7, box.y1 - 0.7}) canvas.Line({box.x0, y}, {box.x1, y});
  canvas.Draw({kPanelInk, 0.18, 1, Dash::kDashed});
}

void SocketSignBox(Canvas& canvas, const Box& box) { DrawSocketSign(canvas, {box.centre().x, box.y0 + 0.2}, {0, 1}); }

void OverheadSign(Canvas& canvas, const Box& box) {
  canvas.Rectangle({box.x0 + 1, box.y0, box.x1 - 1, box.y1});
  canvas.Draw({kPanelInk, 0.2, 0.9, Dash::kDashed});
}

void FrontSign(Canvas& canvas, const Box& box) {
  Frame(canvas, {box.x0 + 1.5, box.y0, box.x1 - 1.5, box.y1});
  const double x = box.centre().x;
  const Point wedge[] = {{x - 0.8, box.y1 - 1.7}, {x + 0.8, box.y1 - 1.7}, {x, box.y1 - 0.5}};
  canvas.Polygon(wedge);
  canvas.Fill(kPanelInk);
}

// Those that are on the plan.
std::vector<Sign> SignsOf(const Plan& plan) {
  const auto any_opening = [&plan](auto holds) {
    return std::any_of(plan.openings.begin(), plan.openings.end(), holds);
  };
  std::vector<Sign> signs;
  if (any_opening([](const PlanOpening& o) { return !o.door; })) signs.push_back({"window, sill outside", WindowSign});
  if (any_opening([](const PlanOpening& o) {
        return o.door && (o.swing == v1::DOOR_SWING_INWARD || o.swing == v1::DOOR_SWING_OUTWARD);
      }))
    signs.push_back({"door and its swing", DoorSign});
  if (any_opening([](const PlanOpening& o) { return o.door && o.swing == v1::DOOR_SWING_SLIDING; }))
    signs.push_back({"sliding door", SlidingSign});
  if (any_opening([](const PlanOpening& o) { return o.door && o.swing == v1::DOOR_SWING_NONE; }))
    signs.push_back({"open passage", PassageSign});
  if (!plan.sockets.empty()) signs.push_back({"socket", SocketSignBox});
  if (std::any_of(plan.objects.begin(), plan.objects.end(),
                  [](const PlanObject& object) { return object.kind == v1::OBJECT_KIND_CEILING; }))
    signs.push_back({"hangs above", OverheadSign});
  if (std::any_of(plan.objects.begin(), plan.objects.end(),
                  [](const PlanObject& object) { return object.symbol->category == "box"; }))
    signs.push_back({"front of a piece", FrontSign});
  return signs;
}

}  // namespace

double DrawSigns(Canvas& canvas, const Plan& plan, const Box& box, bool draw) {
  const std::vector<Sign> signs = SignsOf(plan);
  if (signs.empty()) return 0;
  const int columns = std::max(1, static_cast<int>(box.width() / 36));
  const double pitch = box.width() / columns;
  const int rows = (static_cast<int>(signs.size()) + columns - 1) / columns;
  if (draw) {
    const double y0 = Heading(canvas, "SIGNS", box.x0, box.y0);
    for (size_t i = 0; i < signs.size(); ++i) {
      const double x = box.x0 + static_cast<double>(i % columns) * pitch,
                   y = y0 + static_cast<double>(i / columns) * kRowMm;
      signs[i].draw(canvas, {x, y + 0.7, x + kSignMm, y + kRowMm - 1});
      const TextBlock words{signs[i].words, {.size_mm = 2.8, .colour = kPanelInk}, pitch - kSignMm - 3};
      DrawText(canvas, words, {x + kSignMm + 2, y + kRowMm / 2 - Measure(canvas, words).height / 2});
    }
  }
  return 5.2 + rows * kRowMm;
}

}  // namespace flair::renderer
