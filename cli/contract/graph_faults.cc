// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/graph_faults.h"

#include <limits>

#include "cli/contract/bedroom.h"

namespace flair::contract {
namespace {

using Graph = v1::LayoutGraph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kNoSuchValue = 99;

v1::Object& FirstObject(Graph& graph) { return *graph.mutable_object_list()->mutable_objects(0); }

v1::Placement& NewPin(Graph& graph, const std::string& object_id) {
  v1::Placement& pin = *graph.add_pinned_placements();
  pin.set_object_id(object_id);
  pin.set_x_m(2);
  pin.set_y_m(2);
  return pin;
}

v1::ConstraintEdge& NewEdge(Graph& graph) {
  *graph.add_edges() = EdgeOn("some_type", "object", "bed");
  return *graph.mutable_edges(graph.edges_size() - 1);
}

void TurnClockwise(v1::Polygon& floor) {
  for (int i = 0, k = floor.vertices_size() - 1; i < k; ++i, --k) floor.mutable_vertices()->SwapElements(i, k);
}

std::vector<Fault<Graph>> RoomFaults() {
  return {
      {"an empty problem", "layout_graph", [](Graph& graph) { graph.Clear(); }},
      {"a floor that runs clockwise", "room.floor",
       [](Graph& graph) { TurnClockwise(*graph.mutable_room()->mutable_floor()); }},
      {"a floor with a corner that is no number", "room.floor.vertices[1]",
       [](Graph& graph) { graph.mutable_room()->mutable_floor()->mutable_vertices(1)->set_x_m(kNaN); }},
      {"a floor of a kilometre", "room.floor",
       [](Graph& graph) {
         for (v1::Point2& p : *graph.mutable_room()->mutable_floor()->mutable_vertices()) p.set_x_m(250 * p.x_m());
       }},
      {"fewer walls than the floor has edges", "room.walls",
       [](Graph& graph) { graph.mutable_room()->mutable_walls()->RemoveLast(); }},
      {"a door in a wall that is not there", "openings[0].wall",
       [](Graph& graph) { graph.mutable_room()->mutable_openings(0)->set_wall("nort"); }},
      {"a door that is wider than its wall", "openings[0].width_m",
       [](Graph& graph) { graph.mutable_room()->mutable_openings(0)->set_width_m(7.2); }},
      {"two zones of one id", "zones[1].id",
       [](Graph& graph) { *graph.mutable_zone_plan()->add_zones() = graph.zone_plan().zones(0); }},
  };
}

std::vector<Fault<Graph>> ObjectFaults() {
  return {
      {"no objects", "object_list.objects", [](Graph& graph) { graph.mutable_object_list()->clear_objects(); }},
      {"two objects of one id", "objects[1].id",
       [](Graph& graph) { graph.mutable_object_list()->mutable_objects(1)->set_id("bed"); }},
      {"an object without an id", "objects[0].id", [](Graph& graph) { FirstObject(graph).set_id(""); }},
      {"a width that is no number", "objects[0].width_m", [](Graph& graph) { FirstObject(graph).set_width_m(kNaN); }},
      {"a width below zero", "objects[0].width_m", [](Graph& graph) { FirstObject(graph).set_width_m(-1); }},
      {"an infinite depth", "objects[0].depth_m", [](Graph& graph) { FirstObject(graph).set_depth_m(kInfinity); }},
      {"a height of zero", "objects[0].height_m", [](Graph& graph) { FirstObject(graph).set_height_m(0); }},
      {"a role that no enum has", "objects[0].role",
       [](Graph& graph) { FirstObject(graph).set_role(static_cast<v1::ObjectRole>(kNoSuchValue)); }},
      {"a kind that is not set", "objects[0].kind",
       [](Graph& graph) { FirstObject(graph).set_kind(v1::OBJECT_KIND_UNSPECIFIED); }},
      {"an object of a zone that is not there", "objects[0].zone_id",
       [](Graph& graph) { FirstObject(graph).set_zone_id("sleping"); }},
  };
}

std::vector<Fault<Graph>> EdgeFaults() {
  return {
      {"two edges of one id", "edges[1].id",
       [](Graph& graph) {
         NewEdge(graph);
         NewEdge(graph);
       }},
      {"an edge of weight zero", "edges[0].weight", [](Graph& graph) { NewEdge(graph).set_weight(0); }},
      {"an edge of a weight that is no number", "edges[0].weight",
       [](Graph& graph) { NewEdge(graph).set_weight(kNaN); }},
      {"an edge of a sentence that is not there", "edges[0].sentence_id",
       [](Graph& graph) { NewEdge(graph).set_sentence_id("s99"); }},
      {"a pin of an object that is not there", "pinned_placements[0].object_id",
       [](Graph& graph) { NewPin(graph, "ghost"); }},
      {"a pin at a place that is no number", "pinned_placements[0].x_m",
       [](Graph& graph) { NewPin(graph, "bed").set_x_m(kNaN); }},
      {"a pinned heading beyond a full turn", "pinned_placements[0].theta_rad",
       [](Graph& graph) { NewPin(graph, "bed").set_theta_rad(7); }},
  };
}

}  // namespace

const std::vector<Fault<v1::LayoutGraph>>& GraphFaults() {
  static const std::vector<Fault<Graph>> faults = [] {
    std::vector<Fault<Graph>> all = RoomFaults();
    for (auto* more : {&ObjectFaults, &EdgeFaults}) {
      for (Fault<Graph>& fault : more()) all.push_back(std::move(fault));
    }
    return all;
  }();
  return faults;
}

}  // namespace flair::contract
