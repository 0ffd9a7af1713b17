// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

void CheckArgument(const v1::Argument& argument, const Field& at) {
  const Field value = at["value"];
  switch (argument.value().value_case()) {
    case v1::ArgumentValue::kText:
      value["text"].Text(argument.value().text(), 1, 200);
      break;
    case v1::ArgumentValue::kTexts:
      if (!value["texts"].Count(argument.value().texts().items_size(), 1, 1000, "items")) break;
      for (int i = 0; i < argument.value().texts().items_size(); ++i) {
        value["texts"]["items"][i].Text(argument.value().texts().items(i), 1, 200);
      }
      break;
    case v1::ArgumentValue::kNumber:
      if (!std::isfinite(argument.value().number()))
        value["number"].Reject("{} is no number", argument.value().number());
      break;
    case v1::ArgumentValue::kFlag:
      break;
    case v1::ArgumentValue::VALUE_NOT_SET:
      value.Reject("is not set");
  }
}

void CheckEdge(const v1::ConstraintEdge& edge, const NameSet& sentences, const Field& at) {
  at["type"].Id(edge.type());
  at["weight"].InRange(edge.weight(), {.least = 0, .most = 100, .open_least = true});
  if (!edge.sentence_id().empty()) at["sentence_id"].Refers(edge.sentence_id(), sentences, "a sentence");
  NameSet names;
  for (int i = 0; i < edge.arguments_size(); ++i) {
    at["arguments"][i]["name"].NewId(edge.arguments(i).name(), names);
    CheckArgument(edge.arguments(i), at["arguments"][i]);
  }
}

// Two thousand over twenty objects take a solve half a minute on one core.
constexpr int kMostEdges = 4000;
// A pinned object may stick out of the room, which the solve reports; further away it is a slip of the pen.
constexpr double kPinMargin_m = 1;

void CheckPins(const v1::LayoutGraph& graph, const Known& known, const Field& at) {
  CheckPlacements(graph.pinned_placements(), known, at);
  double least_x = 0, most_x = 0, least_y = 0, most_y = 0;
  for (const v1::Point2& p : graph.room().floor().vertices()) {
    least_x = std::min(least_x, p.x_m());
    most_x = std::max(most_x, p.x_m());
    least_y = std::min(least_y, p.y_m());
    most_y = std::max(most_y, p.y_m());
  }
  for (int i = 0; i < graph.pinned_placements_size(); ++i) {
    const v1::Placement& pin = graph.pinned_placements(i);
    at[i]["x_m"].InRange(pin.x_m(), {.least = least_x - kPinMargin_m, .most = most_x + kPinMargin_m});
    at[i]["y_m"].InRange(pin.y_m(), {.least = least_y - kPinMargin_m, .most = most_y + kPinMargin_m});
  }
}

}  // namespace

// The edges' arguments against the catalogue are the optimizer's business: it alone knows the types.
void Check(const v1::LayoutGraph& graph, const Field& at) {
  const NameSet zones = ZoneIds(graph.zone_plan());
  const NameSet objects = ObjectIds(graph.object_list());
  const NameSet openings = OpeningIds(graph.room());
  const NameSet sentences = SentenceIds(graph.constraint_list());
  const Known known{.zones = &zones, .objects = &objects, .openings = &openings, .sentences = &sentences};
  Check(graph.room(), at["room"]);
  Check(graph.zone_plan(), at["zone_plan"]);
  Check(graph.object_list(), known, at["object_list"]);
  Check(graph.style_sheet(), known, at["style_sheet"]);
  Check(graph.constraint_list(), known, at["constraint_list"]);
  for (const v1::Opening& opening : graph.room().openings()) {
    if (!objects.contains(opening.id())) continue;
    at["object_list"].Reject("\"{}\" is an object and an opening; ids differ", opening.id());
  }
  if (!at["edges"].Count(graph.edges_size(), 0, kMostEdges, "edges")) return;
  NameSet seen;
  for (int i = 0; i < graph.edges_size(); ++i) {
    at["edges"][i]["id"].NewId(graph.edges(i).id(), seen);
    CheckEdge(graph.edges(i), sentences, at["edges"][i]);
  }
  CheckPins(graph, known, at["pinned_placements"]);
  CheckDiagnostics(graph.diagnostics(), at["diagnostics"]);
}

NameSet EdgeIds(const v1::LayoutGraph& graph) {
  NameSet ids;
  for (const v1::ConstraintEdge& edge : graph.edges()) ids.insert(edge.id());
  return ids;
}

}  // namespace flair::validation
