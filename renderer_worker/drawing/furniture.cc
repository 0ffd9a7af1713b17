// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/furniture/script.h"

namespace flair::renderer {
namespace {

void TraceOutline(Canvas& canvas, const PlanObject& object, double grown_m) {
  const double w = object.width_m / 2 + grown_m, d = object.depth_m / 2 + grown_m;
  if (object.shown_as->outline() == FurnitureClass::ELLIPSE) {
    canvas.Ellipse({0, 0}, w, d);
  } else {
    const double radius = object.shown_as->outline() == FurnitureClass::ROUNDED ? 0.18 * std::min(w, d) : 0.01;
    canvas.Rectangle({-w, -d, w, d}, radius + std::max(0.0, grown_m));
  }
}

void DrawObject(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  // Whatever its proportions, a piece covers its footprint and no more (half a millimetre for its outline).
  canvas.Rectangle(BoxAround({0, 0}, {object.width_m, object.depth_m}).Grown(0.5 / sheet.mm_per_m()));
  canvas.Clip();
  DrawSymbol(canvas, object.ink, object.width_m, object.depth_m, object.shown_as->symbol()).IgnoreError();
  canvas.Unclip();
  canvas.LeaveFrame();
}

// Wall pieces are bars of at least 1 mm on paper, grown into the room so that the wall stays clean.
PlanObject AsBar(PlanObject object, const Sheet& sheet) {
  const double least = 1.1 / sheet.mm_per_m();
  if (object.depth_m < least) {
    const double grow = (least - object.depth_m) / 2;
    object.centre_m = object.centre_m + Point{-std::sin(object.theta_rad), std::cos(object.theta_rad)} * grow;
    object.depth_m = least;
  }
  return object;
}

void DrawAbove(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  TraceOutline(canvas, object, 0);
  canvas.Draw({Hex(0x5A5148), 0.2, 0.9, Dash::kDashed});
  canvas.LeaveFrame();
}

// What hangs above shows as a dashed outline only.
void DrawOverhead(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  if (object.shown_as->symbol_overhead()) {
    PlanObject overhead = object;
    overhead.ink.line = Hex(0x5A5148);
    DrawObject(canvas, overhead, sheet);
    return;
  }
  DrawAbove(canvas, object, sheet);
}

// Whether any of it can be seen; what lies kilometres away would overflow the surface's coordinates.
bool OnPaper(const PlanObject& object, const Sheet& sheet) {
  const Point centre = sheet.ToSheet(object.centre_m);
  const double reach = std::hypot(object.width_m, object.depth_m) / 2 * sheet.mm_per_m();
  return BoxAround(centre, {2 * reach, 2 * reach}).Overlaps(sheet.plan_mm.Grown(10));
}

// What a script may fill with, by name; none is no fill.
constexpr const char* kTones[] = {"none", "body",  "light", "pale", "dark", "deep",  "hard",
                                  "soft", "water", "glass", "leaf", "wood", "metal", "fire"};
using Tone = Rgb (*)(const Ink& ink);
constexpr Tone kToneColours[] = {nullptr,
                                 [](const Ink& ink) { return ink.fill; },
                                 [](const Ink& ink) { return Mix(ink.fill, kWhite, 0.28); },
                                 [](const Ink& ink) { return Mix(ink.fill, kWhite, 0.78); },
                                 [](const Ink& ink) { return Mix(ink.fill, ink.line, 0.16); },
                                 [](const Ink& ink) { return Mix(ink.fill, ink.line, 0.62); },
                                 [](const Ink& ink) { return ink.hard; },
                                 [](const Ink& ink) { return ink.soft; },
                                 [](const Ink&) { return Hex(0xDCEBF0); },
                                 [](const Ink&) { return Hex(0xE8EFF1); },
                                 [](const Ink& ink) { return Mix(Hex(0xA9C29A), ink.fill, 0.15); },
                                 [](const Ink&) { return Hex(0xD9C3A3); },
                                 [](const Ink&) { return Hex(0xD3D5D6); },
                                 [](const Ink&) { return Hex(0xE9A36B); }};
enum class Line { kNone, kOutline, kDetail, kFaint, kDashed };
constexpr const char* kLines[] = {"none", "outline", "detail", "faint", "dashed"};

// What a script draws with.
struct Pen {
  Canvas& canvas;
  Ink ink;
};

Canvas& CanvasOf(lua_State* state) { return SessionOf<Pen>(state).canvas; }

Point PointAt(lua_State* state, int argument) {
  return {ComponentAt(state, argument, 1), ComponentAt(state, argument, 2)};
}

// Fills and strokes the path with the tone and the line at these arguments.
int Paint(lua_State* state, Tone tone, int line_argument, Line usual) {
  constexpr double kOutlineMm = 0.30, kDetailMm = 0.16, kFaintMm = 0.11;
  const auto line = static_cast<Line>(ChoiceAt(state, line_argument, kLines, static_cast<int>(usual)));
  const auto& [canvas, ink] = SessionOf<Pen>(state);
  if (tone != nullptr) canvas.Fill(tone(ink), 1, line != Line::kNone);
  const double width_mm = line == Line::kOutline ? kOutlineMm : line == Line::kFaint ? kFaintMm : kDetailMm;
  const double alpha = line == Line::kFaint ? 0.55 : line == Line::kDetail ? 0.8 : 1;
  if (line != Line::kNone) {
    canvas.Draw({ink.line, width_mm, alpha, line == Line::kDashed ? Dash::kDashed : Dash::kSolid});
  }
  canvas.Discard();
  return 0;
}

Tone ToneAt(lua_State* state, int argument) { return kToneColours[ChoiceAt(state, argument, kTones, -1)]; }

int DrawArea(lua_State* s) {
  const double x0 = ComponentAt(s, 1, 1), y0 = ComponentAt(s, 1, 2), x1 = ComponentAt(s, 1, 3),
               y1 = ComponentAt(s, 1, 4), radius = NumberAt(s, 4, 0);
  const Tone tone = ToneAt(s, 2);
  CanvasOf(s).Rectangle({std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)}, radius);
  return Paint(s, tone, 3, Line::kOutline);
}

int DrawOval(lua_State* s) {
  const Tone tone = ToneAt(s, 4);
  CanvasOf(s).Ellipse(PointAt(s, 1), NumberAt(s, 2), NumberAt(s, 3));
  return Paint(s, tone, 5, Line::kDetail);
}

int DrawShape(lua_State* s) {
  std::vector<Point> points;
  ForEachAt(s, 1, [&](int at) { points.push_back(PointAt(s, at)); });
  const Tone tone = ToneAt(s, 2);
  CanvasOf(s).Polygon(points);
  return Paint(s, tone, 3, Line::kOutline);
}

int DrawSegment(lua_State* s) {
  CanvasOf(s).Line(PointAt(s, 1), PointAt(s, 2));
  return Paint(s, nullptr, 3, Line::kDetail);
}

int DrawCurve(lua_State* s) {
  CanvasOf(s).MoveTo(PointAt(s, 1));
  CanvasOf(s).CurveTo(PointAt(s, 2), PointAt(s, 3), PointAt(s, 4));
  return Paint(s, nullptr, 5, Line::kDetail);
}

Script& Symbols() {
  static constexpr luaL_Reg kFunctions[] = {{"area", DrawArea},       {"oval", DrawOval},   {"shape", DrawShape},
                                            {"segment", DrawSegment}, {"curve", DrawCurve}, {nullptr, nullptr}};
  static Script& symbols = *new Script(kFunctions);
  return symbols;
}

}  // namespace

