// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/argument_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fmt/format.h"
#include "llm/answers/fault.h"
#include "llm/answers/quantity.h"

namespace flair::translator {
namespace {

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

const llm::Choices& Features() {
  static const llm::Choices features = {
      {"door", "window", "socket"},
      {{"electrical socket", "socket"}, {"outlet", "socket"}, {"power outlet", "socket"}}};
  return features;
}

const llm::Choices& Flags() {
  static const llm::Choices flags = {{"true", "false"}, {{"yes", "true"}, {"no", "false"}}};
  return flags;
}

absl::StatusOr<double> ReadNumber(const v1::ParameterSpec& parameter, const std::string& value) {
  const std::optional<double> number = llm::ReadQuantity(value, parameter.unit());
  if (number.has_value() && std::isfinite(*number)) return *number;
  return absl::InvalidArgumentError(
      fmt::format("{} is no number{}", llm::Quoted(value), parameter.unit().empty() ? "" : " in " + parameter.unit()));
}

bool TakesList(v1::ParameterKind kind) {
  return kind == v1::PARAMETER_KIND_OBJECTS || kind == v1::PARAMETER_KIND_SIDES;
}

}  // namespace

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
}

absl::StatusOr<std::string> ArgumentReader::One(const llm::Choices& choices, const char* what,
                                                const std::string& value) const {
  if (std::optional<std::string> found = llm::FindChoice(value, choices)) return *std::move(found);
  constexpr size_t kMostShown = 12;
  const size_t shown = std::min(choices.names.size(), kMostShown);
  return absl::InvalidArgumentError(fmt::format("{} is no {}; one of {}{} would be right", llm::Quoted(value), what,
                                                fmt::join(choices.names.begin(), choices.names.begin() + shown, ", "),
                                                shown < choices.names.size() ? ", ..." : ""));
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
  absl::StatusOr<std::string> id = One(objects_, "object", value);
  if (!id.ok()) return id.status();
  return std::vector<std::string>{*std::move(id)};
}

absl::StatusOr<v1::ArgumentValue> ArgumentReader::Single(const v1::ParameterSpec& parameter,
                                                         const std::string& value) const {
  v1::ArgumentValue result;
  absl::StatusOr<std::string> text;
  switch (parameter.kind()) {
    case v1::PARAMETER_KIND_NUMBER: {
      const absl::StatusOr<double> number = ReadNumber(parameter, value);
      if (!number.ok()) return number.status();
      result.set_number(*number);
      return result;
    }
    case v1::PARAMETER_KIND_BOOLEAN:
      text = One(Flags(), "truth value", value);
      if (!text.ok()) return text.status();
      result.set_flag(*text == "true");
      return result;
    case v1::PARAMETER_KIND_OBJECT: {
      absl::StatusOr<std::vector<std::string>> ids = ObjectIds(value);
      if (!ids.ok()) return ids.status();
      if (ids->size() > 1) {
        return absl::InvalidArgumentError(
            fmt::format("{} means {} objects ({}); one of them would be right, in a call of its own",
                        llm::Quoted(value), ids->size(), fmt::join(*ids, ", ")));
      }
      text = ids->front();
      break;
    }
    case v1::PARAMETER_KIND_ZONE:
      text = One(zones_, "zone", value);
      break;
    case v1::PARAMETER_KIND_WALL:
      text = One(walls_, "wall", value);
      break;
    case v1::PARAMETER_KIND_FEATURE:
      text = One(Features(), "feature", value);
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
      return absl::InvalidArgumentError(
          fmt::format("{} has {} values; one would be right, or a call for each", parameter.name(), values.size()));
    }
    return Single(parameter, values.front());
  }
  v1::ArgumentValue result;
  v1::TextList& list = *result.mutable_texts();
  const auto add = [&list](const std::string& item) {
    if (std::find(list.items().begin(), list.items().end(), item) == list.items().end()) list.add_items(item);
  };
  for (const std::string& value : values) {
    if (parameter.kind() == v1::PARAMETER_KIND_SIDES) {
      absl::StatusOr<std::string> side = One(Sides(), "side", value);
      if (!side.ok()) return side.status();
      add(*side);
      continue;
    }
    absl::StatusOr<std::vector<std::string>> ids = ObjectIds(value);
    if (!ids.ok()) return ids.status();
    for (const std::string& id : *ids) add(id);
  }
  return result;
}

}  // namespace flair::translator
