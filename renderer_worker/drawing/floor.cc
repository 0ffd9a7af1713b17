// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer_worker/drawing/layers.h"

namespace flair::renderer {
namespace {

void TraceFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  std::vector<Point> outline;
  for (Point vertex : plan.floor) outline.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(outline);
}

// In [0, 1), the same for the same numbers.
double Chance(int a, int b) {
  uint32_t x = static_cast<uint32_t>(a) * 0x9E3779B9U + static_cast<uint32_t>(b) * 0x85EBCA6BU;
  x = (x ^ (x >> 15)) * 0x2C1B3C6DU;
  return static_cast<double>((x ^ (x >> 13)) >> 8) / 16777216.0;
}

// What a floor is laid of, in a frame whose u runs along the longer side of the room; pieces are never so small that
// the room would have more than a hundred of them in a row.
class Flooring {
 public:
  Flooring(Canvas& canvas, const Plan& plan, const Sheet& sheet)
      : canvas_(canvas),
        sheet_(sheet),
        box_(plan.bounds_m),
        wide_(box_.width() >= box_.height()),
        along_(std::max(box_.width(), box_.height())),
        across_(std::min(box_.width(), box_.height())),
        size_(std::max<double>(plan.floor_look.pattern_size_m, along_ / 100)),
        joint_{LineColourFor(plan.floor_tint), 0.09, 0.26} {}

  void Draw(Pattern pattern) {
    switch (pattern) {
      case Pattern::kWood:
      case Pattern::kPlanks:
        return Courses(size_, 12 * size_, 0.3, [](int course) { return course * 5 % 8 / 8.0; });
      case Pattern::kTiles:
        return Courses(size_, size_, 0, [](int) { return 0.0; });
      case Pattern::kBricks:
        return Courses(size_ / 2, size_, 0.15, [](int course) { return course % 2 / 2.0; });
      case Pattern::kStone:
        return Courses(size_, 1.6 * size_, 0.2, [](int course) { return Chance(course, 7); });
      case Pattern::kHerringbone:
        return Herringbone(size_, 5);
      case Pattern::kCarpet:
        return Pile(std::max(0.11, along_ / 60));
      default:
        return;  // plain: nothing that would compete with the furniture
    }
  }

 private:
  Point At(double u, double v) const {
    return sheet_.ToSheet(wide_ ? Point{box_.x0 + u, box_.y0 + v} : Point{box_.x0 + v, box_.y0 + u});
  }

  void Piece(double u0, double v0, double u1, double v1) {
    const Point corners[] = {At(u0, v0), At(u1, v0), At(u1, v1), At(u0, v1)};
    canvas_.Polygon(corners);
  }

  // Rows across the room, cut into pieces; the cuts of each row are moved by a share of a piece. A share of them is
  // darker.
  template <typename Shift>
  void Courses(double width, double length, double darker, const Shift& shift) {
    const auto each = [&](const auto& visit) {
      for (int course = 0; course * width < across_; ++course) {
        int piece = 0;
        for (double u = (shift(course) - 1) * length; u < along_; u += length, ++piece) visit(course, piece, u);
      }
    };
    each([&](int course, int piece, double u) {
      if (Chance(course, piece) < darker) {
        Piece(std::max(u, 0.0), course * width, std::min(u + length, along_), std::min((course + 1) * width, across_));
      }
    });
    canvas_.Fill(joint_.colour, 0.03);
    for (int course = 1; course * width < across_; ++course)
      canvas_.Line(At(0, course * width), At(along_, course * width));
    each([&](int course, int, double u) {
      if (u > 0) canvas_.Line(At(u, course * width), At(u, std::min((course + 1) * width, across_)));
    });
    canvas_.Draw(joint_);
  }

  // Staves `count` times as long as wide, laid to and fro at 45 degrees: in row k those that lie begin at k + 2 count
  // m.
  void Herringbone(double stave, int count) {
    const double turn = std::sqrt(0.5) * stave;
    const auto at = [&](int x, int y) { return At((x - y) * turn, (x + y) * turn); };
    const int rows = static_cast<int>((along_ + across_) / (2 * turn)) + 2 * count;
    const auto each = [&](bool lying) {
      for (int k = -rows; k < rows; ++k) {
        for (int m = -rows / count; m <= rows / count; ++m) {
          const int start = k + (2 * m - (lying ? 0 : 2)) * count + (lying ? 0 : 1), end = start + count;
          const Point corners[] = {lying ? at(start, k) : at(k, start), lying ? at(end, k) : at(k, end),
                                   lying ? at(end, k + 1) : at(k + 1, end),
                                   lying ? at(start, k + 1) : at(k + 1, start)};
          const Box box = BoundsOf(std::vector<Point>(std::begin(corners), std::end(corners)));
          if (box.Overlaps(sheet_.plan_mm)) canvas_.Polygon(corners);
        }
      }
    };
    each(true);
    canvas_.Fill(joint_.colour, 0.025, true);
    canvas_.Draw(joint_);
    each(false);
    canvas_.Draw(joint_);
  }

  // Short strokes this way and that.
  void Pile(double spacing) {
    for (int i = 0; i * spacing < along_; ++i) {
      for (int k = 0; k * spacing < across_; ++k) {
        const double u = (i + Chance(i, k)) * spacing, v = (k + Chance(k, i + 500)) * spacing,
                     turn = 6.3 * Chance(i, ~k);
        canvas_.Line(At(u, v), At(u + 0.2 * spacing * std::cos(turn), v + 0.2 * spacing * std::sin(turn)));
      }
    }
    canvas_.Draw({joint_.colour, 0.14, 0.3});
  }

  Canvas& canvas_;
  const Sheet& sheet_;
  Box box_;
  bool wide_;
  double along_, across_;
  double size_;
  Stroke joint_;
};

}  // namespace

void DrawFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  TraceFloor(canvas, plan, sheet);
  canvas.Fill(plan.floor_tint);
  TraceFloor(canvas, plan, sheet);
  canvas.Clip();
  Flooring(canvas, plan, sheet).Draw(plan.floor_look.pattern);
  canvas.Unclip();
}

void DrawZones(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  TraceFloor(canvas, plan, sheet);
  canvas.Clip();
  for (const PlanZone& zone : plan.zones) {
    for (const std::vector<Point>& part : zone.parts) {
      std::vector<Point> outline;
      for (Point vertex : part) outline.push_back(sheet.ToSheet(vertex));
      canvas.Polygon(outline);
      canvas.Fill(zone.tint, 0.045, true);
      if (plan.zones.size() > 1) {
        canvas.Draw({LineColourFor(zone.tint), 0.15, 0.5, Dash::kDashed});
      } else {
        canvas.Discard();
      }
    }
  }
  canvas.Unclip();
}

}  // namespace flair::renderer
