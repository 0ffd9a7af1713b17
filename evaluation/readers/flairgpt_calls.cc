// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/readers/flairgpt_calls.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "worker_runtime/status/status_macros.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;

// A function with the value of each of its parameters, null for those that are not given.
struct Call {
  std::string name;
  const FlairGptFunction* function = nullptr;
  std::vector<json> values;
};

bool IsSide(FlairGptKind kind) { return kind == FlairGptKind::kSide || kind == FlairGptKind::kSides; }

absl::StatusOr<Call> Assign(const json& record) {
  if (!record.is_object() || !record.value("function", json()).is_string()) {
    return absl::InvalidArgumentError("not a call; should be {\"function\": NAME, \"args\": [...], \"kwargs\": {...}}");
  }
  Call call{CanonicalFlairGptName(record["function"].get<std::string>()), nullptr, {}};
  call.function = FindFlairGptFunction(call.name);
  if (call.function == nullptr) return NotFound("unknown function {}", call.name);
  const std::vector<FlairGptParameter>& parameters = call.function->parameters;
  call.values.resize(parameters.size());
  json arguments = record.value("args", json::array());
  if (!arguments.is_array()) return absl::InvalidArgumentError("args is not a list");
  // A lone number after the object is the distance, whatever stands between.
  for (size_t p = 1; p < parameters.size() && p < arguments.size(); ++p) {
    if (IsSide(parameters[p].kind) && arguments[p].is_number()) arguments.insert(arguments.begin() + p, json());
  }
  if (arguments.size() > parameters.size()) {
    if (!call.function->ignores_others) {
      return InvalidArgument("{} arguments, at most {} are known", arguments.size(), parameters.size());
    }
    arguments.erase(arguments.begin() + static_cast<int>(parameters.size()), arguments.end());
  }
  std::copy(arguments.begin(), arguments.end(), call.values.begin());
  const json keywords = record.value("kwargs", json::object());
  for (const auto& [keyword, value] : keywords.items()) {
    const int p = PositionOfKeyword(keyword, *call.function);
    if (p >= 0) {
      call.values[p] = value;
    } else if (!call.function->ignores_others) {
      return InvalidArgument("unknown keyword {}", keyword);
    }
  }
  return call;
}

bool NamesWall(const json& value) {
  return value.is_string() && (FlairGptWords(value) == "wall" || FlairGptWords(value) == "walls");
}

// What the call says when its second argument is a wall, or a piece of furniture in place of a door or window.
Call Reinterpret(Call call, const FlairGptArguments& arguments) {
  const auto become = [](const char* name, std::vector<json> values) {
    Call other{name, FindFlairGptFunction(name), std::move(values)};
    other.values.resize(other.function->parameters.size());
    return other;
  };
  const std::vector<json> v = call.values;
  const bool wall = v.size() > 1 && NamesWall(v[1]);
  const bool furniture = v.size() > 1 && v[1].is_string() && arguments.ObjectId(v[1], false).ok();
  if (call.name == "io_next_to" && wall) return become("ind_next_to_wall", {v[0], v[2]});
  if (call.name == "ind_away_from_fixed_object") {
    if (wall) return become("ind_not_against_wall", {v[0], v[2]});
    if (furniture) return become("io_away_from", {v[0], v[1], v[2]});
  }
  if (call.name == "ind_close_to_fixed_object") {
    if (wall) return become("ind_near_wall", {v[0], v[2], v[3]});
    if (furniture) return become("io_near", {v[0], v[1], v[3]});
  }
  return call;
}

absl::StatusOr<v1::ConstraintEdge> EdgeOf(const Call& call, const FlairGptArguments& arguments) {
  v1::ConstraintEdge edge;
  edge.set_type(call.function->type);
  edge.set_weight(1);
  for (size_t p = 0; p < call.values.size(); ++p) {
    const std::string object_id = edge.arguments_size() > 0 ? edge.arguments(0).value().text() : "";
    ASSIGN_OR_RETURN(std::optional<v1::Argument> argument,
                     arguments.Read(call.function->parameters[p], call.values[p], object_id));
    if (argument.has_value()) *edge.add_arguments() = *std::move(argument);
  }
  return edge;
}

