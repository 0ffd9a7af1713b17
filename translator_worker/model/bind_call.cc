// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "llm/answers/read_answer.h"
#include "translator_worker/catalog/catalog_source.h"
#include "translator_worker/model/prompt_texts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::translator {
namespace {

using Values = std::vector<std::string>;

bool TakesList(v1::ParameterKind kind) {
  return kind == v1::PARAMETER_KIND_OBJECTS || kind == v1::PARAMETER_KIND_SIDES;
}

// "None", "null": as if it were not there.
bool IsAbsent(const WrittenArgument& argument) {
  static constexpr std::array<std::string_view, 5> kAbsent = {"", "none", "null", "default", "unspecified"};
  return argument.values.empty() || (argument.values.size() == 1 &&
                                     std::ranges::find(kAbsent, llm::Bare(argument.values.front())) != kAbsent.end());
}

// Gives the written arguments to the parameters of a type.
class Binder {
 public:
  Binder(const v1::ConstraintType& type, const ArgumentReader& reader) : type_(type), reader_(reader) {}

  absl::Status Add(const WrittenArgument& argument) {
    if (IsAbsent(argument)) {
      if (argument.name.empty()) ++next_;
      return absl::OkStatus();
    }
    if (argument.name.empty()) return AddByPlace(argument);
    const int parameter = Find(argument.name);
    if (parameter < 0) {
      return InvalidArgument("{} has no parameter {}; it has {}", type_.name(), llm::Quoted(argument.name), Names());
    }
    return Give(parameter, argument);
  }

  absl::StatusOr<std::vector<v1::Argument>> Read() const {
    std::vector<v1::Argument> arguments;
    for (int i = 0; i < type_.parameters_size(); ++i) {
      const auto given = given_.find(i);
      if (given == given_.end()) continue;
      const v1::ParameterSpec& parameter = type_.parameters(i);
      absl::StatusOr<v1::ArgumentValue> value = reader_.Read(parameter, given->second);
      if (!value.ok()) return InvalidArgument("{}.{}: {}", type_.name(), parameter.name(), value.status().message());
      v1::Argument& argument = arguments.emplace_back();
      argument.set_name(parameter.name());
      *argument.mutable_value() = *std::move(value);
    }
    return arguments;
  }

 private:
  int Find(const std::string& name) const {
    const std::string bare = llm::Bare(name);
    for (int i = 0; i < type_.parameters_size(); ++i) {
      const v1::ParameterSpec& parameter = type_.parameters(i);
      const std::string own = llm::Bare(parameter.name());
      // "max_distance" for max_distance_m
      if (own == bare || (!parameter.unit().empty() && own == bare + llm::Bare(parameter.unit()))) return i;
    }
    return -1;
  }

  std::string Names() const {
    Values names;
    for (const v1::ParameterSpec& parameter : type_.parameters()) names.push_back(parameter.name());
    return fmt::format("{}", fmt::join(names, ", "));
  }

  bool CanTake(int parameter, const Values& values) const {
    return reader_.Read(type_.parameters(parameter), values).ok();
  }

  absl::Status AddByPlace(const WrittenArgument& argument) {
    // "surround(table, chair_1, chair_2)": one list.
    const bool list = last_ >= 0 && TakesList(type_.parameters(last_).kind()) && !argument.in_brackets;
    if (list && CanTake(last_, argument.values)) return Give(last_, argument);
    int first = -1;
    for (int i = next_; i < type_.parameters_size(); ++i) {
      if (given_.contains(i)) continue;
      if (first < 0) first = i;
      if (CanTake(i, argument.values)) return Give(i, argument);
      if (type_.parameters(i).required()) break;
    }
    if (first >= 0) return Give(first, argument);
    return InvalidArgument("{} takes no further argument {}; it has {}", type_.name(),
                           llm::Quoted(argument.values.front()), Names());
  }

