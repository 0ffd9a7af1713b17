// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kBandM = 0.6;
const Rgb kBand = Hex(0x3E8E9E);
const Rgb kBlocked = Hex(0xB3372C);

}  // namespace

void DrawRoutes(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  if (plan.routes_m.empty()) return;
  std::vector<Point> floor;
  for (Point vertex : plan.floor) floor.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(floor);
  canvas.Clip();
  // One path, so that ways that share the floor do not darken it.
  for (const std::vector<Point>& route : plan.routes_m) {
    canvas.MoveTo(sheet.ToSheet(route.front()));
    for (size_t i = 1; i < route.size(); ++i) canvas.LineTo(sheet.ToSheet(route[i]));
  }
  canvas.Draw({kBand, kBandM * sheet.mm_per_m(), 0.26, Dash::kSolid, true}, true);
  canvas.Draw({LineColourFor(kBand), 0.22, 0.9, Dash::kDashed});
  for (const std::vector<Point>& route : plan.routes_m) {
    canvas.Ellipse(sheet.ToSheet(route.back()), 0.75, 0.75);
    canvas.Fill(LineColourFor(kBand));
  }
  canvas.Unclip();
}

void DrawBlocked(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (!object.blocked) continue;
    std::vector<Point> corners;
    for (Point corner : object.Corners()) corners.push_back(sheet.ToSheet(corner));
    const Box box = BoundsOf(corners);
    canvas.Polygon(corners);
    canvas.Clip();
    constexpr double kPitchMm = 2.2;
    const double height = box.height();
    // At 45 degrees, in step over the whole sheet, so that neighbours look alike.
    const double first = std::floor((box.x0 + box.y0) / kPitchMm) * kPitchMm;
    for (double sum = first; sum < box.x1 + box.y1; sum += kPitchMm)
      canvas.Line({sum - box.y0, box.y0}, {sum - box.y0 - height, box.y1});
    canvas.Draw({kBlocked, 0.3, 0.75});
    canvas.Unclip();
    canvas.Polygon(corners);
    canvas.Draw({kBlocked, 0.5});
  }
}

void DrawRouteSign(Canvas& canvas, const Box& box, bool blocked) {
  const double y = box.centre().y;
  if (!blocked) {
    canvas.Line({box.x0 + 1, y}, {box.x1 - 1, y});
    canvas.Draw({kBand, box.height(), 0.26}, true);
    canvas.Draw({LineColourFor(kBand), 0.22, 0.9, Dash::kDashed});
    return;
  }
  canvas.Rectangle(box);
  canvas.Clip();
  for (double x = box.x0; x < box.x1 + box.height(); x += 1.4) canvas.Line({x, box.y0}, {x - box.height(), box.y1});
  canvas.Draw({kBlocked, 0.3, 0.75});
  canvas.Unclip();
  canvas.Rectangle(box);
  canvas.Draw({kBlocked, 0.4});
}

namespace {

// A line of the overlay, bent aside when others join the same two places.
struct Bow {
  Point from, to, bend;
  Point Middle() const { return (from + to) * 0.25 + bend * 0.5; }
};

// Where the bows of the edges lie; edges between the same places fan out.
class Fan {
 public:
  Bow Next(Point from, Point to) {
    const auto round = [](Point p) { return std::pair{std::lround(4 * p.x), std::lround(4 * p.y)}; };
    const bool swapped = round(to) < round(from);
    const int index = count_[swapped ? std::pair{round(to), round(from)} : std::pair{round(from), round(to)}]++;
    const Point along = to - from;
    const double length = std::max(std::hypot(along.x, along.y), 1e-9);
    // 0, 1, -1, 2, -2 ... steps aside.
    const double steps = (index + 1) / 2 * (index % 2 == 1 ? 1 : -1) * (swapped ? -1 : 1);
    const Point aside = Point{-along.y, along.x} * (1 / length) * (3.4 * steps);
    return {from, to, (from + to) * 0.5 + aside};
  }

