// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/readers/flairgpt_calls.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "fmt/format.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;

// How a recorded function maps to a type: "parameter:kind" in positional order; kinds: o floor object, i item, L list
// of floor objects, z zone, f feature, s side, S sides, c corner, n number, b flag, _ ignored.
struct Mapping {
  const char* type;
  const char* parameters;
};

const std::map<std::string, Mapping>& Mappings() {
  static const std::map<std::string, Mapping> mappings = {
      {"ind_next_to_wall", {"against_wall", "object:o side:s"}},
      {"ind_near_wall", {"near_wall", "object:o side:s max_distance_m:n"}},
      {"ind_in_corner", {"in_corner", "object:o side:s _:n"}},
      {"ind_close_to_fixed_object", {"close_to_feature", "object:o feature:f side:s max_distance_m:n"}},
      {"ind_away_from_fixed_object", {"away_from_feature", "object:o feature:f min_distance_m:n"}},
      {"ind_accessible", {"accessible", "object:o sides:S min_clearance_m:n"}},
      {"ind_central", {"central", "object:o both:b"}},
      {"ind_in_region", {"in_zone", "object:o zone:z _:n"}},
      {"ind_not_block_fixed_object", {"clear_of_feature", "object:o feature:f"}},
      {"ind_under_window", {"under_window", "object:o"}},
      {"ind_facing_into_room", {"facing_into_room", "object:o"}},
      {"ind_not_against_wall", {"not_against_wall", "object:o min_distance_m:n"}},
      {"io_next_to", {"next_to", "object:o target:o object_side:s target_side:s"}},
      {"io_away_from", {"away_from", "object:o target:o min_distance_m:n"}},
      {"io_near", {"near", "object:o target:o max_distance_m:n"}},
      {"io_parallel", {"parallel", "object:o target:o _:_ _:_"}},
      {"io_facing", {"facing", "object:o target:o both:b"}},
      {"io_not_facing", {"not_facing", "object:o target:o"}},
      {"io_infront", {"in_front_of", "object:o target:o distance_m:n parallel:b"}},
      {"io_perp", {"perpendicular", "object:o target:o center:o"}},
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
  return mappings;
}

// Names of other versions of the library and slips whose meaning is clear.
std::string Canonical(std::string name) {
  static const std::map<std::string, std::string> aliases = {
      {"io_min_dist", "io_away_from"},           {"ind_near_fixed_object", "ind_close_to_fixed_object"},
      {"ind_near", "ind_close_to_fixed_object"}, {"ind_not_next_to_wall", "ind_not_against_wall"},
      {"on_top_center", "on_top_central"},       {"io_under_central", "rug_under_central_floor"},
      {"on_wall_above", "on_wall_above_central"}};
  if (name.rfind("p_", 0) == 0) name = "io_" + name.substr(2);
  if (const auto it = aliases.find(name); it != aliases.end()) return it->second;
  if (Mappings().count(name) != 0) return name;
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"ind_", "io_"}, {"io_", "ind_"}}) {
    if (name.rfind(from, 0) != 0) continue;
    const std::string other = to + name.substr(from.size());
    if (Mappings().count(other) != 0) return other;
  }
  return name;
}

// The recorded keyword's position.
int PositionOf(const std::string& keyword, const std::vector<std::string>& parameters) {
  static const std::map<std::string, std::vector<std::string>> names = {
      {"object_index", {"object", "host", "target"}},
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
      {"max_dist", {"max_distance_m"}},
      {"min_dist", {"min_distance_m", "min_clearance_m"}},
      {"weight", {"_"}}};
  const auto it = names.find(keyword);
  if (it == names.end()) return -1;
  // A tertiary's object_index is its floor object: prefer the last match for host and target.
  const bool item_first = !parameters.empty() && parameters[0].back() == 'i';
  for (size_t p = keyword == "object_index" && item_first ? 1 : 0; p < parameters.size(); ++p) {
    const std::string name = parameters[p].substr(0, parameters[p].find(':'));
    if (std::find(it->second.begin(), it->second.end(), name) != it->second.end()) return static_cast<int>(p);
  }
  return -1;
}

class CallReader {
 public:
  explicit CallReader(const v1::LayoutGraph& graph) : graph_(graph) {}