absl::StatusOr<std::vector<v1::ConstraintEdge>> Read(const json& record, const v1::LayoutGraph& graph) {
  const FlairGptArguments arguments(graph);
  ASSIGN_OR_RETURN(Call assigned, Assign(record));
  const Call call = Reinterpret(std::move(assigned), arguments);
  std::vector<Call> calls(1, call);
  const bool takes_several = call.name == "io_away_from" || call.name == "io_near";
  if (takes_several && call.values[1].is_array() && call.values[1].size() > 1) {
    calls.assign(call.values[1].size(), call);
    for (size_t i = 0; i < calls.size(); ++i) calls[i].values[1] = call.values[1][i];
  }
  std::vector<v1::ConstraintEdge> edges;
  for (const Call& one : calls) {
    ASSIGN_OR_RETURN(v1::ConstraintEdge edge, EdgeOf(one, arguments));
    edges.push_back(std::move(edge));
  }
  return edges;
}

// "name:kind" in positional order, by the letters of FlairGptKind; capital O: a floor object that may be left out; * at
// the end: and others.
struct Row {
  const char* type;
  const char* parameters;
};

const std::map<std::string, Row>& Rows() {
  static const std::map<std::string, Row> rows = {
      {"ind_next_to_wall", {"against_wall", "object:o side:s"}},
      {"ind_near_wall", {"near_wall", "object:o side:s max_distance_m:n"}},
      {"ind_in_corner", {"in_corner", "object:o side:s :_"}},
      {"ind_close_to_fixed_object", {"close_to_feature", "object:o feature:f side:s max_distance_m:n"}},
      {"ind_away_from_fixed_object", {"away_from_feature", "object:o feature:f min_distance_m:n"}},
      {"ind_accessible", {"accessible", "object:o sides:S min_clearance_m:n"}},
      {"ind_central", {"central", "object:o both:b"}},
      {"ind_in_region", {"in_zone", "object:o zone:z :_"}},
      {"ind_not_block_fixed_object", {"clear_of_feature", "object:o feature:f"}},
      {"ind_under_window", {"under_window", "object:o"}},
      {"ind_facing_into_room", {"facing_into_room", "object:o"}},
      {"ind_not_against_wall", {"not_against_wall", "object:o min_distance_m:n"}},
      {"ind_not_in_corner", {"not_in_corner", "object:o"}},
      {"ind_parallel_to_wall", {"parallel_to_wall", "object:o"}},
      {"io_next_to", {"next_to", "object:o target:o object_side:s target_side:s"}},
      {"io_away_from", {"away_from", "object:o target:o min_distance_m:n"}},
      {"io_near", {"near", "object:o target:o max_distance_m:n"}},
      {"io_parallel", {"parallel", "object:o target:o *"}},
      {"io_facing", {"facing", "object:o target:o both:b"}},
      {"io_not_facing", {"not_facing", "object:o target:o"}},
      {"io_infront", {"in_front_of", "object:o target:o distance_m:n parallel:b"}},
      {"io_perp", {"perpendicular", "object:o target:o center:O"}},
      {"io_on", {"on", "object:o target:o"}},
      {"io_under_central", {"under_center", "object:o target:o"}},
      {"io_surround", {"surround", "center:o objects:L"}},
      {"io_between", {"between", "object:o first:o second:o"}},
      {"rug_under_central", {"rug_under_center", "rug:i object:o"}},
      {"rug_under_central_forward", {"rug_under_forward", "rug:i object:o"}},
      {"on_top_central", {"on_top_center", "object:i host:o"}},
      {"on_top_corner", {"on_top_corner", "object:i host:o corner:c"}},
      {"on_wall_near", {"on_wall_near", "object:i target:o"}},
      {"on_wall_above_central", {"on_wall_above", "object:i target:o"}},
      {"on_wall_in_region", {"on_wall_in_zone", "object:i zone:z"}},
      {"center_ceiling", {"ceiling_center", "object:i"}},
      {"ceiling_above", {"ceiling_above", "object:i target:o"}},
  };
  return rows;
}

