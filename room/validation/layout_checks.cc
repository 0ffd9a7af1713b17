// SPDX-License-Identifier: GPL-3.0-or-later
// Layout graphs, solved layouts, and the artifacts that hold these and all others.
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

namespace {

// Objects may end outside the room when they do not fit, but not at the end of the world.
constexpr Range kHeading{.least = 0, .most = 6.283185307179587, .open_most = true};
constexpr Range kCost{.least = 0, .most = 1e300};

void CheckRegions(const v1::SolvedLayout& layout, const Known& known, const Field& at) {
  for (int i = 0; i < layout.zone_regions_size(); ++i) {
    const v1::ZoneRegion& region = layout.zone_regions(i);
    at[i]["zone_id"].Refers(region.zone_id(), *known.zones, "a zone");
    for (int k = 0; k < region.parts_size(); ++k) {
      for (const v1::Point2& p : region.parts(k).vertices()) {
        at[i]["parts"][k].InRange(p.x_m(), kCoordinate);
        at[i]["parts"][k].InRange(p.y_m(), kCoordinate);
      }
    }
  }
}

}  // namespace

void CheckPlacements(const google::protobuf::RepeatedPtrField<v1::Placement>& placements, const Known& known,
                     const Field& at) {
  NameSet seen;
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& placement = placements[i];
    const Field here = at[i];
    here["object_id"].NewId(placement.object_id(), seen);
    if (known.objects != nullptr) here["object_id"].Refers(placement.object_id(), *known.objects, "an object");
    here["x_m"].InRange(placement.x_m(), kCoordinate);
    here["y_m"].InRange(placement.y_m(), kCoordinate);
    here["z_m"].InRange(placement.z_m(), kCoordinate);
    here["theta_rad"].InRange(placement.theta_rad(), kHeading);
  }
}

void CheckEdgeOutcomes(const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, const Known& known,
                       const Field& at) {
  for (int i = 0; i < outcomes.size(); ++i) {
    const v1::EdgeOutcome& outcome = outcomes[i];
    const Field here = at[i];
    if (known.edges != nullptr) here["edge_id"].Refers(outcome.edge_id(), *known.edges, "an edge");
    here["cost"].InRange(outcome.cost(), kCost);
    here["weighted_cost"].InRange(outcome.weighted_cost(), kCost);
    here["status"].Enum(outcome.status(), v1::OutcomeStatus_IsValid(outcome.status()));
  }
}

void Check(const v1::SolvedLayout& layout, const Field& at) {
  Check(layout.graph(), at["graph"]);
  const NameSet zones = ZoneIds(layout.graph().zone_plan());
  const NameSet objects = ObjectIds(layout.graph().object_list());
  const NameSet edges = EdgeIds(layout.graph());
  const Known known{.zones = &zones, .objects = &objects, .edges = &edges};
  CheckPlacements(layout.placements(), known, at["placements"]);
  CheckRegions(layout, known, at["zone_regions"]);
  CheckEdgeOutcomes(layout.edge_outcomes(), known, at["edge_outcomes"]);
  for (int i = 0; i < layout.runner_ups_size(); ++i) {
    const v1::RunnerUp& runner_up = layout.runner_ups(i);
    const Field field = at["runner_ups"][i];
    CheckPlacements(runner_up.placements(), known, field["placements"]);
    CheckEdgeOutcomes(runner_up.edge_outcomes(), known, field["edge_outcomes"]);
    CheckDiagnostics(runner_up.diagnostics(), field["diagnostics"]);
  }
  for (int i = 0; i < layout.contradictions_size(); ++i) {
    const Field field = at["contradictions"][i];
    field["edge_ids"].Count(layout.contradictions(i).edge_ids_size(), 1, 20000, "edges");
    for (int k = 0; k < layout.contradictions(i).edge_ids_size(); ++k) {
      field["edge_ids"][k].Refers(layout.contradictions(i).edge_ids(k), edges, "an edge");
    }
  }
  CheckDiagnostics(layout.diagnostics(), at["diagnostics"]);
  if (!std::isfinite(layout.total_cost())) at["total_cost"].Reject("{} is no number", layout.total_cost());
}