  absl::Status Give(int parameter, const WrittenArgument& argument) {
    Values& values = given_[parameter];
    if (!values.empty() && !TakesList(type_.parameters(parameter).kind()) && values != argument.values) {
      return InvalidArgument("{} is given {} twice; a call for each would be right", type_.name(),
                             type_.parameters(parameter).name());
    }
    if (values != argument.values) values.insert(values.end(), argument.values.begin(), argument.values.end());
    last_ = parameter;
    if (argument.name.empty()) next_ = std::max(next_, parameter + 1);
    return absl::OkStatus();
  }

  const v1::ConstraintType& type_;
  const ArgumentReader& reader_;
  std::map<int, Values> given_;
  int next_ = 0;
  int last_ = -1;
};

// The objects that a call is about, in any of its arguments.
Values ObjectsOf(const v1::ConstraintType& type, const Call& call) {
  Values ids;
  for (const v1::Argument& argument : call.arguments) {
    for (const v1::ParameterSpec& parameter : type.parameters()) {
      if (parameter.name() != argument.name()) continue;
      if (parameter.kind() == v1::PARAMETER_KIND_OBJECT) ids.push_back(argument.value().text());
      if (parameter.kind() != v1::PARAMETER_KIND_OBJECTS) continue;
      ids.insert(ids.end(), argument.value().texts().items().begin(), argument.value().texts().items().end());
    }
  }
  return ids;
}

const llm::Choices& Sides() {
  static const llm::Choices sides = {{"front", "back", "left", "right"}, {}};
  return sides;
}

const llm::Choices& Corners() {
  static const llm::Choices corners = {{"back_left", "back_right", "front_left", "front_right"},
                                       {{"left_back", "back_left"},
                                        {"right_back", "back_right"},
                                        {"left_front", "front_left"},
                                        {"right_front", "front_right"}}};
  return corners;
}

const llm::Choices& Flags() {
  static const llm::Choices flags = {{"true", "false"}, {{"yes", "true"}, {"no", "false"}}};
  return flags;
}

absl::StatusOr<double> ReadNumber(const v1::ParameterSpec& parameter, const std::string& value) {
  const std::optional<double> number = llm::ReadQuantity(value, parameter.unit());
  if (number.has_value() && std::isfinite(*number)) return *number;
  return InvalidArgument("{} is no number{}", llm::Quoted(value),
                         parameter.unit().empty() ? "" : " in " + parameter.unit());
}

}  // namespace

absl::StatusOr<Call> BindCall(const WrittenCall& written, const v1::ConstraintType& type, const ArgumentReader& reader,
                              std::vector<std::string>& remarks) {
  Binder binder(type, reader);
  for (const WrittenArgument& argument : written.arguments) RETURN_IF_ERROR(binder.Add(argument));
  Call call(type.name());
  ASSIGN_OR_RETURN(call.arguments, binder.Read());
  RETURN_IF_ERROR(CatalogIndex::Fit(type, call.arguments, remarks));
  Values objects = ObjectsOf(type, call);
  std::ranges::sort(objects);
  const auto twice = std::ranges::adjacent_find(objects);
  if (twice != objects.end()) return InvalidArgument("{} relates \"{}\" to itself", type.name(), *twice);
  return call;
}

ArgumentReader::ArgumentReader(const v1::TranslateRequest& request) {
  for (const v1::Object& object : request.object_list().objects()) {
    objects_.names.push_back(object.id());
    groups_[llm::Bare(object.name())].push_back(object.id());
  }
  for (const v1::Zone& zone : request.zone_plan().zones()) {
    zones_.names.push_back(zone.id());
    zones_.aliases.emplace(zone.name(), zone.id());
  }
  for (const v1::Wall& wall : request.room().walls()) {
    walls_.names.push_back(wall.name());
    walls_.aliases.emplace(wall.name() + " wall", wall.name());
  }
  features_ = {{"door", "window", "socket"},
               {{"electrical socket", "socket"}, {"outlet", "socket"}, {"power outlet", "socket"}}};
  for (const v1::Opening& opening : request.room().openings()) features_.names.push_back(opening.id());
}

