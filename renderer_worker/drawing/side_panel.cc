// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

std::string UnplacedText(const Plan& plan) {
  std::string text;
  for (const std::string& name : plan.unplaced) text += (text.empty() ? "Not placed: " : ", ") + name;
  return text;
}

// A block that is drawn from the bottom of what is left upwards, with a rule above it.
template <typename Block>
void StackUp(Canvas& canvas, Box& left, double height, const Block& block) {
  constexpr double kGapMm = 2.6;
  if (height <= 0 || height + 2 * kGapMm > left.height()) return;
  const double top = left.y1 - height;
  block(Box{left.x0, top, left.x1, left.y1});
  Rule(canvas, left.x0, left.x1, top - kGapMm);
  left.y1 = top - 2 * kGapMm;
}

void StackUnplaced(Canvas& canvas, const Plan& plan, Box& left) {
  if (plan.unplaced.empty()) return;
  const TextBlock unplaced{UnplacedText(plan), {.size_mm = 2.8, .colour = Hex(0x8C3B2E)}, left.width(), 3};
  const double height = Measure(canvas, unplaced).height;
  DrawText(canvas, unplaced, {left.x0, left.y1 - height});
  left.y1 -= height + 2;
}

// Everything that comes before the key where there is not paper enough for all.
void StackLegends(Canvas& canvas, const Plan& plan, Box& left) {
  const double most_mm = 0.6 * left.height();
  StackUp(canvas, left, DrawOverlayLegend(canvas, plan, left, most_mm, false),
          [&](const Box& box) { DrawOverlayLegend(canvas, plan, box, most_mm, true); });
  if (left.height() - LeastKeyHeight(plan) > DrawSigns(canvas, plan, left, false) + 5)
    StackUp(canvas, left, DrawSigns(canvas, plan, left, false),
            [&](const Box& box) { DrawSigns(canvas, plan, box, true); });
}

// The style with its sentences, without them, or not at all, as long as `keep_mm` stay free.
void StackStyle(Canvas& canvas, const Plan& plan, double keep_mm, Box& left) {
  for (const bool words : {true, false}) {
    const double height = DrawStyle(canvas, plan, {left.x0, 0, left.x1, 0}, words, false);
    if (left.height() - height - 5 < keep_mm) continue;
    StackUp(canvas, left, height, [&](const Box& box) { DrawStyle(canvas, plan, box, words, true); });
    return;
  }
}

}  // namespace

std::string Capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

void Rule(Canvas& canvas, double x0, double x1, double y) {
  canvas.Line({x0, y}, {x1, y});
  canvas.Draw({kPanelRule, 0.2});
}

double Heading(Canvas& canvas, const std::string& text, double x, double y) {
  DrawText(canvas, {text, {.size_mm = 2.7, .colour = kPanelSoft, .bold = true, .tracking = 0.18}}, {x, y});
  return y + 5.2;
}

void DrawSidePanel(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  const Box side = sheet.side_mm;
  // Portrait: title, style and title block in a left column, the key beside it. Landscape: all in one column.
  Box left{side.x0, side.y0, sheet.portrait ? side.x0 + 0.40 * side.width() : side.x1, side.y1};
  left.y0 = DrawTitle(canvas, plan, left) + 0.5;
  DrawTitleBlock(canvas, plan, sheet, {left.x0, left.y1 - kTitleBlockMm, left.x1, left.y1});
  left.y1 -= kTitleBlockMm + 4;
  if (!sheet.portrait) Rule(canvas, left.x0, left.x1, left.y0);
  left.y0 += 3;
  if (sheet.portrait) {
    StackStyle(canvas, plan, 0, left);
    Box key{left.x1 + 8, side.y0, side.x1, side.y1};
    StackLegends(canvas, plan, key);
    StackUnplaced(canvas, plan, key);
    DrawKey(canvas, plan, key);
    return;
  }
  const double least_key = LeastKeyHeight(plan);
  Box rest = left;
  StackStyle(canvas, plan, least_key + DrawOverlayLegend(canvas, plan, left, 0.6 * left.height(), false), rest);
  StackLegends(canvas, plan, rest);
  StackUnplaced(canvas, plan, rest);
  DrawKey(canvas, plan, rest);
}

}  // namespace flair::renderer
