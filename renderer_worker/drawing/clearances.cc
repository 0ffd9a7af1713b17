// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/clearances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kLeastM = 0.35, kMostM = 2.5;
constexpr double kLeastPieceM2 = 0.4;  // smaller ones are moved aside rather than walked round
constexpr double kSameFloorM = 0.7;
constexpr size_t kMost = 8;
constexpr size_t kMostPieces = 300;  // of a room in which single distances still say something
constexpr double kLeastMm = 10;
const Rgb kClearanceInk = Hex(0x2F6675);

bool IsSolid(const PlanObject& object) { return object.kind == v1::OBJECT_KIND_FLOOR && !object.walk_over; }

// Distance along the ray to the segment; infinite when it is missed or starts behind.
double HitM(Point from, Point direction, Point a, Point b) {
  const Point edge = b - a;
  const double across = Cross(direction, edge);
  if (std::abs(across) < 1e-12) return std::numeric_limits<double>::infinity();
  const double along = Cross(a - from, edge) / across, share = Cross(a - from, direction) / across;
  return along > 1e-6 && share >= 0 && share <= 1 ? along : std::numeric_limits<double>::infinity();
}

double HitOutlineM(Point from, Point direction, const std::vector<Point>& outline) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < outline.size(); ++i)
    nearest = std::min(nearest, HitM(from, direction, outline[i], outline[(i + 1) % outline.size()]));
  return nearest;
}

Clearance Ahead(const Plan& plan, const PlanObject& object) {
  const std::vector<Point> corners = object.Corners();
  const Point from = (corners[2] + corners[3]) * 0.5,
              direction{-std::sin(object.theta_rad), std::cos(object.theta_rad)};
  if (!PolygonContains(plan.floor, from + direction * 1e-4)) return {};
  double length = HitOutlineM(from, direction, plan.floor);
  for (const PlanObject& other : plan.objects) {
    if (&other == &object || !IsSolid(other)) continue;
    const std::vector<Point> outline = other.Corners();
    if (PolygonContains(outline, from + direction * 1e-4)) return {};
    length = std::min(length, HitOutlineM(from, direction, outline));
  }
  return {from, from + direction * length, length};
}

bool SameFloor(const Clearance& a, const Clearance& b) {
  const Point ua = (a.to_m - a.from_m) * (1 / a.length_m), ub = (b.to_m - b.from_m) * (1 / b.length_m);
  if (std::abs(Dot(ua, ub)) < 0.9) {
    // Crossing ones would write over each other.
    const double hit = HitM(a.from_m, ua, b.from_m, b.to_m);
    return hit <= a.length_m;
  }
  const Point between = (b.from_m + b.to_m) * 0.5 - (a.from_m + a.to_m) * 0.5;
  return std::abs(Cross(ua, between)) < kSameFloorM && std::abs(Dot(ua, between)) < (a.length_m + b.length_m) / 2;
}

TextBlock NumberOf(const Clearance& clearance) {
  return {fmt::format("{:.2f}", clearance.length_m), {.size_mm = 2.8, .colour = kClearanceInk}};
}

}  // namespace

std::vector<Clearance> FindClearances(const Plan& plan) {
  std::vector<Clearance> found;
  if (!plan.layers.dimensions || plan.objects.size() > kMostPieces) return found;
  std::vector<const PlanObject*> pieces;
  for (const PlanObject& object : plan.objects) {
    if (IsSolid(object) && object.width_m * object.depth_m >= kLeastPieceM2) pieces.push_back(&object);
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const PlanObject* a, const PlanObject* b) {
    return a->width_m * a->depth_m > b->width_m * b->depth_m;
  });
  for (const PlanObject* piece : pieces) {
    const Clearance clearance = Ahead(plan, *piece);
    if (!(clearance.length_m >= kLeastM && clearance.length_m <= kMostM)) continue;
    if (std::any_of(found.begin(), found.end(), [&](const Clearance& other) { return SameFloor(clearance, other); }))
      continue;
    found.push_back(clearance);
    if (found.size() == kMost) break;
  }
  return found;
}

std::vector<Clearance> ShownClearances(const Plan& plan, const Sheet& sheet) {
  std::vector<Clearance> clearances = FindClearances(plan);
  std::erase_if(clearances, [&](const Clearance& c) { return c.length_m * sheet.mm_per_m() < kLeastMm; });
  return clearances;
}

Box ClearanceTextBox(const Canvas& canvas, const Sheet& sheet, const Clearance& clearance) {
  const Size size = Measure(canvas, NumberOf(clearance));
  const Point middle = (sheet.ToSheet(clearance.from_m) + sheet.ToSheet(clearance.to_m)) * 0.5;
  return BoxAround(middle, {size.width + 1.2, size.height * 0.8});
}

void DrawClearances(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const Clearance& clearance : ShownClearances(plan, sheet)) {
    const Point from = sheet.ToSheet(clearance.from_m), to = sheet.ToSheet(clearance.to_m);
    const Point along = (to - from) * (1 / std::hypot(to.x - from.x, to.y - from.y)), across{-along.y, along.x};
    canvas.Line(from, to);
    canvas.Draw({kClearanceInk, 0.13});
    for (const auto& [tip, back] : {std::pair{from, along}, {to, along * -1}}) {
      const Point head[] = {tip, tip + back * 1.9 + across * 0.45, tip + back * 1.9 - across * 0.45};
      canvas.Polygon(head);
      canvas.Fill(kClearanceInk);
    }
    const Box box = ClearanceTextBox(canvas, sheet, clearance);
    canvas.Rectangle(box, 1);
    canvas.Fill(Hex(0xFFFFFF), 0.85);
    DrawTextAt(canvas, NumberOf(clearance), box.centre());
  }
}

}  // namespace flair::renderer
