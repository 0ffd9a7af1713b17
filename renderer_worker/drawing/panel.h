// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

// The blocks of the side panel. Heights are what they take of the paper, millimetres; 0 when there is nothing to say.
namespace flair::renderer {

inline const Rgb kPanelInk = Hex(0x2B2926);
inline const Rgb kPanelSoft = Hex(0x6B665F);
inline const Rgb kPanelRule = Hex(0xB9B2A7);

std::string Capital(std::string text);
void Rule(Canvas& canvas, double x0, double x1, double y);
// Small capitals above a block; returns where the block goes on.
double Heading(Canvas& canvas, const std::string& text, double x, double y);

// side_panel.cc: the name and facts of the room, above all; drawing, scale, paper and north, below all.
double DrawTitle(Canvas& canvas, const Plan& plan, const Box& box);
inline constexpr double kTitleBlockMm = 33;
void DrawTitleBlock(Canvas& canvas, const Plan& plan, const Sheet& sheet, const Box& box);

// key_panel.cc: what each number is; `least` is what it takes at its smallest without leaving anything out.
double LeastKeyHeight(const Plan& plan);
void DrawKey(Canvas& canvas, const Plan& plan, const Box& box);

// side_panel.cc; with `draw` false it only measures, without `words` it leaves the sentences out.
double DrawStyle(Canvas& canvas, const Plan& plan, const Box& box, bool words, bool draw);

// legends.cc: what lines and symbols mean, of those that are on the plan.
double DrawSigns(Canvas& canvas, const Plan& plan, const Box& box, bool draw);

// legends.cc: verdicts and circulation, when their layers are drawn.
double DrawOverlayLegend(Canvas& canvas, const Plan& plan, const Box& box, double most_mm, bool draw);

}  // namespace flair::renderer