 private:
  using Place = std::pair<long, long>;
  std::map<std::pair<Place, Place>, int> count_;
};

void TraceBow(Canvas& canvas, const Bow& bow) {
  canvas.MoveTo(bow.from);
  canvas.CurveTo(bow.from * (1 / 3.0) + bow.bend * (2 / 3.0), bow.to * (1 / 3.0) + bow.bend * (2 / 3.0), bow.to);
}

// What holds is a faint net behind what does not: only that is cut free of what lies below it.
void DrawEdge(Canvas& canvas, const PlanEdge& edge, const std::vector<Bow>& bows, Point first) {
  const Stroke stroke = VerdictStroke(edge.status);
  const bool violated = edge.status == v1::OUTCOME_STATUS_VIOLATED;
  for (const Bow& bow : bows) {
    TraceBow(canvas, bow);
    if (violated) canvas.Draw({kWhite, stroke.width_mm + 0.5, 0.75}, true);
    canvas.Draw(stroke);
    canvas.Ellipse(bow.to, violated ? 0.6 : 0.45, violated ? 0.6 : 0.45);
    canvas.Fill(stroke.colour, stroke.alpha);
  }
  // About one thing alone: a ring.
  canvas.Ellipse(first, bows.empty() ? 1.6 : 0.9, bows.empty() ? 1.6 : 0.9);
  if (violated) canvas.Draw({kWhite, stroke.width_mm + 0.5, 0.75}, true);
  canvas.Draw({stroke.colour, stroke.width_mm, stroke.alpha});
}

}  // namespace

Stroke VerdictStroke(v1::OutcomeStatus status) {
  switch (status) {
    case v1::OUTCOME_STATUS_SATISFIED:
      return {Hex(0x74B48B), 0.25};
    case v1::OUTCOME_STATUS_VIOLATED:
      return {Hex(0xC62F26), 0.55};
    default:
      return {Hex(0xA19D97), 0.25, 1, Dash::kDashed};
  }
}

std::string ViolationLetters(int index) {
  std::string letters;
  for (; index >= 0; index = index / 26 - 1) letters.insert(letters.begin(), static_cast<char>('A' + index % 26));
  return letters;
}

void DrawViolationBadge(Canvas& canvas, int index, Point centre_mm) {
  const std::string letters = ViolationLetters(index);
  canvas.Rectangle(BoxAround(centre_mm, {3.0 + 1.4 * static_cast<double>(letters.size()), 4.2}), 0.8);
  canvas.Fill(VerdictStroke(v1::OUTCOME_STATUS_VIOLATED).colour, 1, true);
  canvas.Draw({kWhite, 0.3});
  DrawTextAt(canvas, {letters, {.size_mm = 2.9, .colour = kWhite, .bold = true}}, centre_mm);
}

void DrawConstraints(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  // What is drawn so far steps back.
  std::vector<Point> floor;
  for (Point vertex : plan.floor) floor.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(floor);
  canvas.Fill(kWhite, 0.5);
  Fan fan;
  std::vector<std::vector<Bow>> bows;
  for (const PlanEdge& edge : plan.edges) {
    std::vector<Bow>& own = bows.emplace_back();
    for (size_t i = 1; i < edge.operands_m.size(); ++i)
      own.push_back(fan.Next(sheet.ToSheet(edge.operands_m[0]), sheet.ToSheet(edge.operands_m[i])));
  }
  for (const auto status : {v1::OUTCOME_STATUS_SATISFIED, v1::OUTCOME_STATUS_DROPPED, v1::OUTCOME_STATUS_VIOLATED}) {
    for (size_t i = 0; i < plan.edges.size(); ++i) {
      const PlanEdge& edge = plan.edges[i];
      if (edge.status == status && !edge.operands_m.empty())
        DrawEdge(canvas, edge, bows[i], sheet.ToSheet(edge.operands_m[0]));
    }
  }
  int violated = 0;
  for (size_t i = 0; i < plan.edges.size(); ++i) {
    const PlanEdge& edge = plan.edges[i];
    if (edge.status != v1::OUTCOME_STATUS_VIOLATED) continue;
    if (!edge.operands_m.empty())
      DrawViolationBadge(canvas, violated,
                         bows[i].empty() ? sheet.ToSheet(edge.operands_m[0]) + Point{0, -3.8} : bows[i][0].Middle());
    ++violated;
  }
}

}  // namespace flair::renderer