bool HasShadow(const PlanObject& object) {
  return object.kind == v1::OBJECT_KIND_FLOOR && !object.walk_over &&
         object.shown_as->outline() != FurnitureClass::OPEN;
}

Point ShadowOffsetMm(const PlanObject& object, const Sheet& sheet) {
  const double height = std::clamp(object.top_m, 0.1, 2.2);
  const double offset_mm = std::min(0.5 + 0.035 * height * sheet.mm_per_m(), 2.2);
  return {0.8 * offset_mm, offset_mm};
}

void DrawShadow(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  const Point offset = ShadowOffsetMm(object, sheet);
  canvas.EnterFrame(sheet.ToSheet(object.centre_m) + offset, sheet.mm_per_m(), object.theta_rad, true);
  const double blur_m = 0.45 * offset.y / sheet.mm_per_m();
  for (double share : {1.0, 0.5, 0.0, -0.5}) {
    TraceOutline(canvas, object, share * blur_m);
    canvas.Fill(Hex(0x2B2621), 0.055);
  }
  canvas.LeaveFrame();
}

bool IsAbove(const Plan& plan, const PlanObject& object) {
  constexpr double kCut_m = 1.2, kDeep_m = 0.15;
  if (object.kind != v1::OBJECT_KIND_WALL || object.walk_over) return false;
  if (object.low_m >= kCut_m && object.depth_m > kDeep_m) return true;
  const Point front =
      object.centre_m + Point{-std::sin(object.theta_rad), std::cos(object.theta_rad)} * (object.depth_m / 2);
  return std::ranges::any_of(plan.objects, [&](const PlanObject& below) {
    return below.kind == v1::OBJECT_KIND_FLOOR && !below.walk_over && below.top_m < object.top_m &&
           PolygonContains(below.Corners(), front);
  });
}

void DrawPiece(Canvas& canvas, const PlanObject& object, bool above, const Sheet& sheet) {
  if (above) {
    DrawAbove(canvas, object, sheet);
  } else if (object.kind == v1::OBJECT_KIND_CEILING && !object.walk_over) {
    DrawOverhead(canvas, object, sheet);
  } else {
    DrawObject(canvas, IsMounted(object) ? AsBar(object, sheet) : object, sheet);
  }
}

bool IsMounted(const PlanObject& object) {
  return !object.walk_over && (object.kind == v1::OBJECT_KIND_WALL || object.kind == v1::OBJECT_KIND_CEILING);
}

void DrawRugs(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (object.walk_over && OnPaper(object, sheet)) DrawPiece(canvas, object, false, sheet);
  }
}

void DrawFurniture(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (object.walk_over || IsMounted(object) || !OnPaper(object, sheet)) continue;
    if (HasShadow(object)) DrawShadow(canvas, object, sheet);
    DrawPiece(canvas, object, false, sheet);
  }
}

void DrawMounted(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (IsMounted(object) && OnPaper(object, sheet)) DrawPiece(canvas, object, IsAbove(plan, object), sheet);
  }
}

absl::Status DrawSymbol(Canvas& canvas, const Ink& ink, double width_m, double depth_m, std::string_view name) {
  Pen pen{canvas, ink};
  const PieceSize size{width_m, depth_m, 0, 0};
  const absl::Status drawn = Symbols().Run("plan", name, size, &pen);
  if (drawn.ok()) return drawn;
  canvas.Discard();
  Symbols().Run("plan", "plain_box", size, &pen).IgnoreError();
  return drawn;
}

}  // namespace flair::renderer
