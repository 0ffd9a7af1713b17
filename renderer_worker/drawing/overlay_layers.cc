// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "evaluation/metrics/walk_grid.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/text.h"
#include "room/conversion/conversion.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr double kBandM = 0.6;
const Rgb kBand = Hex(0x3E8E9E);
const Rgb kBlocked = Hex(0xB3372C);

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

double Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

Point FootOn(const PlanWall& wall, Point point) {
  return wall.start + wall.along * std::clamp(Dot(point - wall.start, wall.along), 0.0, wall.length_m);
}

// Finds the places that the arguments of a call speak of. What is neither object nor wall nor zone nor kind of feature
// (a side, a number) has none.
class Operands {
 public:
  Operands(const v1::SolvedLayout& layout, const Plan& plan) : layout_(layout), plan_(plan) {
    for (const v1::Placement& placement : layout.placements()) {
      if (std::isfinite(placement.x_m()) && std::isfinite(placement.y_m()))
        objects_[placement.object_id()] = {placement.x_m(), placement.y_m()};
    }
    for (int i = 0; i < layout.graph().room().walls_size() && i < static_cast<int>(plan.walls.size()); ++i)
      walls_[layout.graph().room().walls(i).name()] = i;
    for (const v1::ZoneRegion& region : layout.zone_regions()) {
      if (std::isfinite(region.center().x_m()) && std::isfinite(region.center().y_m()))
        zones_[region.zone_id()] = {region.center().x_m(), region.center().y_m()};
    }
  }

  std::vector<Point> Of(const v1::ConstraintEdge& edge) const {
    std::vector<std::string> words;
    for (const v1::Argument& argument : edge.arguments()) {
      if (argument.value().has_text()) words.push_back(argument.value().text());
      for (const std::string& text : argument.value().texts().items()) words.push_back(text);
    }
    std::vector<Point> found;
    for (const std::string& word : words) {
      if (const auto at = objects_.find(word); at != objects_.end()) found.push_back(at->second);
    }
    if (found.empty()) return found;
    const size_t object_count = found.size();
    for (const std::string& word : words) {
      if (const std::optional<Point> place = PlaceOf(word, found.front()); place.has_value()) found.push_back(*place);
    }
    // A call that speaks of walls without naming one means the nearest.
    const bool of_walls =
        edge.type().find("wall") != std::string::npos || edge.type().find("corner") != std::string::npos;
    if (object_count == 1 && found.size() == 1 && of_walls) found.push_back(NearestWall(found.front()));
    return found;
  }

 private:
  std::optional<Point> PlaceOf(const std::string& word, Point from) const {
    if (objects_.contains(word)) return std::nullopt;
    if (const auto at = walls_.find(word); at != walls_.end()) return FootOn(plan_.walls[at->second], from);
    if (const auto at = zones_.find(word); at != zones_.end()) return at->second;
    std::vector<Point> features;
    for (const PlanOpening& opening : plan_.openings) {
      if (word != (opening.door ? "door" : "window") && word != opening.id) continue;
      const PlanWall& wall = plan_.walls[opening.wall];
      features.push_back(wall.start + wall.along * (opening.offset_m + opening.width_m / 2));
    }
    if (word == "socket") {
      for (const PlanSocket& socket : plan_.sockets)
        features.push_back(plan_.walls[socket.wall].start + plan_.walls[socket.wall].along * socket.offset_m);
    }
    if (features.empty()) return std::nullopt;
    return *std::ranges::min_element(features,
                                     [from](Point a, Point b) { return Distance(a, from) < Distance(b, from); });
  }

  Point NearestWall(Point from) const {
    Point nearest = FootOn(plan_.walls.front(), from);
    for (const PlanWall& wall : plan_.walls) {
      if (const Point foot = FootOn(wall, from); Distance(foot, from) < Distance(nearest, from)) nearest = foot;
    }
    return nearest;
  }

  const v1::SolvedLayout& layout_;
  const Plan& plan_;
  std::map<std::string, Point> objects_;
  std::map<std::string, int> walls_;
  std::map<std::string, Point> zones_;
};

std::string MissOf(const v1::EdgeOutcome& outcome) {
  if (!outcome.has_missed_by() || !std::isfinite(outcome.missed_by())) return "";
  if (outcome.unit().empty()) return fmt::format("{:.0f} %", 100 * outcome.missed_by());
  if (outcome.unit() == "deg") return fmt::format("{:.0f}°", outcome.missed_by());
  return fmt::format("{:.2f} {}", outcome.missed_by(), outcome.unit() == "m2" ? "m²" : outcome.unit());
}

std::string WordsOf(const v1::ConstraintEdge& edge, const std::map<std::string, std::string>& sentences) {
  if (const auto at = sentences.find(edge.sentence_id()); at != sentences.end()) return at->second;
  std::string words = edge.type();
  for (const v1::Argument& argument : edge.arguments()) {
    if (argument.value().has_text()) words += " " + argument.value().text();
    for (const std::string& text : argument.value().texts().items()) words += " " + text;
  }
  std::ranges::replace(words, '_', ' ');
  return words;
}

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

void ReadEdges(const v1::SolvedLayout& layout, Plan& plan) {
  std::map<std::string, const v1::EdgeOutcome*> outcomes;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) outcomes[outcome.edge_id()] = &outcome;
  std::map<std::string, std::string> sentences;
  for (const v1::Sentence& sentence : layout.graph().constraint_list().sentences())
    sentences[sentence.id()] = sentence.text();
  const Operands operands(layout, plan);
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    const auto at = outcomes.find(edge.id());
    if (at == outcomes.end() || at->second->status() == v1::OUTCOME_STATUS_UNSPECIFIED) continue;
    plan.edges.push_back({at->second->status(), operands.Of(edge), WordsOf(edge, sentences), MissOf(*at->second)});
  }
}

absl::Status ReadRoutes(const v1::SolvedLayout& layout, Plan& plan) {
  ASSIGN_OR_RETURN(const Scene scene, SceneFromProto(layout.graph()));
  ASSIGN_OR_RETURN(const PartialLayout partial, PosesFromPlacements(scene, layout.placements()));
  const evaluation::Routes routes = evaluation::FindRoutes({scene, partial.layout, partial.placed});
  for (const evaluation::Route& route : routes.routes) {
    std::vector<Point>& points = plan.routes_m.emplace_back();
    for (const flair::Vec2<double>& point : route.points) points.push_back({point.x, point.y});
  }
  const std::set<std::string> blocked(routes.blocked.begin(), routes.blocked.end());
  for (PlanObject& object : plan.objects) object.blocked = blocked.contains(object.id);
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (blocked.contains(object.id())) plan.blocked.push_back(object.name());
  }
  return absl::OkStatus();
}

}  // namespace flair::renderer
