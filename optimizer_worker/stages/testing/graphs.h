// SPDX-License-Identifier: GPL-3.0-or-later
// Small problems as text, for tests of the stages and of what is built on them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "flair/v1/solved_layout.pb.h"
#include "fmt/format.h"
#include "google/protobuf/text_format.h"

namespace flair::optimizer {

inline v1::LayoutGraph Parse(const std::string& text) {
  v1::LayoutGraph graph;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &graph));
  return graph;
}

inline std::string RoomText(double width_m, double depth_m) {
  return fmt::format(
      R"(room {{
        room_type: "bedroom"
        floor {{ vertices {{}} vertices {{ x_m: {0} }} vertices {{ x_m: {0} y_m: {1} }} vertices {{ y_m: {1} }} }}
        walls {{ name: "south" }} walls {{ name: "east" }} walls {{ name: "north" }} walls {{ name: "west" }}
        height_m: 3
        openings {{ id: "door_1" kind: OPENING_KIND_DOOR wall: "south" offset_m: 0.1 width_m: 0.8 head_height_m: 2.1
                    leaf {{ hinge: HINGE_SIDE_START swing: DOOR_SWING_INWARD swing_angle_rad: 1.5707963 }} }}
      }}
      zone_plan {{ zones {{ id: "sleeping" name: "sleeping" }} }})",
      width_m, depth_m);
}

inline std::string ObjectText(const char* id, const char* role, const char* kind, double width_m, double depth_m) {
  return fmt::format(R"(objects {{ id: "{0}" name: "{0}" role: OBJECT_ROLE_{1} kind: OBJECT_KIND_{2} zone_id: "sleeping"
                                   width_m: {3} depth_m: {4} height_m: 0.6 elevation_m: {5} }})",
                     id, role, kind, width_m, depth_m, std::string(kind) == "WALL" ? 1.5 : 0.0);
}

inline std::string EdgeText(const char* id, const char* type, const std::string& arguments) {
  return fmt::format(R"(edges {{ id: "{}" type: "{}" weight: 1 {} }})", id, type, arguments);
}

inline std::string Text(const char* name, const char* value) {
  return fmt::format(R"(arguments {{ name: "{}" value {{ text: "{}" }} }})", name, value);
}

// A bed with its head to a wall, a nightstand at its left, a picture above it, a lamp on the nightstand.
inline v1::LayoutGraph Bedroom() {
  return Parse(RoomText(4, 4) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 2.0) +
               ObjectText("nightstand", "SECONDARY", "FLOOR", 0.5, 0.4) +
               ObjectText("picture", "TERTIARY", "WALL", 0.8, 0.05) +
               ObjectText("lamp", "TERTIARY", "SURFACE", 0.2, 0.2) + "}" +
               EdgeText("e1", "against_wall", Text("object", "bed")) +
               EdgeText("e2", "next_to",
                        Text("object", "nightstand") + Text("target", "bed") + Text("object_side", "right") +
                            Text("target_side", "left")) +
               EdgeText("e3", "on_wall_above", Text("object", "picture") + Text("target", "bed")) +
               EdgeText("e4", "on_top_center", Text("object", "lamp") + Text("host", "nightstand")) +
               EdgeText("e5", "no_such_type", Text("object", "bed")));
}

inline const v1::Placement& PlacementOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == id) return placement;
  }
  ADD_FAILURE() << id << " is not placed";
  return v1::Placement::default_instance();
}

}  // namespace flair::optimizer
