// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/call_fault.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "fmt/format.h"

namespace flair::contract {
namespace {

// The names that a text of one kind of parameter may have.
struct Names {
  // Such as "a wall of the room".
  std::string what;
  std::vector<std::string> known;
};

// Nothing when every name will do: for other kinds, and for ids without a graph.
std::optional<Names> NamesOf(v1::ParameterKind kind, const v1::LayoutGraph* graph) {
  Names names;
  switch (kind) {
    case v1::PARAMETER_KIND_FEATURE:
      return Names{"a feature: door, window or socket", {"door", "window", "socket"}};
    case v1::PARAMETER_KIND_SIDE:
    case v1::PARAMETER_KIND_SIDES:
      return Names{"a side: front, back, left or right", {"front", "back", "left", "right"}};
    case v1::PARAMETER_KIND_CORNER:
      return Names{"a corner, such as back_left", {"back_left", "back_right", "front_right", "front_left"}};
    case v1::PARAMETER_KIND_OBJECT:
    case v1::PARAMETER_KIND_OBJECTS:
      if (graph == nullptr) return std::nullopt;
      names.what = "an object of the room";
      for (const v1::Object& object : graph->object_list().objects()) names.known.push_back(object.id());
      return names;
    case v1::PARAMETER_KIND_ZONE:
      if (graph == nullptr) return std::nullopt;
      names.what = "a zone of the room";
      for (const v1::Zone& zone : graph->zone_plan().zones()) names.known.push_back(zone.id());
      return names;
    case v1::PARAMETER_KIND_WALL:
      if (graph == nullptr) return std::nullopt;
      names.what = "a wall of the room";
      for (const v1::Wall& wall : graph->room().walls()) names.known.push_back(wall.name());
      return names;
    default:
      return std::nullopt;
  }
}

std::string TextFault(v1::ParameterKind kind, const std::string& text, const v1::LayoutGraph* graph) {
  if (text.empty()) return "is empty";
  const std::optional<Names> names = NamesOf(kind, graph);
  if (!names.has_value() || std::ranges::find(names->known, text) != names->known.end()) return "";
  return fmt::format("\"{}\" is not {}", text, names->what);
}

v1::ArgumentValue::ValueCase CaseOf(v1::ParameterKind kind) {
  switch (kind) {
    case v1::PARAMETER_KIND_OBJECTS:
    case v1::PARAMETER_KIND_SIDES:
      return v1::ArgumentValue::kTexts;
    case v1::PARAMETER_KIND_NUMBER:
      return v1::ArgumentValue::kNumber;
    case v1::PARAMETER_KIND_BOOLEAN:
      return v1::ArgumentValue::kFlag;
    default:
      return v1::ArgumentValue::kText;
  }
}

std::string NumberFault(const v1::ParameterSpec& parameter, double number) {
  const bool low = parameter.has_min_number() && !(number >= parameter.min_number());
  const bool high = parameter.has_max_number() && !(number <= parameter.max_number());
  if (!low && !high) return "";
  return fmt::format("{} is outside [{}, {}]", number,
                     parameter.has_min_number() ? fmt::format("{}", parameter.min_number()) : "-inf",
                     parameter.has_max_number() ? fmt::format("{}", parameter.max_number()) : "inf");
}

std::string ValueFault(const v1::ParameterSpec& parameter, const v1::ArgumentValue& value,
                       const v1::LayoutGraph* graph) {
  if (value.value_case() != CaseOf(parameter.kind())) {
    return fmt::format("holds another kind of value than {}", v1::ParameterKind_Name(parameter.kind()));
  }
  if (value.has_number()) return NumberFault(parameter, value.number());
  if (value.has_texts() && value.texts().items().empty()) return "is empty";
  for (const std::string& item : value.texts().items()) {
    if (std::string fault = TextFault(parameter.kind(), item, graph); !fault.empty()) return fault;
  }
  return value.value_case() == v1::ArgumentValue::kText ? TextFault(parameter.kind(), value.text(), graph) : "";
}

}  // namespace

std::string ArgumentsFault(const v1::ConstraintType& type, const Arguments& arguments, const v1::LayoutGraph* graph) {
  std::set<std::string> given;
  for (const v1::Argument& argument : arguments) {
    const auto parameter = std::ranges::find(type.parameters(), argument.name(), &v1::ParameterSpec::name);
    if (parameter == type.parameters().end()) {
      return fmt::format("\"{}\" is no parameter of {}", argument.name(), type.name());
    }
    if (!given.insert(argument.name()).second) return fmt::format("\"{}\" is given twice", argument.name());
    const std::string fault = ValueFault(*parameter, argument.value(), graph);
    if (!fault.empty()) return fmt::format("{}.{}: {}", type.name(), argument.name(), fault);
  }
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (parameter.required() && !given.contains(parameter.name())) {
      return fmt::format("{}.{} is required and missing", type.name(), parameter.name());
    }
  }
  return "";
}

std::string ParameterFault(const v1::ParameterSpec& parameter) {
  if (parameter.doc().empty()) return "has no doc";
  const bool numeric = parameter.kind() == v1::PARAMETER_KIND_NUMBER;
  if (!numeric && (parameter.has_min_number() || parameter.has_max_number() || !parameter.unit().empty())) {
    return "has a range or a unit, but is no number";
  }
  if (numeric && parameter.unit() != "m" && parameter.unit() != "rad" && !parameter.unit().empty()) {
    return fmt::format("has the unit \"{}\"; it must be \"m\", \"rad\" or \"\"", parameter.unit());
  }
  if (!parameter.has_default_value()) return "";
  const std::string fault = ValueFault(parameter, parameter.default_value(), nullptr);
  return fault.empty() ? "" : "its default " + fault;
}

}  // namespace flair::contract