FlairGptFunction FunctionOf(const Row& row) {
  FlairGptFunction function{row.type, {}, false};
  std::istringstream words(row.parameters);
  for (std::string word; words >> word;) {
    if (word == "*") {
      function.ignores_others = true;
      continue;
    }
    const char letter = word.back();
    const bool required = std::string_view("oizfL").find(letter) != std::string_view::npos;
    const auto kind = letter == 'O' ? FlairGptKind::kFloorObject : static_cast<FlairGptKind>(letter);
    function.parameters.push_back({word.substr(0, word.find(':')), kind, required});
  }
  return function;
}

}  // namespace

absl::StatusOr<std::vector<v1::ConstraintEdge>> ReadFlairGptCall(const json& call, const v1::LayoutGraph& graph) {
  try {
    return Read(call, graph);
  } catch (const json::exception& error) {
    return InvalidArgument("not a call: {}", error.what());
  }
}

std::string CanonicalFlairGptName(std::string name) {
  static const std::map<std::string, std::string> aliases = {
      {"io_min_dist", "io_away_from"},           {"ind_near_fixed_object", "ind_close_to_fixed_object"},
      {"ind_near", "ind_close_to_fixed_object"}, {"ind_not_next_to_wall", "ind_not_against_wall"},
      {"on_top_center", "on_top_central"},       {"on_wall_above", "on_wall_above_central"}};
  if (name.rfind("p_", 0) == 0) name = "io_" + name.substr(2);
  if (const auto it = aliases.find(name); it != aliases.end()) return it->second;
  if (Rows().count(name) != 0) return name;
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"ind_", "io_"}, {"io_", "ind_"}}) {
    if (name.rfind(from, 0) != 0) continue;
    const std::string other = to + name.substr(from.size());
    if (Rows().count(other) != 0) return other;
  }
  return name;
}

const FlairGptFunction* FindFlairGptFunction(const std::string& canonical_name) {
  static const std::map<std::string, FlairGptFunction> functions = [] {
    std::map<std::string, FlairGptFunction> map;
    for (const auto& [name, row] : Rows()) map.emplace(name, FunctionOf(row));
    return map;
  }();
  const auto it = functions.find(canonical_name);
  return it == functions.end() ? nullptr : &it->second;
}

int PositionOfKeyword(const std::string& keyword, const FlairGptFunction& function) {
  // The empty name is that of what is ignored.
  static const std::map<std::string, std::vector<std::string>> names = {
      {"object_index", {"object", "host", "target"}},
      {"other_index", {"object", "host", "target"}},
      {"object1_index", {"object"}},
      {"object2_index", {"target", "first"}},
      {"object3_index", {"second"}},
      {"fixed_object_type", {"feature"}},
      {"region_name", {"zone"}},
      {"center_object_index", {"center"}},
      {"central_object_index", {"center"}},
      {"object_indices", {"objects"}},
      {"tertiary_index", {"rug", "object"}},
      {"rug_index", {"rug"}},
      {"side1", {"object_side"}},
      {"side2", {"target_side"}},
      {"side", {"side"}},
      {"sides", {"sides"}},
      {"both", {"both"}},
      {"corner", {"corner"}},
      {"dist", {"distance_m"}},
      {"parallel", {"parallel"}},
      {"center", {"center"}},
      {"max_dist", {"max_distance_m", ""}},
      {"min_dist", {"min_distance_m", "min_clearance_m"}},
      {"weight", {""}}};
  const auto it = names.find(keyword);
  if (it == names.end()) return -1;
  const std::vector<FlairGptParameter>& parameters = function.parameters;
  // A tertiary's object_index is the floor object that it belongs to: its own comes first.
  const bool item_first = !parameters.empty() && parameters[0].kind == FlairGptKind::kItem;
  const bool of_floor = keyword == "object_index" || keyword == "other_index";
  for (size_t p = of_floor && item_first ? 1 : 0; p < parameters.size(); ++p) {
    if (std::find(it->second.begin(), it->second.end(), parameters[p].name) != it->second.end()) {
      return static_cast<int>(p);
    }
  }
  return -1;
}

}  // namespace flair::evaluation
