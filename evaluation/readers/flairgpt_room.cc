// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>

#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;

// The recordings have no heights. Furniture stands higher than a window sill and lower than what hangs on walls.
constexpr double kRoomHeight_m = 3.0, kFurniture_m = 1.0, kWallBottom_m = 1.4, kWallPiece_m = 0.5, kLamp_m = 0.5;
constexpr double kItem_m = 0.3, kRug_m = 0.01, kSill_m = 0.9, kHead_m = 2.1;
// A thing on a table that covers half a square metre lies flat: a blanket, a cutting mat.
constexpr double kCloth_m2 = 0.5, kCloth_m = 0.02;
// Things recorded without a size.
constexpr double kLeastExtent_m = 0.05;

bool IsRug(const std::string& name) {
  std::string spaced;
  for (char c : name) spaced += std::isalpha(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : ' ';
  std::istringstream stream(spaced);
  for (std::string word; stream >> word;) {
    if (FlairGptMeaning("rug_words", word) != nullptr) return true;
  }
  return false;
}

void AddVertex(double x, double y, v1::Room& room) {
  v1::Point2* vertex = room.mutable_floor()->add_vertices();
  vertex->set_x_m(x);
  vertex->set_y_m(y);
}

std::string FeatureKind(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(c));
  if (word.rfind("window", 0) == 0) return "window";
  if (word.rfind("door", 0) == 0 || word == "entrance") return "door";
  return "socket";
}

// Models put windows over each other and over doors: windows that overlap become one, a window gives way to a door.
void AddOpening(v1::Opening opening, v1::Room& room) {
  double low = opening.offset_m(), high = low + opening.width_m();
  for (int i = 0; i < room.openings_size(); ++i) {
    v1::Opening& other = *room.mutable_openings(i);
    const double other_low = other.offset_m(), other_high = other_low + other.width_m();
    if (other.wall() != opening.wall() || high <= other_low || other_high <= low) continue;
    const bool window = opening.kind() == v1::OPENING_KIND_WINDOW;
    if (window && other.kind() == v1::OPENING_KIND_WINDOW) {
      low = std::min(low, other_low);
      high = std::max(high, other_high);
      room.mutable_openings()->DeleteSubrange(i--, 1);
    } else if (!window && other.kind() == v1::OPENING_KIND_WINDOW) {
      v1::Opening rest = other;
      room.mutable_openings()->DeleteSubrange(i--, 1);
      rest.set_offset_m(other_low < low ? other_low : high);
      rest.set_width_m(other_low < low ? low - other_low : other_high - high);
      if (rest.width_m() > 0.1) *room.add_openings() = rest;
    } else {
      if (low < other_low)
        high = other_low;
      else
        low = other_high;
    }
  }
  if (high - low < 0.1) return;
  opening.set_offset_m(low);
  opening.set_width_m(high - low);
  *room.add_openings() = std::move(opening);
}

// `number` counts the features: what merges leaves its id unused.
void AddFeature(const json& feature, int number, double width, double length, v1::Room& room) {
  if (!feature.contains("wall") || !feature["wall"].is_string() || !feature.value("position", json()).is_number())
    return;
  const std::string wall = feature["wall"];
  const bool across = wall == "south" || wall == "north";
  const double wall_m = across ? width : length;
  const double size_m = std::min(feature.value("width", 0.0), wall_m);
  const double low = feature["position"].get<double>() * (wall_m - size_m);
  // Recorded from the west or south end; walls here run counter-clockwise.
  const double offset = std::max(0.0, wall == "south" || wall == "east" ? low : wall_m - low - size_m);
  const std::string kind = FeatureKind(feature.value("kind", ""));
  if (kind == "socket") {
    v1::Socket* socket = room.add_sockets();
    socket->set_id(fmt::format("socket_{}", room.sockets_size()));
    socket->set_wall(wall);
    socket->set_offset_m(offset + size_m / 2);
    socket->set_height_m(0.3);
    return;
  }
  v1::Opening fresh;
  v1::Opening* opening = &fresh;
  opening->set_id(fmt::format("{}_{}", kind, number));
  opening->set_wall(wall);
  opening->set_offset_m(offset);
  opening->set_width_m(size_m);
  opening->set_head_height_m(kHead_m);
  if (kind == "window") {
    opening->set_kind(v1::OPENING_KIND_WINDOW);
    opening->set_sill_height_m(kSill_m);
    AddOpening(fresh, room);
    return;
  }
  opening->set_kind(v1::OPENING_KIND_DOOR);
  // The recorded hinge is the end at which the wall, walked counter-clockwise, begins.
  opening->mutable_leaf()->set_hinge(v1::HINGE_SIDE_START);
  opening->mutable_leaf()->set_swing(v1::DOOR_SWING_INWARD);
  opening->mutable_leaf()->set_swing_angle_rad(1.5707963267948966);
  AddOpening(fresh, room);
}

