// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer_worker/drawing/symbols/symbol.h"

namespace flair::renderer {
namespace {

using std::numbers::pi;

void DrawSofa(SymbolPen& pen) {
  const double arm = std::min(0.2, 0.12 * pen.width());
  const double rest = std::min(0.22, 0.26 * pen.depth());
  pen.Area(pen.whole(), Tone::kDark, Line::kOutline, 0.08);
  const double seat_left = pen.left() + arm, seat_right = pen.right() - arm;
  const int cushions = std::max(1, static_cast<int>(std::lround((seat_right - seat_left) / 0.68)));
  const double pitch = (seat_right - seat_left) / cushions;
  for (int i = 0; i < cushions; ++i) {
    const double x0 = seat_left + i * pitch, x1 = x0 + pitch;
    pen.Area({x0, pen.back() + rest, x1, pen.front() - 0.015}, Tone::kLight, Line::kDetail, 0.06);
    pen.Area({x0 + 0.015, pen.back() + 0.45 * rest, x1 - 0.015, pen.back() + rest + 0.08}, Tone::kBody, Line::kDetail,
             0.05);
  }
  pen.Area({pen.left(), pen.back() + 0.3 * rest, seat_left, pen.front()}, Tone::kBody, Line::kDetail, 0.07);
  pen.Area({seat_right, pen.back() + 0.3 * rest, pen.right(), pen.front()}, Tone::kBody, Line::kDetail, 0.07);
}

void DrawArmchair(SymbolPen& pen) {
  const double arm = std::min(0.15, 0.17 * pen.width());
  const double rest = std::min(0.2, 0.24 * pen.depth());
  pen.Area(pen.whole(), Tone::kDark, Line::kOutline, 0.14);
  pen.Area({pen.left() + arm, pen.back() + rest, pen.right() - arm, pen.front() - 0.015}, Tone::kLight, Line::kDetail,
           0.08);
  pen.Area({pen.left(), pen.back() + 0.5 * rest, pen.left() + arm, pen.front() - 0.02}, Tone::kBody, Line::kDetail,
           0.07);
  pen.Area({pen.right() - arm, pen.back() + 0.5 * rest, pen.right(), pen.front() - 0.02}, Tone::kBody, Line::kDetail,
           0.07);
  pen.Area({pen.left() + 0.7 * arm, pen.back() + 0.3 * rest, pen.right() - 0.7 * arm, pen.back() + 1.25 * rest},
           Tone::kBody, Line::kDetail, 0.07);
}

void DrawChair(SymbolPen& pen) {
  const double rest = std::min(0.08, 0.17 * pen.depth());
  const double taper = 0.06 * pen.width();
  const Point seat[] = {{pen.left() + taper, pen.back() + 0.4 * rest},
                        {pen.right() - taper, pen.back() + 0.4 * rest},
                        {pen.right() - 0.2 * taper, pen.front()},
                        {pen.left() + 0.2 * taper, pen.front()}};
  pen.Shape(seat, Tone::kLight);
  const double inset = 0.1 * pen.smaller();
  pen.Area({pen.left() + 1.4 * inset, pen.back() + rest + inset, pen.right() - 1.4 * inset, pen.front() - inset},
           Tone::kBody, Line::kFaint, 0.05);
  pen.Area({pen.left(), pen.back(), pen.right(), pen.back() + rest}, Tone::kDark, Line::kOutline, 0.5 * rest);
}

void DrawOfficeChair(SymbolPen& pen) {
  // The five-star base, the seat, the curved back and two arm rests.
  const double r = pen.smaller() / 2;
  for (int i = 0; i < 5; ++i) {
    const double angle = pi / 2 + 2 * pi * i / 5;
    const Point end{0.9 * r * std::cos(angle), 0.9 * r * std::sin(angle)};
    pen.Segment({0, 0}, end, Line::kOutline);
    pen.Circle(end, 0.1 * r, Tone::kDeep, Line::kNone);
  }
  pen.Area({-0.72 * r, -0.66 * r, 0.72 * r, 0.74 * r}, Tone::kLight, Line::kOutline, 0.3 * r);
  pen.Area({-0.98 * r, -0.4 * r, -0.76 * r, 0.36 * r}, Tone::kDark, Line::kDetail, 0.1 * r);
  pen.Area({0.76 * r, -0.4 * r, 0.98 * r, 0.36 * r}, Tone::kDark, Line::kDetail, 0.1 * r);
  pen.Area({-0.78 * r, -1.0 * r, 0.78 * r, -0.68 * r}, Tone::kBody, Line::kOutline, 0.16 * r);
}

void DrawRockingChair(SymbolPen& pen) {
  const double runner = 0.1 * pen.width();
  pen.Area({pen.left(), pen.back(), pen.left() + runner, pen.front()}, Tone::kDark, Line::kDetail, 0.5 * runner);
  pen.Area({pen.right() - runner, pen.back(), pen.right(), pen.front()}, Tone::kDark, Line::kDetail, 0.5 * runner);
  const double y0 = pen.back() + 0.12 * pen.depth(), y1 = pen.front() - 0.14 * pen.depth();
  pen.Area({pen.left() + 0.5 * runner, y0, pen.right() - 0.5 * runner, y1}, Tone::kLight, Line::kOutline, 0.08);
  const double rest = 0.13 * pen.depth();
  pen.Area({pen.left() + 0.5 * runner, y0, pen.right() - 0.5 * runner, y0 + rest}, Tone::kBody, Line::kOutline, 0.04);
  for (int i = 1; i < 6; ++i) {
    const double x = pen.left() + pen.width() * i / 6;
    pen.Segment({x, y0}, {x, y0 + rest}, Line::kFaint);
  }
}

void DrawStool(SymbolPen& pen) {
  pen.Oval({0, 0}, pen.width() / 2, pen.depth() / 2, Tone::kBody, Line::kOutline);
  pen.Oval({0, 0}, 0.36 * pen.width(), 0.36 * pen.depth(), Tone::kLight, Line::kDetail);
}

void DrawBench(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.03);
  pen.Area(pen.whole().Grown(-0.1 * pen.smaller()), Tone::kLight, Line::kDetail, 0.04);
  const int slots = std::max(2, static_cast<int>(pen.width() / 0.4));
  for (int i = 1; i < slots; ++i) {
    const double x = pen.left() + pen.width() * i / slots;
    pen.Circle({x, 0}, 0.018, Tone::kDark, Line::kFaint);
  }
}

void DrawPouf(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.32 * pen.smaller());
  pen.Area(pen.whole().Grown(-0.09 * pen.smaller()), Tone::kLight, Line::kFaint, 0.28 * pen.smaller());
  for (Point end : {Point{1, 1}, Point{-1, 1}, Point{1, -1}, Point{-1, -1}}) {
    pen.Segment({0.04 * end.x, 0.04 * end.y}, {0.3 * pen.width() * end.x, 0.3 * pen.depth() * end.y}, Line::kFaint);
  }
  pen.Circle({0, 0}, 0.03, Tone::kDark);
}

