// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "evaluation/metrics/routes.h"
#include "renderer_worker/drawing/plan.h"
#include "room/conversion/conversion.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

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
      if (word != (opening.door ? "door" : "window")) continue;
      const PlanWall& wall = plan_.walls[opening.wall];
      features.push_back(wall.start + wall.along * (opening.offset_m + opening.width_m / 2));
    }
    if (word == "socket") {
      for (const PlanSocket& socket : plan_.sockets)
        features.push_back(plan_.walls[socket.wall].start + plan_.walls[socket.wall].along * socket.offset_m);
    }
    if (features.empty()) return std::nullopt;
    return *std::min_element(features.begin(), features.end(),
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
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace

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