namespace {

constexpr Range kShare{.least = 0, .most = 1};
constexpr Range kPercent{.least = 0, .most = 1e9};

void CheckContent(const v1::Artifact& artifact, const Field& at) {
  switch (artifact.content_case()) {
    case v1::Artifact::kBrief:
      return Check(artifact.brief(), at["brief"]);
    case v1::Artifact::kRoom:
      return Check(artifact.room(), at["room"]);
    case v1::Artifact::kZonePlan:
      return Check(artifact.zone_plan(), at["zone_plan"]);
    case v1::Artifact::kObjectList:
      return Check(artifact.object_list(), {}, at["object_list"]);
    case v1::Artifact::kStyleSheet:
      return Check(artifact.style_sheet(), {}, at["style_sheet"]);
    case v1::Artifact::kRawConstraintList:
      return Check(artifact.raw_constraint_list(), {}, at["raw_constraint_list"]);
    case v1::Artifact::kConstraintList:
      return Check(artifact.constraint_list(), {}, at["constraint_list"]);
    case v1::Artifact::kLayoutGraph:
      return Check(artifact.layout_graph(), at["layout_graph"]);
    case v1::Artifact::kSolvedLayout:
      return Check(artifact.solved_layout(), at["solved_layout"]);
    case v1::Artifact::kPreview:
      return Check(artifact.preview(), at["preview"]);
    case v1::Artifact::kReport:
      return Check(artifact.report(), at["report"]);
    case v1::Artifact::CONTENT_NOT_SET:
      at["content"].Reject("is not set");
  }
}

}  // namespace

void Check(const v1::Preview& preview, const Field& at) {
  at["view"].Enum(preview.view(), v1::PreviewView_IsValid(preview.view()));
  at["format"].Enum(preview.format(), v1::PreviewFormat_IsValid(preview.format()));
  const bool is_page = preview.format() == v1::PREVIEW_FORMAT_SVG || preview.format() == v1::PREVIEW_FORMAT_PDF;
  const double least = is_page ? 0 : 1;  // pages have no pixels
  at["width_px"].InRange(preview.width_px(), {.least = least, .most = 16384});
  at["height_px"].InRange(preview.height_px(), {.least = least, .most = 16384});
  if (preview.image().empty()) at["image"].Reject("is empty");
  const int matrix_size = preview.annotations().camera().camera_from_room_size();
  if (matrix_size != 0 && matrix_size != 16) {
    at["annotations"]["camera"]["camera_from_room"].Reject("has {} numbers; 16", matrix_size);
  }
}

void Check(const v1::Report& report, const Field& at) {
  const v1::LayoutMetrics& metrics = report.metrics();
  at["metrics"]["oob_percent"].InRange(metrics.oob_percent(), kPercent);
  at["metrics"]["oor_percent"].InRange(metrics.oor_percent(), kPercent);
  at["metrics"]["reachable_floor_share"].InRange(metrics.reachable_floor_share(), kShare);
  at["metrics"]["reachable_front_share"].InRange(metrics.reachable_front_share(), kShare);
  CheckDiagnostics(report.diagnostics(), at["diagnostics"]);
}

void Check(const v1::Artifact& artifact, const Field& at) {
  if (!artifact.id().empty()) at["id"].Digest(artifact.id());
  for (int i = 0; i < artifact.made_from_ids_size(); ++i) at["made_from_ids"][i].Digest(artifact.made_from_ids(i));
  if (!artifact.options_digest().empty()) at["options_digest"].Digest(artifact.options_digest());
  CheckContent(artifact, at);
}

}  // namespace flair::validation
