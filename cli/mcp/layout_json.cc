// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/layout_json.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/strip.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli::mcp {
namespace {

// To a millimetre; no minus before nothing.
double Rounded(double value, double steps = 1000) {
  const double rounded = std::round(value * steps) / steps;
  return rounded == 0 ? 0.0 : rounded;
}

double HeadingDeg(double theta_rad) {
  const double turned = std::fmod(Rounded(theta_rad * 180 / std::numbers::pi, 10), 360.0);
  return turned < 0 ? turned + 360 : turned;
}

Json PointJson(const v1::Point2& point) { return Json::array({Rounded(point.x_m()), Rounded(point.y_m())}); }

Json RoomJson(const v1::Room& room) {
  Json json = {{"height_m", Rounded(room.height_m())}, {"walls", Json::array()}, {"openings", Json::array()}};
  if (!room.room_type().empty()) json["type"] = room.room_type();
  const auto& corners = room.floor().vertices();
  for (int i = 0; i < room.walls_size() && i < corners.size(); ++i) {
    const v1::Point2& from = corners[i];
    const v1::Point2& to = corners[(i + 1) % corners.size()];
    json["walls"].push_back({{"name", room.walls(i).name()}, {"from", PointJson(from)}, {"to", PointJson(to)}});
    const double length = std::hypot(to.x_m() - from.x_m(), to.y_m() - from.y_m());
    for (const v1::Opening& opening : room.openings()) {
      if (opening.wall() != room.walls(i).name() || length <= 0) continue;
      const double along = (opening.offset_m() + opening.width_m() / 2) / length;
      json["openings"].push_back({{"id", opening.id()},
                                  {"kind", opening.kind() == v1::OPENING_KIND_DOOR ? "door" : "window"},
                                  {"wall", opening.wall()},
                                  {"x_m", Rounded(from.x_m() + along * (to.x_m() - from.x_m()))},
                                  {"y_m", Rounded(from.y_m() + along * (to.y_m() - from.y_m()))},
                                  {"width_m", Rounded(opening.width_m())},
                                  {"sill_m", Rounded(opening.sill_height_m())},
                                  {"head_m", Rounded(opening.head_height_m())}});
    }
  }
  return json;
}

}  // namespace

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == id) return &placement;
  }
  return nullptr;
}

Json PlaceJson(const v1::LayoutGraph& graph, const v1::Object& object, const v1::Placement* placement) {
  Json json = {{"id", object.id()},
               {"name", object.name()},
               {"width_m", Rounded(object.width_m())},
               {"depth_m", Rounded(object.depth_m())},
               {"height_m", Rounded(object.height_m())}};
  if (!object.zone_id().empty()) json["zone"] = object.zone_id();
  if (!object.host_id().empty()) json["stands_on"] = object.host_id();
  if (placement == nullptr) {
    json["placed"] = false;
    return json;
  }
  json["x_m"] = Rounded(placement->x_m());
  json["y_m"] = Rounded(placement->y_m());
  json["z_m"] = Rounded(placement->z_m());
  json["heading_deg"] = HeadingDeg(placement->theta_rad());
  for (const v1::Placement& pin : graph.pinned_placements()) {
    if (pin.object_id() == object.id()) json["pinned"] = true;
  }
  return json;
}

Json MeasuresJson(const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes,
                  const v1::LayoutMetrics& metrics) {
  int held = 0, missed = 0;
  for (const v1::EdgeOutcome& outcome : outcomes) {
    held += outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
    missed += outcome.status() == v1::OUTCOME_STATUS_VIOLATED;
  }
  Json json = {{"constraints_held", held},
               {"constraints_missed", missed},
               {"overlap_percent", Rounded(metrics.oor_percent())},
               {"outside_percent", Rounded(metrics.oob_percent())},
               {"reachable_floor_percent", Rounded(metrics.reachable_floor_share() * 100, 10)}};
  if (metrics.has_use_count()) {
    json["uses"] = metrics.use_count();
    json["uses_met"] = metrics.met_use_count();
  }
  return json;
}

Json FaultsJson(const v1::LayoutGraph& graph, const v1::LayoutMetrics& metrics) {
  Json json = Json::array();
  for (const v1::Finding& finding : metrics.findings()) {
    std::string text = finding.message();
    for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
      if (sentence.id() == finding.sentence_id()) text += fmt::format(" (\"{}\", {})", sentence.text(), sentence.id());
    }
    json.push_back(std::move(text));
  }
  return json;
}

void AddHistory(const v1::Document& document, Json& json) {
  if (!document.undo_label().empty()) json["undo"] = document.undo_label();
  if (!document.redo_label().empty()) json["redo"] = document.redo_label();
}

Json DescribedJson(const v1::Document& document, const v1::SolvedLayout& layout) {
  const v1::LayoutGraph& graph = layout.graph();
  Json json = {{"document_id", document.id()},
               {"title", document.title()},
               {"revision", document.revision()},
               {"room", RoomJson(graph.room())},
               {"zones", Json::array()},
               {"objects", Json::array()},
               {"measures", MeasuresJson(layout.edge_outcomes(), layout.metrics())},
               {"faults", FaultsJson(graph, layout.metrics())},
               {"alternative_count", document.variant_count()}};
  if (document.has_brief()) json["brief"] = document.brief().text();
  for (const v1::Zone& zone : graph.zone_plan().zones()) {
    json["zones"].push_back({{"id", zone.id()}, {"name", zone.name()}, {"purpose", zone.purpose()}});
  }
  for (const v1::Object& object : graph.object_list().objects()) {
    json["objects"].push_back(PlaceJson(graph, object, PlacementOf(layout, object.id())));
  }
  AddHistory(document, json);
  return json;
}

absl::StatusOr<const v1::Object*> ObjectMeant(const v1::LayoutGraph& graph, const std::string& key,
                                              const std::string& field) {
  const std::string name(absl::StripPrefix(absl::AsciiStrToLower(absl::StripAsciiWhitespace(key)), "the "));
  const std::string as_id = absl::StrReplaceAll(name, {{" ", "_"}});
  std::vector<const v1::Object*> named;
  std::vector<std::string> ids;
  for (const v1::Object& object : graph.object_list().objects()) {
    if (object.id() == key || object.id() == as_id) return &object;
    if (object.name() == name) named.push_back(&object);
    ids.push_back(object.id());
  }
  if (named.size() == 1) return named.front();
  return InvalidArgument("{}: \"{}\" is {}; the pieces are {}", field, key.substr(0, 80),
                         named.empty() ? "no piece of the room" : "the name of several pieces",
                         absl::StrJoin(ids, ", "));
}

}  // namespace flair::cli::mcp
