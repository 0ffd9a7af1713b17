// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
std::string_view FlairGptVocabulary();  // flairgpt_vocabulary.json, embedded
}

namespace flair::evaluation {
namespace {

using nlohmann::json;

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