void ReadRoom(const json& problem, v1::Room& room) {
  const double width = problem.at("room").at("width"), length = problem.at("room").at("length");
  room.set_room_type("room");
  room.set_title(problem.value("prompt", problem.value("name", "")));
  AddVertex(0, 0, room);
  AddVertex(width, 0, room);
  AddVertex(width, length, room);
  AddVertex(0, length, room);
  for (const char* name : {"south", "east", "north", "west"}) room.add_walls()->set_name(name);
  room.set_height_m(kRoomHeight_m);
  int number = 0;
  for (const json& feature : problem.value("fixed_objects", json::array())) {
    AddFeature(feature, ++number, width, length, room);
  }
}

std::string ZoneId(const std::string& name) {
  std::string id;
  for (char c : name) id += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '_';
  return id;
}

void AddObject(const json& record, v1::ObjectRole role, v1::LayoutGraph& graph) {
  v1::Object* object = graph.mutable_object_list()->add_objects();
  const bool tertiary = role == v1::OBJECT_ROLE_TERTIARY;
  object->set_id(FlairGptObjectId(tertiary, record.at("index")));
  object->set_name(record.at("name"));
  object->set_role(role);
  object->set_width_m(std::max(kLeastExtent_m, record.at("width").get<double>()));
  object->set_depth_m(std::max(kLeastExtent_m, record.at("length").get<double>()));
  if (!tertiary) object->set_zone_id(ZoneId(record.value("zone", "")));
  const std::string type = tertiary && record.value("type", json()).is_string() ? record["type"] : "floor";
  object->set_walk_over(type == "floor" && IsRug(object->name()));
  object->set_height_m(object->walk_over() ? kRug_m : kFurniture_m);
  object->set_kind(v1::OBJECT_KIND_FLOOR);
  if (type == "wall") {
    object->set_kind(v1::OBJECT_KIND_WALL);
    object->set_elevation_m(kWallBottom_m);
    object->set_height_m(kWallPiece_m);
  } else if (type == "ceiling") {
    object->set_kind(v1::OBJECT_KIND_CEILING);
    object->set_elevation_m(kRoomHeight_m - kLamp_m);
    object->set_height_m(kLamp_m);
  } else if (type == "table") {
    object->set_kind(v1::OBJECT_KIND_SURFACE);
    object->set_height_m(object->width_m() * object->depth_m() < kCloth_m2 ? kItem_m : kCloth_m);
  }
}

void AddDiagnostic(const std::string& message, v1::LayoutGraph& graph) {
  // Recordings repeat the calls of their zones for all of them.
  const bool known =
      std::ranges::any_of(graph.diagnostics(), [&](const v1::Diagnostic& other) { return other.message() == message; });
  if (known) return;
  v1::Diagnostic* diagnostic = graph.add_diagnostics();
  diagnostic->set_severity(v1::SEVERITY_WARNING);
  diagnostic->set_code("unusable_call");
  diagnostic->set_message(message);
}

void AddEdge(v1::ConstraintEdge edge, v1::LayoutGraph& graph) {
  const std::string content = edge.SerializeAsString();
  const bool known = std::ranges::any_of(graph.edges(), [&](v1::ConstraintEdge other) {
    other.clear_id();
    return other.SerializeAsString() == content;
  });
  if (known) return;
  edge.set_id(fmt::format("e{}", graph.edges_size() + 1));
  *graph.add_edges() = std::move(edge);
}

// As a model would write it: "io_near(3, 1, max_dist=0.5)".
std::string CallText(const json& call) {
  const auto text = [](const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); };
  if (!call.is_object() || !call.value("function", json()).is_string()) return text(call);
  std::string inside;
  for (const json& argument : call.value("args", json::array()))
    inside += (inside.empty() ? "" : ", ") + text(argument);
  const json keywords = call.value("kwargs", json::object());
  for (const auto& [keyword, value] : keywords.items()) {
    inside += fmt::format("{}{}={}", inside.empty() ? "" : ", ", keyword, text(value));
  }
  return fmt::format("{}({})", call["function"].get<std::string>(), inside);
}

void AddCalls(const json& calls, v1::LayoutGraph& graph) {
  for (const json& call : calls) {
    absl::StatusOr<std::vector<v1::ConstraintEdge>> edges = ReadFlairGptCall(call, graph);
    if (!edges.ok()) {
      AddDiagnostic(fmt::format("{}: {}", CallText(call), std::string(edges.status().message())), graph);
      continue;
    }
    for (v1::ConstraintEdge& edge : *edges) AddEdge(std::move(edge), graph);
  }
}

absl::Status Refusal(std::string_view why) { return InvalidArgument("not a recorded FlairGPT problem: {}", why); }