void DrawThrone(SymbolPen& pen) {
  const double rest = 0.2 * pen.depth(), arm = 0.17 * pen.width();
  pen.Area({pen.left(), pen.back() + 0.5 * rest, pen.right(), pen.front()}, Tone::kDark, Line::kOutline, 0.03);
  // A back with three points, seen from above as a crown.
  const double y0 = pen.back(), y1 = pen.back() + rest;
  const Point crown[] = {
      {pen.left(), y1},      {pen.left(), y0},         {0.6 * pen.left(), y0 + 0.5 * rest},  {0.28 * pen.left(), y0},
      {0, y0 + 0.45 * rest}, {0.28 * pen.right(), y0}, {0.6 * pen.right(), y0 + 0.5 * rest}, {pen.right(), y0},
      {pen.right(), y1}};
  pen.Shape(crown, Tone::kBody);
  pen.Area({pen.left() + arm, y1, pen.right() - arm, pen.front() - 0.02}, Tone::kLight, Line::kDetail, 0.05);
  for (double side : {pen.left() + arm / 2, pen.right() - arm / 2}) {
    pen.Circle({side, pen.front() - 0.55 * arm}, 0.36 * arm, Tone::kBody);
    pen.Circle({side, y1 + 0.5 * arm}, 0.2 * arm, Tone::kBody);
  }
  pen.Circle({0, y1 + 0.5 * (pen.front() - y1)}, 0.09 * pen.smaller(), Tone::kBody);
}

