// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/labels.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

// The layers of a plan, each drawn by one function onto a canvas in sheet frame S.
namespace flair::renderer {

// A door leaf in R: the hinge, where it ends open, and where it meets the frame closed.
struct DoorLeafGeometry {
  Point hinge_m;
  Point open_end_m;
  Point closed_end_m;
};
DoorLeafGeometry LeafOf(const Plan& plan, const PlanOpening& door);

// floor.cc
void DrawFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawZones(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// walls.cc
void DrawWalls(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawOpenings(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// `inward` is a unit vector away from the wall.
void DrawSocketSign(Canvas& canvas, Point at_mm, Point inward);
void DrawSockets(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// furniture.cc; the last draws what hangs on walls and above, after the walls
void DrawRugs(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawFurniture(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawMounted(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// overlay_layers.cc: circulation, below the furniture; what they do not reach, above it; what that means, in a box
void DrawRoutes(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawBlocked(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawRouteSign(Canvas& canvas, const Box& box, bool blocked);
// overlay_layers.cc; violated edges carry letters in their order
void DrawConstraints(Canvas& canvas, const Plan& plan, const Sheet& sheet);
Stroke VerdictStroke(v1::OutcomeStatus status);
std::string ViolationLetters(int index);
void DrawViolationBadge(Canvas& canvas, int index, Point centre_mm);
// dimensions.cc
void DrawDimensions(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// label_layer.cc; what a piece asks of its label, and of others that would cover it
std::vector<PlacedLabel> DrawLabels(Canvas& canvas, const Plan& plan, const Sheet& sheet);
LabelItem LabelItemOf(const PlanObject& object, const Sheet& sheet);
LabelObstacle LabelObstacleOf(const PlanObject& object, const Sheet& sheet, int owner);
void DrawLeader(Canvas& canvas, const PlacedLabel& label, const LabelItem& item);
// side_panel.cc: title, key, legends, style, title block; see panel.h
void DrawSidePanel(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// `factor` shrinks it.
void DrawBadge(Canvas& canvas, int number, Point centre_mm, const Rgb& fill, const Rgb& line, double factor = 1);
Size BadgeSize(int number);

}  // namespace flair::renderer
