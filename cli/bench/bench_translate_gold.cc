// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_translate_gold.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "evaluation/readers/flairgpt_arguments.h"
#include "evaluation/readers/flairgpt_functions.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using evaluation::FlairGptFunction;
using evaluation::FlairGptKind;
using evaluation::FlairGptParameter;
using nlohmann::json;

std::string Text(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

v1::Argument& AddArgument(const std::string& name, v1::ConstraintEdge& edge) {
  v1::Argument& argument = *edge.add_arguments();
  argument.set_name(name);
  return argument;
}

absl::Status AddObjects(const json& objects, const FlairGptFunction& function, const v1::LayoutGraph& room,
                        v1::ConstraintEdge& edge) {
  size_t next = 0;
  for (const FlairGptParameter& parameter : function.parameters) {
    const bool list = parameter.kind == FlairGptKind::kFloorObjects;
    const bool one = parameter.kind == FlairGptKind::kFloorObject || parameter.kind == FlairGptKind::kItem;
    if ((!list && !one) || (!parameter.required && next >= objects.size())) continue;
    if (next >= objects.size()) return absl::InvalidArgumentError(fmt::format("objects: too few for {}", edge.type()));
    v1::ArgumentValue& value = *AddArgument(parameter.name, edge).mutable_value();
    do {
      const absl::StatusOr<std::string> id = ReadGoldObject(objects[next++], room);
      if (!id.ok()) return id.status();
      if (one) value.set_text(*id);
      if (list) value.mutable_texts()->add_items(*id);
    } while (list && next < objects.size());
  }
  if (next == objects.size()) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format("objects: too many for {}", edge.type()));
}

absl::Status AddParameter(const std::string& name, const json& given, const FlairGptFunction& function,
                          const v1::LayoutGraph& room, v1::ConstraintEdge& edge) {
  const std::string keyword = name == "type" ? "fixed_object_type" : name == "zone" ? "region_name" : name;
  const int position = evaluation::PositionOfKeyword(keyword, function);
  if (position < 0) return absl::InvalidArgumentError(fmt::format("params: {} has no {}", edge.type(), name));
  const std::string object = edge.arguments_size() > 0 ? edge.arguments(0).value().text() : "";
  absl::StatusOr<std::optional<v1::Argument>> argument =
      evaluation::FlairGptArguments(room).Read(function.parameters[position], given, object);
  if (!argument.ok()) return argument.status();
  if (argument->has_value()) *edge.add_arguments() = **std::move(argument);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::string> ReadGoldObject(const json& index, const v1::LayoutGraph& room) {
  std::string id;
  if (index.is_number_integer()) id = fmt::format("floor_{}", index.get<int64_t>());
  if (index.is_string() && index.get<std::string>().rfind('t', 0) == 0)
    id = "item_" + index.get<std::string>().substr(1);
  const auto& objects = room.object_list().objects();
  const bool known = std::any_of(objects.begin(), objects.end(), [&](const auto& object) { return object.id() == id; });
  if (known) return id;
  return absl::NotFoundError(
      fmt::format("the room has no object {}; wanted is an index such as 3 or \"t3\"", Text(index)));
}

absl::StatusOr<v1::ConstraintEdge> ReadGoldCall(const json& call, const v1::LayoutGraph& room) {
  if (!call.is_object() || !call.contains("function") || !call["function"].is_string() || !call.contains("objects") ||
      !call["objects"].is_array()) {
    return absl::InvalidArgumentError(fmt::format("gold: {} is no call with function and objects", Text(call)));
  }
  const std::string name = call["function"];
  const FlairGptFunction* function = evaluation::FindFlairGptFunction(evaluation::CanonicalFlairGptName(name));
  if (function == nullptr) return absl::NotFoundError(fmt::format("gold: unknown function {}", name));
  v1::ConstraintEdge edge;
  edge.set_type(function->type);
  if (absl::Status status = AddObjects(call["objects"], *function, room, edge); !status.ok()) return status;
  const json params = call.value("params", json::object());
  if (!params.is_object()) return absl::InvalidArgumentError("gold: params is not an object");
  for (const auto& [key, value] : params.items()) {
    if (absl::Status status = AddParameter(key, value, *function, room, edge); !status.ok()) return status;
  }
  return edge;
}

}  // namespace flair::cli