// Pillows side by side behind `y1`, each at most 0.8 m wide; one for a single bed.
void DrawPillows(SymbolPen& pen, double x0, double x1, double y0, double y1) {
  const int count = x1 - x0 >= 1.15 ? 2 : 1;
  const double pitch = (x1 - x0) / count;
  for (int i = 0; i < count; ++i) {
    const double gap = std::min(0.07, 0.1 * pitch);
    const Box pillow{x0 + i * pitch + gap, y0, x0 + (i + 1) * pitch - gap, y1};
    pen.Area(pillow, Tone::kPale, Line::kDetail, 0.09);
    const double inset = 0.045;
    pen.Curve({pillow.x0 + inset, pillow.y1 - inset}, {pillow.x0 + 2 * inset, pillow.y1 - 1.9 * inset},
              {pillow.x1 - 2 * inset, pillow.y1 - 1.9 * inset}, {pillow.x1 - inset, pillow.y1 - inset}, Line::kFaint);
  }
}

void DrawBed(SymbolPen& pen) {
  const double board = std::min(0.07, 0.06 * pen.depth());
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.03);
  pen.Area({pen.left(), pen.back(), pen.right(), pen.back() + board}, Tone::kDark, Line::kDetail, 0.02);
  const double head = pen.back() + board;
  const double margin = std::min(0.05, 0.04 * pen.width());
  const double pillow_front = head + std::min(0.45, 0.22 * pen.depth());
  DrawPillows(pen, pen.left() + margin, pen.right() - margin, head + 0.04, pillow_front);
  // The duvet, its upper edge turned back, one corner folded open.
  const double fold = pillow_front + 0.06;
  const double turned = fold + std::min(0.24, 0.12 * pen.depth());
  const Box duvet{pen.left() + 0.4 * margin, fold, pen.right() - 0.4 * margin, pen.front() - 0.02};
  pen.Area(duvet, Tone::kBody, Line::kDetail, 0.05);
  pen.Area({duvet.x0, fold, duvet.x1, turned}, Tone::kLight, Line::kDetail, 0.03);
  const double corner = std::min(0.42, 0.3 * pen.width());
  const Point flap[] = {{duvet.x1, turned}, {duvet.x1, turned + corner}, {duvet.x1 - corner, turned}};
  pen.Shape(flap, Tone::kPale, Line::kDetail);
  for (int i = 1; i < 3; ++i) {
    const double y = turned + (duvet.y1 - turned) * (0.28 + 0.27 * i);
    pen.Curve({duvet.x0 + 0.08, y}, {duvet.x0 + 0.3 * duvet.width(), y + 0.05},
              {duvet.x1 - 0.4 * duvet.width(), y - 0.05}, {duvet.x1 - 0.1, y + 0.02}, Line::kFaint);
  }
}

void DrawBunkBed(SymbolPen& pen) {
  DrawBed(pen);
  // The ladder of the upper bunk on the right side.
  const double x0 = pen.right() - std::min(0.16, 0.18 * pen.width());
  const double y0 = pen.front() - std::min(0.62, 0.36 * pen.depth());
  const double y1 = pen.front() - std::min(0.2, 0.1 * pen.depth());
  pen.Area({x0, y0, pen.right(), y1}, Tone::kWood, Line::kDetail);
  for (int i = 1; i < 4; ++i) pen.Segment({x0, y0 + (y1 - y0) * i / 4}, {pen.right(), y0 + (y1 - y0) * i / 4});
  pen.Area({pen.left() + 0.03, pen.back() + 0.03, pen.right() - 0.03, pen.front() - 0.03}, Tone::kNone, Line::kDashed,
           0.02);
}

