// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/readers/flairgpt_calls.h"

#include <algorithm>
#include <optional>
#include <string>

#include "evaluation/readers/flairgpt_arguments.h"
#include "evaluation/readers/flairgpt_functions.h"
#include "fmt/format.h"
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
  if (call.function == nullptr) return absl::NotFoundError(fmt::format("unknown function {}", call.name));
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
      return absl::InvalidArgumentError(
          fmt::format("{} arguments, at most {} are known", arguments.size(), parameters.size()));
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
      return absl::InvalidArgumentError(fmt::format("unknown keyword {}", keyword));
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
    absl::StatusOr<std::optional<v1::Argument>> argument =
        arguments.Read(call.function->parameters[p], call.values[p], object_id);
    if (!argument.ok()) return argument.status();
    if (argument->has_value()) *edge.add_arguments() = **std::move(argument);
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

}  // namespace

absl::StatusOr<std::vector<v1::ConstraintEdge>> ReadFlairGptCall(const json& call, const v1::LayoutGraph& graph) {
  try {
    return Read(call, graph);
  } catch (const json::exception& error) {
    return absl::InvalidArgumentError(fmt::format("not a call: {}", error.what()));
  }
}

}  // namespace flair::evaluation
