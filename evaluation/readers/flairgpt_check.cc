// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "evaluation/readers/flairgpt_calls.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/status/status_macros.h"

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

// What a field should be: in words, and as a test.
struct Rule {
  std::string right;
  std::function<bool(const json&)> holds;
  bool required = true;
};

Rule Metres(double most, bool zero_too) {
  return {fmt::format("a number in {}0, {:g}], metres", zero_too ? '[' : '(', most), [=](const json& value) {
            const double size = value.is_number() ? value.get<double>() : -1;
            return size <= most && (size > 0 || (zero_too && size == 0));
          }};
}

Rule Text(std::string right, bool required) {
  return {std::move(right), [](const json& value) { return value.is_string(); }, required};
}

Rule Optional(Rule rule) {
  rule.required = false;
  return rule;
}

using Rules = std::vector<std::pair<const char*, Rule>>;

class Checker {
 public:
  absl::Status Check(const json& problem) {
    if (!problem.is_object()) return absl::InvalidArgumentError(Shown(problem) + " is not an object");
    const auto is_object = [](const json& value) { return value.is_object(); };
    const Rule room{"an object with width and length", is_object};
    const Rule calls{"an object with the calls of primary, secondary and tertiary", is_object};
    if (Holds(problem, "", "room", room)) {
      CheckFields(problem["room"], "room.",
                  {{"width", Metres(kLargestRoom_m, false)}, {"length", Metres(kLargestRoom_m, false)}});
    }
    const Rule wall{"south, east, north or west",
                    [](const json& value) {
                      static const std::set<std::string> walls = {"south", "east", "north", "west"};
                      return !value.is_string() || walls.contains(value.get<std::string>());
                    },
                    false};
    CheckList(problem, "fixed_objects", "an object with kind, width, wall and position",
              {{"kind", Text("text", false)}, {"width", Optional(Metres(kLargestRoom_m, true))}, {"wall", wall}});
    ForEach(problem, "zones", [&](const std::string& path, const json& name) {
      if (!name.is_string()) Fault(path, &name, "text, a name");
    });
    std::set<double> floor_indices, item_indices;
    for (const char* stage : {"primary", "secondary", "tertiary"}) {
      std::set<double>& indices = std::string_view(stage) == "tertiary" ? item_indices : floor_indices;
      const Rule index{"a whole number that no other such object has", [&](const json& value) {
                         const double number = value.is_number() ? value.get<double>() : -1;
                         return number >= 0 && number <= kLargestIndex && number == std::floor(number) &&
                                indices.insert(number).second;
                       }};
      CheckList(problem, stage, "an object with name, width, length and index",
                {{"name", Text("text", true)},
                 {"width", Metres(kLargestObject_m, true)},
                 {"length", Metres(kLargestObject_m, true)},
                 {"index", index},
                 {"zone", Text("text, the name of a zone", false)}});
    }
    if (Holds(problem, "", "calls", calls)) {
      const Rule list{"a list", [](const json& value) { return value.is_array(); }, false};
      CheckFields(problem["calls"], "calls.",
                  {{"primary", list}, {"secondary", list}, {"secondary_all", list}, {"tertiary", list}});
    }
    if (faults_.empty()) return absl::OkStatus();
    return InvalidArgument("{}", fmt::join(faults_, "; "));
  }

 private:
  // `value` null: it is missing.
  void Fault(const std::string& field, const json* value, const std::string& right) {
    if (faults_.size() == kMostFaults) return;
    faults_.push_back(value == nullptr ? fmt::format("{}: is missing; should be {}", field, right)
                                       : fmt::format("{}: {} should be {}", field, Shown(*value), right));
  }

  // Whether the member of that name is there and right; a fault when it is not.
  bool Holds(const json& object, const std::string& path, const char* name, const Rule& rule) {
    const auto it = object.find(name);
    const bool there = it != object.end();
    const bool right = there && rule.holds(*it);
    if (!right && (there || rule.required)) Fault(path + name, there ? &*it : nullptr, rule.right);
    return right;
  }

  void CheckFields(const json& object, const std::string& path, const Rules& rules) {
    for (const auto& [name, rule] : rules) Holds(object, path, name, rule);
  }

  void ForEach(const json& problem, const char* name, const auto& check) {
    const auto it = problem.find(name);
    if (it == problem.end()) return;
    if (!it->is_array()) return Fault(name, &*it, "a list");
    for (size_t i = 0; i < it->size(); ++i) check(fmt::format("{}[{}]", name, i), (*it)[i]);
  }

  void CheckList(const json& problem, const char* name, const char* right, const Rules& rules) {
    ForEach(problem, name, [&](const std::string& path, const json& member) {
      member.is_object() ? CheckFields(member, path + ".", rules) : Fault(path, &member, right);
    });
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