absl::StatusOr<std::string> ArgumentReader::One(const llm::Choices& choices, const char* what,
                                                const std::string& value) const {
  if (std::optional<std::string> found = llm::FindChoice(value, choices)) return *std::move(found);
  constexpr size_t kMostShown = 12;
  const size_t shown = std::min(choices.names.size(), kMostShown);
  return InvalidArgument("{} is no {}; one of {}{} would be right", llm::Quoted(value), what,
                         fmt::join(choices.names.begin(), choices.names.begin() + shown, ", "),
                         shown < choices.names.size() ? ", ..." : "");
}

absl::StatusOr<std::vector<std::string>> ArgumentReader::ObjectIds(const std::string& value) const {
  for (const std::string& id : objects_.names) {
    if (id == value) return std::vector<std::string>{id};
  }
  // "dining chairs" is "dining chair" for all of them.
  std::string bare = llm::Bare(value);
  auto group = groups_.find(bare);
  if (group == groups_.end() && !bare.empty() && bare.back() == 's')
    group = groups_.find(bare.substr(0, bare.size() - 1));
  if (group != groups_.end()) return group->second;
  ASSIGN_OR_RETURN(std::string id, One(objects_, "object", value));
  return std::vector<std::string>{std::move(id)};
}

absl::StatusOr<v1::ArgumentValue> ArgumentReader::Single(const v1::ParameterSpec& parameter,
                                                         const std::string& value) const {
  v1::ArgumentValue result;
  absl::StatusOr<std::string> text;
  switch (parameter.kind()) {
    case v1::PARAMETER_KIND_NUMBER: {
      ASSIGN_OR_RETURN(const double number, ReadNumber(parameter, value));
      result.set_number(number);
      return result;
    }
    case v1::PARAMETER_KIND_BOOLEAN:
      text = One(Flags(), "truth value", value);
      if (!text.ok()) return text.status();
      result.set_flag(*text == "true");
      return result;
    case v1::PARAMETER_KIND_OBJECT: {
      ASSIGN_OR_RETURN(const std::vector<std::string> ids, ObjectIds(value));
      if (ids.size() > 1) {
        return InvalidArgument("{} means {} objects ({}); one of them would be right, in a call of its own",
                               llm::Quoted(value), ids.size(), fmt::join(ids, ", "));
      }
      text = ids.front();
      break;
    }
    case v1::PARAMETER_KIND_ZONE:
      text = One(zones_, "zone", value);
      break;
    case v1::PARAMETER_KIND_WALL:
      text = One(walls_, "wall", value);
      break;
    case v1::PARAMETER_KIND_FEATURE:
      text = One(features_, "feature", value);
      break;
    case v1::PARAMETER_KIND_SIDE:
      text = One(Sides(), "side", value);
      break;
    case v1::PARAMETER_KIND_CORNER:
      text = One(Corners(), "corner", value);
      break;
    default:
      text = value;
  }
  if (!text.ok()) return text.status();
  result.set_text(*std::move(text));
  return result;
}

absl::StatusOr<v1::ArgumentValue> ArgumentReader::Read(const v1::ParameterSpec& parameter,
                                                       std::span<const std::string> values) const {
  if (!TakesList(parameter.kind())) {
    if (values.size() != 1) {
      return InvalidArgument("{} has {} values; one would be right, or a call for each", parameter.name(),
                             values.size());
    }
    return Single(parameter, values.front());
  }
  v1::ArgumentValue result;
  v1::TextList& list = *result.mutable_texts();
  const auto add = [&list](const std::string& item) {
    if (std::ranges::find(list.items(), item) == list.items().end()) list.add_items(item);
  };
  for (const std::string& value : values) {
    if (parameter.kind() == v1::PARAMETER_KIND_SIDES) {
      ASSIGN_OR_RETURN(const std::string side, One(Sides(), "side", value));
      add(side);
      continue;
    }
    ASSIGN_OR_RETURN(const std::vector<std::string> ids, ObjectIds(value));
    for (const std::string& id : ids) add(id);
  }
  return result;
}

}  // namespace flair::translator