v1::LayoutGraph ReadProblem(const json& problem) {
  v1::LayoutGraph graph;
  ReadRoom(problem, *graph.mutable_room());
  for (const json& name : problem.value("zones", json::array())) {
    v1::Zone* zone = graph.mutable_zone_plan()->add_zones();
    zone->set_id(ZoneId(name));
    zone->set_name(name);
  }
  for (const json& record : problem.value("primary", json::array())) AddObject(record, v1::OBJECT_ROLE_PRIMARY, graph);
  for (const json& record : problem.value("secondary", json::array()))
    AddObject(record, v1::OBJECT_ROLE_SECONDARY, graph);
  for (const json& record : problem.value("tertiary", json::array()))
    AddObject(record, v1::OBJECT_ROLE_TERTIARY, graph);
  const json& calls = problem.at("calls");
  AddCalls(calls.value("primary", json::array()), graph);
  for (const json& zone : calls.value("secondary", json::array())) AddCalls(zone.value("calls", json::array()), graph);
  AddCalls(calls.value("secondary_all", json::array()), graph);
  AddCalls(calls.value("tertiary", json::array()), graph);
  return graph;
}

absl::StatusOr<v1::SolvedLayout> ReadSolution(const json& problem, const v1::LayoutGraph& graph) {
  v1::SolvedLayout layout;
  *layout.mutable_graph() = graph;
  for (const char* stage : {"primary", "secondary", "tertiary"}) {
    const json objects = problem.value(stage, json::array());
    const json solution = problem.value("solution", json::object());
    const json poses = solution.value(stage, json::array());
    if (poses.size() != objects.size()) {
      return NotFound("the recorded layout has {} {} poses for {} objects", poses.size(), stage, objects.size());
    }
    for (size_t i = 0; i < poses.size(); ++i) {
      v1::Placement* placement = layout.add_placements();
      const bool tertiary = std::string_view(stage) == "tertiary";
      placement->set_object_id(FlairGptObjectId(tertiary, objects[i].at("index")));
      placement->set_x_m(poses[i].at(0));
      placement->set_y_m(poses[i].at(1));
      placement->set_theta_rad(WrapHeading(poses[i].at(2).get<double>()));
    }
  }
  return layout;
}

// The recording's index in an id of FlairGptObjectId; `otherwise` for the ids of graphs that were not imported.
int IndexOf(const std::string& id, int otherwise) {
  for (const std::string_view prefix : {"floor_", "item_"}) {
    if (id.rfind(prefix, 0) != 0) continue;
    int index = 0;
    const char* end = id.data() + id.size();
    const auto [read, error] = std::from_chars(id.data() + prefix.size(), end, index);
    if (error == std::errc() && read == end) return index;
  }
  return otherwise;
}

}  // namespace

absl::StatusOr<v1::LayoutGraph> ReadFlairGptRoom(const std::string& text) {
  const absl::StatusOr<json> problem = ParseFlairGptText(text);
  if (!problem.ok()) return Refusal(std::string(problem.status().message()));
  return ReadFlairGptProblem(*problem);
}

absl::StatusOr<v1::LayoutGraph> ReadFlairGptProblem(const json& problem) {
  const absl::Status good = CheckFlairGptProblem(problem);
  if (!good.ok()) return Refusal(std::string(good.message()));
  try {
    return ReadProblem(problem);
  } catch (const json::exception& error) {
    return Refusal(error.what());
  }
}

absl::StatusOr<v1::SolvedLayout> ReadFlairGptSolution(const std::string& text, const v1::LayoutGraph& graph) {
  try {
    return ReadSolution(json::parse(text), graph);
  } catch (const json::exception& error) {
    return NotFound("no recorded layout: {}", error.what());
  }
}

std::string WriteFlairGptLayout(const v1::SolvedLayout& layout, const std::string& name, double seconds) {
  json objects = json::array();
  int floor_count = 0, item_count = 0;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    const bool tertiary = object.role() == v1::OBJECT_ROLE_TERTIARY;
    const int index = IndexOf(object.id(), tertiary ? item_count : floor_count);
    ++(tertiary ? item_count : floor_count);
    const auto placement =
        std::ranges::find_if(layout.placements(), [&](const v1::Placement& p) { return p.object_id() == object.id(); });
    if (placement == layout.placements().end()) continue;
    const char* role = tertiary ? "tertiary" : object.role() == v1::OBJECT_ROLE_PRIMARY ? "primary" : "secondary";
    objects.push_back({{"role", role},
                       {"index", index},
                       {"name", object.name()},
                       {"x", placement->x_m()},
                       {"y", placement->y_m()},
                       {"theta", placement->theta_rad()},
                       {"width", object.width_m()},
                       {"length", object.depth_m()}});
  }
  return json{{"name", name}, {"seconds", seconds}, {"objects", objects}}.dump(1, ' ', false,
                                                                               json::error_handler_t::replace) +
         "\n";
}

}  // namespace flair::evaluation
