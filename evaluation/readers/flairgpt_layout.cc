// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/readers/flairgpt_layout.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "evaluation/readers/flairgpt_arguments.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "room/geometry/pose.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;

absl::StatusOr<v1::SolvedLayout> ReadSolution(const json& problem, const v1::LayoutGraph& graph) {
  v1::SolvedLayout layout;
  *layout.mutable_graph() = graph;
  for (const char* stage : {"primary", "secondary", "tertiary"}) {
    const json objects = problem.value(stage, json::array());
    const json solution = problem.value("solution", json::object());
    const json poses = solution.value(stage, json::array());
    if (poses.size() != objects.size()) {
      return absl::NotFoundError(
          fmt::format("the recorded layout has {} {} poses for {} objects", poses.size(), stage, objects.size()));
    }
    for (size_t i = 0; i < poses.size(); ++i) {
      v1::Placement* placement = layout.add_placements();
      const bool tertiary = std::string_view(stage) == "tertiary";
      placement->set_object_id(FlairGptObjectId(tertiary, objects[i].at("index")));
      placement->set_x_m(poses[i].at(0));
      placement->set_y_m(poses[i].at(1));
      placement->set_theta_rad(WrapHeading(poses[i].at(2).get<double>()));
    }
  }
  return layout;
}

// The recording's index in an id of FlairGptObjectId; `otherwise` for the ids of graphs that were not imported.
int IndexOf(const std::string& id, int otherwise) {
  for (const std::string_view prefix : {"floor_", "item_"}) {
    if (id.rfind(prefix, 0) != 0) continue;
    int index = 0;
    const char* end = id.data() + id.size();
    const auto [read, error] = std::from_chars(id.data() + prefix.size(), end, index);
    if (error == std::errc() && read == end) return index;
  }
  return otherwise;
}

}  // namespace

absl::StatusOr<v1::SolvedLayout> ReadFlairGptSolution(const std::string& text, const v1::LayoutGraph& graph) {
  try {
    return ReadSolution(json::parse(text), graph);
  } catch (const json::exception& error) {
    return absl::NotFoundError(fmt::format("no recorded layout: {}", error.what()));
  }
}

std::string WriteFlairGptLayout(const v1::SolvedLayout& layout, const std::string& name, double seconds) {
  json objects = json::array();
  int floor_count = 0, item_count = 0;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    const bool tertiary = object.role() == v1::OBJECT_ROLE_TERTIARY;
    const int index = IndexOf(object.id(), tertiary ? item_count : floor_count);
    ++(tertiary ? item_count : floor_count);
    const auto placement = std::find_if(layout.placements().begin(), layout.placements().end(),
                                        [&](const v1::Placement& p) { return p.object_id() == object.id(); });
    if (placement == layout.placements().end()) continue;
    const char* role = tertiary ? "tertiary" : object.role() == v1::OBJECT_ROLE_PRIMARY ? "primary" : "secondary";
    objects.push_back({{"role", role},
                       {"index", index},
                       {"name", object.name()},
                       {"x", placement->x_m()},
                       {"y", placement->y_m()},
                       {"theta", placement->theta_rad()},
                       {"width", object.width_m()},
                       {"length", object.depth_m()}});
  }
  return json{{"name", name}, {"seconds", seconds}, {"objects", objects}}.dump(1, ' ', false,
                                                                               json::error_handler_t::replace) +
         "\n";
}

}  // namespace flair::evaluation
