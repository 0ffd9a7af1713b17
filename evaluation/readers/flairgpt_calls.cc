// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/readers/flairgpt_calls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
std::string_view FlairGptVocabulary();  // flairgpt_vocabulary.json, embedded
}

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

const json& Vocabulary() {
  static const json& vocabulary = *new json(json::parse(FlairGptVocabulary()));
  return vocabulary;
}

// Of a row of the functions.
FlairGptFunction FunctionOf(const std::string& row) {
  FlairGptFunction function;
  std::istringstream words(row);
  words >> function.type;
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

constexpr size_t kMostFaults = 5;
constexpr size_t kLongestValue = 60;

std::string Shown(const json& value) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kLongestValue ? text : text.substr(0, kLongestValue) + "...";
}

// Holds a problem against the rules of flairgpt_vocabulary.json: what a field is, whether it must be there, what would
// be right, and the same of its fields or elements.
class Checker {
 public:
  using Rule = nlohmann::ordered_json;

  absl::Status Check(const json& problem) {
    if (!problem.is_object()) return absl::InvalidArgumentError(Shown(problem) + " is not an object");
    CheckFields(problem, "", Rule::parse(FlairGptVocabulary()).at("problem"));
    if (faults_.empty()) return absl::OkStatus();
    return InvalidArgument("{}", fmt::join(faults_, "; "));
  }

 private:
  // `value` null: it is missing.
  void Fault(const std::string& field, const json* value, const Rule& rule) {
    if (faults_.size() == kMostFaults) return;
    const std::string right = rule["right"];
    faults_.push_back(value == nullptr ? fmt::format("{}: is missing; should be {}", field, right)
                                       : fmt::format("{}: {} should be {}", field, Shown(*value), right));
  }

  bool Holds(const json& value, const Rule& rule) {
    const std::string is = rule["is"];
    const double number = value.is_number() ? value.get<double>() : -1;
    if (is == "object") return value.is_object();
    if (is == "list") return value.is_array();
    if (is == "text") return value.is_string();
    if (is == "metres") return number <= rule["most"] && (number > 0 || (rule["zero"] && number == 0));
    if (is == "wall")
      return !value.is_string() || value == "south" || value == "east" || value == "north" || value == "west";
    return number >= 0 && number <= kLargestIndex && number == std::floor(number) &&
           indices_.insert({is, number}).second;
  }

  void CheckFields(const json& object, const std::string& path, const Rule& rules) {
    for (const auto& [name, rule] : rules.items()) {
      const auto found = object.find(name);
      if (found != object.end()) {
        CheckValue(*found, path + name, rule);
      } else if (rule.value("required", false)) {
        Fault(path + name, nullptr, rule);
      }
    }
  }

  void CheckValue(const json& value, const std::string& path, const Rule& rule) {
    if (!Holds(value, rule)) return Fault(path, &value, rule);
    if (rule.contains("fields")) CheckFields(value, path + ".", rule["fields"]);
    for (size_t i = 0; rule.contains("each") && i < value.size(); ++i) {
      CheckValue(value[i], fmt::format("{}[{}]", path, i), rule["each"]);
    }
  }

  std::vector<std::string> faults_;
  std::set<std::pair<std::string, double>> indices_;
};

}  // namespace

const json* FlairGptMeaning(const char* list, const std::string& word) {
  const json& words = Vocabulary().at(list);
  const auto found = words.find(word);
  return found == words.end() ? nullptr : &*found;
}

absl::StatusOr<std::vector<v1::ConstraintEdge>> ReadFlairGptCall(const json& call, const v1::LayoutGraph& graph) {
  try {
    return Read(call, graph);
  } catch (const json::exception& error) {
    return InvalidArgument("not a call: {}", error.what());
  }
}

std::string CanonicalFlairGptName(std::string name) {
  if (name.rfind("p_", 0) == 0) name = "io_" + name.substr(2);
  if (const json* alias = FlairGptMeaning("aliases", name)) return *alias;
  if (FindFlairGptFunction(name) != nullptr) return name;
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"ind_", "io_"}, {"io_", "ind_"}}) {
    if (name.rfind(from, 0) != 0) continue;
    const std::string other = to + name.substr(from.size());
    if (FindFlairGptFunction(other) != nullptr) return other;
  }
  return name;
}

const FlairGptFunction* FindFlairGptFunction(const std::string& canonical_name) {
  static const std::map<std::string, FlairGptFunction> functions = [] {
    std::map<std::string, FlairGptFunction> map;
    for (const auto& [name, row] : Vocabulary()["functions"].items()) map.emplace(name, FunctionOf(row));
    return map;
  }();
  const auto it = functions.find(canonical_name);
  return it == functions.end() ? nullptr : &it->second;
}

int PositionOfKeyword(const std::string& keyword, const FlairGptFunction& function) {
  // The empty name is that of what is ignored.
  const json* const names = FlairGptMeaning("keywords", keyword);
  if (names == nullptr) return -1;
  const std::vector<FlairGptParameter>& parameters = function.parameters;
  // A tertiary's object_index is the floor object that it belongs to: its own comes first.
  const bool item_first = !parameters.empty() && parameters[0].kind == FlairGptKind::kItem;
  const bool of_floor = keyword == "object_index" || keyword == "other_index";
  for (size_t p = of_floor && item_first ? 1 : 0; p < parameters.size(); ++p) {
    if (std::find(names->begin(), names->end(), parameters[p].name) != names->end()) return static_cast<int>(p);
  }
  return -1;
}

absl::StatusOr<json> ParseFlairGptText(const std::string& text) {
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 2, column 1: syntax error ...": the library's own names say
    // nothing to the one who wrote the file.
    std::string what = error.what();
    if (const size_t end = what.find("] "); end != std::string::npos) what = what.substr(end + 2);
    return absl::InvalidArgumentError("not JSON: " + what);
  }
}

absl::Status CheckFlairGptProblem(const json& problem) {
  try {
    return Checker().Check(problem);
  } catch (const json::exception& error) {
    return absl::InvalidArgumentError(error.what());
  }
}

}  // namespace flair::evaluation