  absl::StatusOr<v1::ConstraintEdge> Read(const json& call) const {
    const std::string function = Canonical(call.value("function", ""));
    if (function == "rug_under_central_floor")
      return absl::InvalidArgumentError("rugs among the furniture are not read");
    const auto it = Mappings().find(function);
    if (it == Mappings().end()) return absl::NotFoundError(fmt::format("unknown function {}", function));
    std::vector<std::string> parameters;
    std::istringstream words(it->second.parameters);
    for (std::string word; words >> word;) parameters.push_back(word);
    std::vector<json> values(parameters.size());
    absl::Status status = Assign(call, parameters, values);
    if (!status.ok()) return status;
    v1::ConstraintEdge edge;
    edge.set_type(it->second.type);
    edge.set_weight(1);
    for (size_t p = 0; p < parameters.size(); ++p) {
      const size_t colon = parameters[p].find(':');
      status = AddArgument(parameters[p].substr(0, colon), parameters[p].back(), values[p], edge);
      if (!status.ok()) return status;
    }
    return edge;
  }

 private:
  static absl::Status Assign(const json& call, const std::vector<std::string>& parameters, std::vector<json>& values) {
    json arguments = call.value("args", json::array());
    // A lone number after the object is the distance, whatever stands between.
    for (size_t p = 1; p < parameters.size() && p < arguments.size(); ++p) {
      const char kind = parameters[p].back();
      if ((kind == 's' || kind == 'S') && arguments[p].is_number()) arguments.insert(arguments.begin() + p, json());
    }
    if (arguments.size() > parameters.size()) return absl::InvalidArgumentError("too many arguments");
    std::copy(arguments.begin(), arguments.end(), values.begin());
    const json keywords = call.value("kwargs", json::object());
    for (const auto& [keyword, value] : keywords.items()) {
      const int p = PositionOf(keyword, parameters);
      if (p < 0) return absl::InvalidArgumentError(fmt::format("unknown keyword {}", keyword));
      values[p] = value;
    }
    return absl::OkStatus();
  }

  absl::StatusOr<std::string> ObjectId(json value, bool item) const {
    if (value.is_array() && value.size() == 1) value = json(value[0]);
    std::string id;
    if (value.is_number()) id = fmt::format("{}_{}", item ? "item" : "floor", static_cast<int>(value.get<double>()));
    int matches = 0;
    for (const v1::Object& object : graph_.object_list().objects()) {
      if (object.id() == id) return id;
      if (value.is_string() && object.name() == value.get<std::string>() && ++matches > 0) id = object.id();
    }
    if (value.is_string() && matches == 1) return id;
    return absl::NotFoundError(fmt::format("no object {}", value.dump()));
  }

  absl::StatusOr<std::string> Feature(const json& value) const {
    static const std::map<std::string, std::string> words = {{"window", "window"},
                                                             {"windows", "window"},
                                                             {"door", "door"},
                                                             {"doors", "door"},
                                                             {"doorway", "door"},
                                                             {"entrance", "door"},
                                                             {"socket", "socket"},
                                                             {"sockets", "socket"},
                                                             {"plug", "socket"},
                                                             {"outlet", "socket"},
                                                             {"power_outlet", "socket"},
                                                             {"power socket", "socket"},
                                                             {"electrical outlet", "socket"}};
    const auto it = value.is_string() ? words.find(value.get<std::string>()) : words.end();
    if (it == words.end()) return absl::NotFoundError(fmt::format("no feature {}", value.dump()));
    for (const v1::Opening& opening : graph_.room().openings()) {
      if (it->second == (opening.kind() == v1::OPENING_KIND_DOOR ? "door" : "window")) return it->second;
    }
    if (it->second == "socket" && graph_.room().sockets_size() > 0) return it->second;
    return absl::NotFoundError(fmt::format("the room has no {}", it->second));
  }

  absl::StatusOr<std::string> ZoneId(const json& value) const {
    for (const v1::Zone& zone : graph_.zone_plan().zones()) {
      if (value.is_string() &&
          (zone.name() == value || zone.name() + " area" == value || zone.name() + "_area" == value)) {
        return zone.id();
      }
    }
    return absl::NotFoundError(fmt::format("no zone {}", value.dump()));
  }

  static std::string SideName(const std::string& word) {
    static const std::map<std::string, std::string> names = {
        {"back", "back"},   {"top", "back"},     {"head", "back"},  {"headboard", "back"}, {"rear", "back"},
        {"front", "front"}, {"bottom", "front"}, {"foot", "front"}, {"left", "left"},      {"right", "right"}};
    const auto it = names.find(word);
    return it == names.end() ? "" : it->second;
  }

