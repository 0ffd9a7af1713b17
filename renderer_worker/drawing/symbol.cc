// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/symbol.h"

#include <algorithm>
#include <vector>

#include "renderer_worker/furniture/script.h"

namespace flair::renderer {
namespace {

enum class Tone {
  kNone,
  kBody,
  kLight,
  kPale,
  kDark,
  kDeep,
  kHard,
  kSoft,
  kWater,
  kGlass,
  kLeaf,
  kWood,
  kMetal,
  kFire
};
constexpr const char* kTones[] = {"none", "body",  "light", "pale", "dark", "deep",  "hard",
                                  "soft", "water", "glass", "leaf", "wood", "metal", "fire"};
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

Rgb ColourOf(Tone tone, const Ink& ink) {
  switch (tone) {
    case Tone::kNone:
    case Tone::kBody:
      return ink.fill;
    case Tone::kLight:
      return Mix(ink.fill, kWhite, 0.28);
    case Tone::kPale:
      return Mix(ink.fill, kWhite, 0.78);
    case Tone::kDark:
      return Mix(ink.fill, ink.line, 0.16);
    case Tone::kDeep:
      return Mix(ink.fill, ink.line, 0.62);
    case Tone::kHard:
      return ink.hard;
    case Tone::kSoft:
      return ink.soft;
    case Tone::kWater:
      return Hex(0xDCEBF0);
    case Tone::kGlass:
      return Hex(0xE8EFF1);
    case Tone::kLeaf:
      return Mix(Hex(0xA9C29A), ink.fill, 0.15);
    case Tone::kWood:
      return Hex(0xD9C3A3);
    case Tone::kMetal:
      return Hex(0xD3D5D6);
    case Tone::kFire:
      return Hex(0xE9A36B);
  }
  return ink.fill;
}

// Fills and strokes the path with the tone and the line at these arguments.
int Paint(lua_State* state, Tone tone, int line_argument, Line usual) {
  constexpr double kOutlineMm = 0.30, kDetailMm = 0.16, kFaintMm = 0.11;
  const auto line = static_cast<Line>(ChoiceAt(state, line_argument, kLines, static_cast<int>(usual)));
  const auto& [canvas, ink] = SessionOf<Pen>(state);
  if (tone != Tone::kNone) canvas.Fill(ColourOf(tone, ink), 1, line != Line::kNone);
  const double width_mm = line == Line::kOutline ? kOutlineMm : line == Line::kFaint ? kFaintMm : kDetailMm;
  const double alpha = line == Line::kFaint ? 0.55 : line == Line::kDetail ? 0.8 : 1;
  if (line != Line::kNone) {
    canvas.Draw({ink.line, width_mm, alpha, line == Line::kDashed ? Dash::kDashed : Dash::kSolid});
  }
  canvas.Discard();
  return 0;
}

Tone ToneAt(lua_State* state, int argument) { return static_cast<Tone>(ChoiceAt(state, argument, kTones, -1)); }

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
  return Paint(s, Tone::kNone, 3, Line::kDetail);
}

int DrawCurve(lua_State* s) {
  CanvasOf(s).MoveTo(PointAt(s, 1));
  CanvasOf(s).CurveTo(PointAt(s, 2), PointAt(s, 3), PointAt(s, 4));
  return Paint(s, Tone::kNone, 5, Line::kDetail);
}

Script& Symbols() {
  static constexpr luaL_Reg kFunctions[] = {{"area", DrawArea},       {"oval", DrawOval},   {"shape", DrawShape},
                                            {"segment", DrawSegment}, {"curve", DrawCurve}, {nullptr, nullptr}};
  static Script& symbols = *new Script(kFunctions);
  return symbols;
}

}  // namespace

absl::Status DrawSymbol(Canvas& canvas, const Ink& ink, double width_m, double depth_m, std::string_view name) {
  Pen pen{canvas, ink};
  const PieceSize size{width_m, depth_m, 0, 0};
  const absl::Status drawn = Symbols().Run("plan", name, size, &pen);
  if (drawn.ok()) return drawn;
  canvas.Discard();
  Symbols().Run("plan", "plain_box", size, &pen).IgnoreError();
  return drawn;
}

bool HasSymbol(std::string_view name) { return Symbols().Has("plan", name); }

}  // namespace flair::renderer
