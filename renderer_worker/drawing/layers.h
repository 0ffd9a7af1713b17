// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/labels.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

// The layers of a plan, each drawn by one function onto a canvas in sheet frame S.
// The blocks of the side panel. Heights are what they take of the paper, millimetres; 0 when there is nothing to say.

namespace flair::renderer {

// A dimension line outside the room, in S: `ticks_mm` along it, one text between each two.
struct DimensionString {
  Point direction;  // unit, along the line
  Point outward;    // unit, away from the wall
  std::vector<Point> ticks_mm;
  std::vector<std::string> texts;
  double reach_mm = 0;  // from the wall's face to the line
};

// A number needs this much between its ticks; shorter first and last pieces carry it beyond the end of the line.
inline constexpr double kLeastPieceMm = 8;
inline double PieceMm(const DimensionString& string, size_t piece) {
  return std::hypot(string.ticks_mm[piece + 1].x - string.ticks_mm[piece].x,
                    string.ticks_mm[piece + 1].y - string.ticks_mm[piece].y);
}

// Dimension strings: a chain along each wall with openings, the length of every wall that no parallel one tells, and
// the extent of the room where none of its walls has it. None when the layer is not drawn.
std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet);

// A free distance inside the room: straight ahead from the middle of a large piece's front to the next solid piece or
// wall. Room frame R.
struct Clearance {
  Point from_m;
  Point to_m;
  double length_m = 0;
};

// The key clearances of [0.35, 2.5] m, of the largest pieces first, at most eight; of two that run beside each other
// over the same floor only one. None when the layer of dimensions is not drawn.
std::vector<Clearance> FindClearances(const Plan& plan);

// Those of them that are long enough on this paper to carry their number.
std::vector<Clearance> ShownClearances(const Plan& plan, const Sheet& sheet);

// The paper that the number of a clearance takes.
Box ClearanceTextBox(const Canvas& canvas, const Sheet& sheet, const Clearance& clearance);

void DrawClearances(Canvas& canvas, const Plan& plan, const Sheet& sheet);

// A door leaf in R: the hinge, where it ends open, and where it meets the frame closed.
struct DoorLeafGeometry {
  Point hinge_m;
  Point open_end_m;
  Point closed_end_m;
};
DoorLeafGeometry LeafOf(const Plan& plan, const PlanOpening& door);

// walls.cc
void DrawFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawZones(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawWalls(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawOpenings(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// `inward` is a unit vector away from the wall.
void DrawSocketSign(Canvas& canvas, Point at_mm, Point inward);
void DrawSockets(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// furniture.cc; the last draws what hangs on walls and above, after the walls
void DrawRugs(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawFurniture(Canvas& canvas, const Plan& plan, const Sheet& sheet);
void DrawMounted(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// One piece, without its shadow; `above` says that it is one of which the plan shows the outline only.
void DrawPiece(Canvas& canvas, const PlanObject& object, bool above, const Sheet& sheet);
// What hangs on walls and above.
bool IsMounted(const PlanObject& object);
// Whether it shows as an outline: what hangs on a wall, is deep and above the plane that plans are cut at, or has a
// piece that stands on the floor below the middle of its front.
bool IsAbove(const Plan& plan, const PlanObject& object);
// A soft shadow to the lower right, longer for taller pieces: layers of growing outlines, vector on every surface.
bool HasShadow(const PlanObject& object);
Point ShadowOffsetMm(const PlanObject& object, const Sheet& sheet);
void DrawShadow(Canvas& canvas, const PlanObject& object, const Sheet& sheet);
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
// label_layer.cc; what a piece asks of its label, and of others that would cover it. Sets the numbers of the plan's
// keys.
std::vector<PlacedLabel> DrawLabels(Canvas& canvas, const Sheet& sheet, Plan& plan);
// A name that the plan writes within a piece.
struct NameOnPiece {
  int object = 0;  // index in Plan::objects
  std::vector<std::string> lines;
  Point centre_mm;
};
inline constexpr double kNameSizeMm = 3.3;
std::vector<NameOnPiece> NamesOnPieces(Canvas& canvas, const Plan& plan, const Sheet& sheet);
LabelItem LabelItemOf(const PlanObject& object, const Sheet& sheet);
LabelObstacle LabelObstacleOf(const PlanObject& object, const Sheet& sheet, int owner);
void DrawLeader(Canvas& canvas, const PlacedLabel& label, const LabelItem& item);
// side_panel.cc: title, key, legends, style, title block; see Panel below
void DrawSidePanel(Canvas& canvas, const Plan& plan, const Sheet& sheet);
// `factor` shrinks it.
void DrawBadge(Canvas& canvas, int number, Point centre_mm, const Rgb& fill, const Rgb& line, double factor = 1);
Size BadgeSize(int number);

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

// legends.cc: what each number is; `least` is what it takes at its smallest without leaving anything out.
double LeastKeyHeight(const Plan& plan);
void DrawKey(Canvas& canvas, const Plan& plan, const Box& box);

// side_panel.cc; with `draw` false it only measures, without `words` it leaves the sentences out.
double DrawStyle(Canvas& canvas, const Plan& plan, const Box& box, bool words, bool draw);

// legends.cc: what lines and symbols mean, of those that are on the plan.
double DrawSigns(Canvas& canvas, const Plan& plan, const Box& box, bool draw);

// legends.cc: verdicts and circulation, when their layers are drawn.
double DrawOverlayLegend(Canvas& canvas, const Plan& plan, const Box& box, double most_mm, bool draw);

}  // namespace flair::renderer