  absl::StatusOr<std::vector<std::string>> SideNames(const json& value, const std::string& object_id) const {
    std::vector<std::string> words, sides;
    if (value.is_string()) words.push_back(value);
    if (value.is_array()) {
      for (const json& word : value) words.push_back(word.is_string() ? word.get<std::string>() : "");
    }
    bool wide = true;
    for (const v1::Object& object : graph_.object_list().objects()) {
      if (object.id() == object_id) wide = object.width_m() >= object.depth_m();
    }
    const auto add = [&](std::initializer_list<const char*> names) {
      for (const char* name : names) {
        if (std::find(sides.begin(), sides.end(), name) == sides.end()) sides.push_back(name);
      }
    };
    for (const std::string& word : words) {
      const bool longer = word.rfind("long", 0) == 0 || word == "length";
      const bool shorter = word.rfind("short", 0) == 0 || word == "width";
      if (word == "all" || word == "every" || word == "all sides")
        add({"front", "back", "left", "right"});
      else if (word == "side" || word == "sides")
        add({"left", "right"});
      else if (longer || shorter)
        longer == wide ? add({"front", "back"}) : add({"left", "right"});
      else if (const std::string side = SideName(word); !side.empty())
        add({side.c_str()});
      else if (word == "one" || word == "any")
        return std::vector<std::string>{"front"};
      else
        return absl::InvalidArgumentError(fmt::format("unknown side {}", word));
    }
    return sides;
  }

  absl::Status AddArgument(const std::string& name, char kind, const json& value, v1::ConstraintEdge& edge) const {
    const bool required = kind == 'o' || kind == 'i' || kind == 'z' || kind == 'f' || kind == 'L';
    if (value.is_null() && required && name != "center") return absl::InvalidArgumentError(name + " is not given");
    if (value.is_null() || name == "_") return absl::OkStatus();
    v1::Argument argument;
    argument.set_name(name);
    v1::ArgumentValue& target = *argument.mutable_value();
    const auto text = [&](const absl::StatusOr<std::string>& found) {
      if (found.ok()) target.set_text(*found);
      return found.status();
    };
    absl::Status status;
    if (kind == 'o' || kind == 'i') {
      status = text(ObjectId(value, kind == 'i'));
    } else if (kind == 'z') {
      status = text(ZoneId(value));
    } else if (kind == 'f') {
      status = text(Feature(value));
    } else if (kind == 's') {
      absl::StatusOr<std::vector<std::string>> sides = SideNames(value, edge.arguments(0).value().text());
      if (!sides.ok()) return sides.status();
      if (sides->size() != 1) return absl::OkStatus();
      target.set_text(sides->front());
    } else if (kind == 'c') {
      static const std::map<std::string, std::string> corners = {
          {"tl", "back_left"}, {"tr", "back_right"}, {"br", "front_right"}, {"bl", "front_left"}};
      const auto it = value.is_string() ? corners.find(value.get<std::string>()) : corners.end();
      if (it == corners.end()) return absl::InvalidArgumentError("unknown corner " + value.dump());
      target.set_text(it->second);
    } else if (kind == 'b') {
      target.set_flag(value.is_boolean() && value.get<bool>());
    } else if (kind == 'n') {
      if (!value.is_number()) return absl::InvalidArgumentError(name + " is not a number");
      target.set_number(value.get<double>());
    } else {
      status = AddList(kind, value, edge, target);
      if (status.ok() && target.texts().items().empty()) return absl::OkStatus();
    }
    if (status.ok()) *edge.add_arguments() = std::move(argument);
    return status;
  }

  absl::Status AddList(char kind, const json& value, const v1::ConstraintEdge& edge, v1::ArgumentValue& target) const {
    if (kind == 'S') {
      absl::StatusOr<std::vector<std::string>> sides = SideNames(value, edge.arguments(0).value().text());
      if (!sides.ok()) return sides.status();
      for (const std::string& side : *sides) target.mutable_texts()->add_items(side);
      return absl::OkStatus();
    }
    if (!value.is_array()) return absl::InvalidArgumentError("not a list of objects");
    for (const json& item : value) {
      absl::StatusOr<std::string> id = ObjectId(item, false);
      if (!id.ok()) return id.status();
      target.mutable_texts()->add_items(*id);
    }
    return absl::OkStatus();
  }

  const v1::LayoutGraph& graph_;
};

}  // namespace

absl::StatusOr<v1::ConstraintEdge> ReadFlairGptCall(const json& call, const v1::LayoutGraph& graph) {
  return CallReader(graph).Read(call);
}

}  // namespace flair::evaluation