void DrawCot(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kWood, Line::kOutline, 0.03);
  const double rail = std::min(0.055, 0.09 * pen.width());
  const Box mattress = pen.whole().Grown(-rail);
  pen.Area(mattress, Tone::kPale, Line::kDetail, 0.02);
  const int bars = std::max(3, static_cast<int>(pen.depth() / 0.11));
  for (int i = 1; i < bars; ++i) {
    const double y = pen.back() + pen.depth() * i / bars;
    pen.Segment({pen.left(), y}, {mattress.x0, y});
    pen.Segment({mattress.x1, y}, {pen.right(), y});
  }
  const double head = mattress.y0 + 0.05;
  const double middle = 0.3 * mattress.width();
  pen.Area({-middle, head, middle, head + std::min(0.2, 0.2 * pen.depth())}, Tone::kLight, Line::kDetail, 0.06);
  pen.Area({mattress.x0 + 0.02, mattress.y0 + 0.42 * mattress.height(), mattress.x1 - 0.02, mattress.y1 - 0.02},
           Tone::kBody, Line::kDetail, 0.03);
}

void DrawCoffin(SymbolPen& pen) {
  const auto outline = [&pen](double inset) {
    const double w = pen.width() / 2 - inset, y0 = pen.back() + inset, y1 = pen.front() - inset;
    const double shoulder = y0 + 0.3 * (y1 - y0);
    return std::vector<Point>{{-0.58 * w, y0}, {0.58 * w, y0}, {w, shoulder},
                              {0.5 * w, y1},   {-0.5 * w, y1}, {-w, shoulder}};
  };
  pen.Shape(outline(0), Tone::kBody);
  pen.Shape(outline(std::min(0.05, 0.07 * pen.width())), Tone::kLight, Line::kDetail);
  pen.Shape(outline(std::min(0.09, 0.13 * pen.width())), Tone::kBody, Line::kFaint);
  // A cross on the lid, head end at the back.
  const double arm = 0.17 * pen.width(), bar = 0.05 * pen.width();
  const double top = pen.back() + 0.16 * pen.depth(), foot = pen.back() + 0.6 * pen.depth();
  const double y = top + 0.3 * (foot - top);
  const Point cross[] = {{-bar, top}, {bar, top},   {bar, y - bar},  {arm, y - bar},  {arm, y + bar},  {bar, y + bar},
                         {bar, foot}, {-bar, foot}, {-bar, y + bar}, {-arm, y + bar}, {-arm, y - bar}, {-bar, y - bar}};
  pen.Shape(cross, Tone::kDeep, Line::kDetail);
}

void DrawDaybed(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.05);
  const double frame = std::min(0.08, 0.1 * pen.depth());
  const Box mattress{pen.left() + frame, pen.back() + frame, pen.right() - frame, pen.front()};
  pen.Area(mattress, Tone::kLight, Line::kDetail, 0.05);
  const double cushion = std::min(0.42, 0.25 * pen.width());
  for (double x : {mattress.x0 + 0.03, mattress.x1 - 0.03 - cushion}) {
    pen.Area({x, mattress.y0 + 0.03, x + cushion, mattress.y0 + 0.03 + 0.45 * cushion}, Tone::kPale, Line::kDetail,
             0.07);
  }
  pen.Segment({mattress.x0 + 0.04, mattress.y1 - 0.07}, {mattress.x1 - 0.04, mattress.y1 - 0.07}, Line::kFaint);
}

}  // namespace

std::span<const Symbol> SeatAndBedSymbols() {
  static constexpr Symbol kSymbols[] = {{"sofa", DrawSofa},
                                        {"armchair", DrawArmchair},
                                        {"chair", DrawChair},
                                        {"office_chair", DrawOfficeChair},
                                        {"rocking_chair", DrawRockingChair},
                                        {"stool", DrawStool},
                                        {"bench", DrawBench},
                                        {"pouf", DrawPouf},
                                        {"throne", DrawThrone},
                                        {"bed", DrawBed},
                                        {"bunk_bed", DrawBunkBed},
                                        {"cot", DrawCot},
                                        {"coffin", DrawCoffin},
                                        {"daybed", DrawDaybed}};
  return kSymbols;
}

}  // namespace flair::renderer
