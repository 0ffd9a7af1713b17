// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/readers/flairgpt_check.h"

#include <cmath>
#include <set>
#include <vector>

#include "evaluation/readers/flairgpt_arguments.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;

constexpr size_t kMostFaults = 5;
constexpr size_t kLongestValue = 60;
constexpr double kLargestRoom_m = 100, kLargestObject_m = 20;

std::string Shown(const json& value) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kLongestValue ? text : text.substr(0, kLongestValue) + "...";
}

class Checker {
 public:
  absl::Status Check(const json& problem) {
    if (!problem.is_object()) return absl::InvalidArgumentError(Shown(problem) + " is not an object");
    if (const json* room = Member(problem, "", "room", "an object with width and length"); room != nullptr) {
      if (room->is_object()) {
        Size(*room, "room", "width", kLargestRoom_m, /*zero_too=*/false);
        Size(*room, "room", "length", kLargestRoom_m, /*zero_too=*/false);
      } else {
        Fault("room", room, "an object with width and length");
      }
    }
    CheckFixedObjects(problem);
    CheckZones(problem);
    std::set<int> floor_indices, item_indices;
    CheckObjects(problem, "primary", floor_indices);
    CheckObjects(problem, "secondary", floor_indices);
    CheckObjects(problem, "tertiary", item_indices);
    CheckCalls(problem);
    if (faults_.empty()) return absl::OkStatus();
    return absl::InvalidArgumentError(fmt::format("{}", fmt::join(faults_, "; ")));
  }

 private:
  // `value` null: it is missing.
  void Fault(const std::string& field, const json* value, const std::string& right) {
    if (faults_.size() == kMostFaults) return;
    faults_.push_back(value == nullptr ? fmt::format("{}: is missing; should be {}", field, right)
                                       : fmt::format("{}: {} should be {}", field, Shown(*value), right));
  }

  // The member of that name; null, and a fault, when there is none.
  const json* Member(const json& object, const std::string& path, const char* name, const char* right) {
    const auto it = object.find(name);
    if (it != object.end()) return &*it;
    Fault(path + name, nullptr, right);
    return nullptr;
  }

  void Size(const json& object, const std::string& path, const char* name, double most, bool zero_too) {
    const std::string right = fmt::format("a number in {}0, {:g}], metres", zero_too ? '[' : '(', most);
    const json* const value = Member(object, path + ".", name, right.c_str());
    if (value == nullptr) return;
    const bool good = value->is_number() && value->get<double>() <= most &&
                      (value->get<double>() > 0 || (zero_too && value->get<double>() == 0));
    if (!good) Fault(path + "." + name, value, right);
  }

  // The list of that name, with the paths of its members; none and a fault when it is no list.
  std::vector<std::pair<std::string, const json*>> List(const json& object, const std::string& name) {
    std::vector<std::pair<std::string, const json*>> members;
    const auto it = object.find(name);
    if (it == object.end()) return members;
    if (!it->is_array()) {
      Fault(name, &*it, "a list");
      return members;
    }
    for (size_t i = 0; i < it->size(); ++i) members.emplace_back(fmt::format("{}[{}]", name, i), &(*it)[i]);
    return members;
  }

  void CheckFixedObjects(const json& problem) {
    for (const auto& [path, feature] : List(problem, "fixed_objects")) {
      if (!feature->is_object()) {
        Fault(path, feature, "an object with kind, width, wall and position");
        continue;
      }
      if (feature->contains("kind") && !(*feature)["kind"].is_string())
        Fault(path + ".kind", &(*feature)["kind"], "text");
      if (feature->contains("width")) Size(*feature, path, "width", kLargestRoom_m, /*zero_too=*/true);
      const json wall = feature->value("wall", json());
      static const std::set<std::string> walls = {"south", "east", "north", "west"};
      if (wall.is_string() && walls.count(wall.get<std::string>()) == 0) {
        Fault(path + ".wall", &wall, "south, east, north or west");
      }
    }
  }

  void CheckZones(const json& problem) {
    for (const auto& [path, name] : List(problem, "zones")) {
      if (!name->is_string()) Fault(path, name, "text, a name");
    }
  }

  void CheckObjects(const json& problem, const char* stage, std::set<int>& indices) {
    for (const auto& [path, object] : List(problem, stage)) {
      if (!object->is_object()) {
        Fault(path, object, "an object with name, width, length and index");
        continue;
      }
      const json* const name = Member(*object, path + ".", "name", "text");
      if (name != nullptr && !name->is_string()) Fault(path + ".name", name, "text");
      Size(*object, path, "width", kLargestObject_m, /*zero_too=*/true);
      Size(*object, path, "length", kLargestObject_m, /*zero_too=*/true);
      CheckIndex(*object, path, indices);
      const json zone = object->value("zone", json(""));
      if (!zone.is_string()) Fault(path + ".zone", &zone, "text, the name of a zone");
    }
  }

  void CheckIndex(const json& object, const std::string& path, std::set<int>& indices) {
    constexpr char kRight[] = "a whole number that no other such object has";
    const json* const index = Member(object, path + ".", "index", kRight);
    if (index == nullptr) return;
    const double value = index->is_number() ? index->get<double>() : -1;
    const bool whole = value >= 0 && value <= kLargestIndex && value == std::floor(value);
    if (!whole || !indices.insert(static_cast<int>(value)).second) Fault(path + ".index", index, kRight);
  }

  void CheckCalls(const json& problem) {
    const json* const calls =
        Member(problem, "", "calls", "an object with the calls of primary, secondary and tertiary");
    if (calls == nullptr) return;
    if (!calls->is_object())
      return Fault("calls", calls, "an object with the calls of primary, secondary and tertiary");
    for (const char* stage : {"primary", "secondary", "secondary_all", "tertiary"}) {
      const auto it = calls->find(stage);
      if (it != calls->end() && !it->is_array()) Fault(std::string("calls.") + stage, &*it, "a list");
    }
  }

  std::vector<std::string> faults_;
};

}  // namespace

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
