// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/testing/sample_rooms.h"

#include "renderer_worker/scene/room_shape.h"

namespace flair::renderer {
namespace {

v1::SolvedLayout RoomOf(std::initializer_list<std::pair<double, double>> corners) {
  v1::SolvedLayout layout;
  v1::Room& room = *layout.mutable_graph()->mutable_room();
  for (const auto& [x, y] : corners) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(x);
    vertex.set_y_m(y);
    room.add_walls()->set_name("wall_" + std::to_string(room.walls_size()));
  }
  room.set_height_m(2.6);
  return layout;
}

v1::Opening& AddOpening(v1::SolvedLayout& layout, const std::string& wall, double offset_m, double width_m) {
  v1::Room& room = *layout.mutable_graph()->mutable_room();
  v1::Opening& opening = *room.add_openings();
  opening.set_id("opening_" + std::to_string(room.openings_size()));
  opening.set_wall(wall);
  opening.set_offset_m(offset_m);
  opening.set_width_m(width_m);
  opening.set_head_height_m(2.1);
  return opening;
}

}  // namespace

v1::SolvedLayout EmptyRoom(double width_m, double depth_m) {
  return RoomOf({{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}});
}

v1::SolvedLayout LShapedRoom() {
  v1::SolvedLayout layout = RoomOf({{0, 0}, {6, 0}, {6, 5}, {3, 5}, {3, 2.5}, {0, 2.5}});
  AddWindow(layout, "wall_1", 2, 1.6);
  AddDoor(layout, "wall_2", 3);
  return layout;
}

void AddWindow(v1::SolvedLayout& layout, const std::string& wall, double offset_m, double width_m) {
  v1::Opening& window = AddOpening(layout, wall, offset_m, width_m);
  window.set_kind(v1::OPENING_KIND_WINDOW);
  window.set_sill_height_m(0.9);
}

void AddDoor(v1::SolvedLayout& layout, const std::string& wall, double offset_m) {
  v1::Opening& door = AddOpening(layout, wall, offset_m, 0.9);
  door.set_kind(v1::OPENING_KIND_DOOR);
  door.mutable_leaf()->set_hinge(v1::HINGE_SIDE_START);
  door.mutable_leaf()->set_swing(v1::DOOR_SWING_INWARD);
  door.mutable_leaf()->set_swing_angle_rad(1.5);
}

void AddObject(v1::SolvedLayout& layout, const std::string& id, double x_m, double y_m, double theta_rad) {
  v1::Object& object = *layout.mutable_graph()->mutable_object_list()->add_objects();
  object.set_id(id);
  object.set_name(id);
  object.set_role(v1::OBJECT_ROLE_PRIMARY);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_width_m(1);
  object.set_depth_m(0.6);
  object.set_height_m(0.8);
  v1::Placement& placement = *layout.add_placements();
  placement.set_object_id(id);
  placement.set_x_m(x_m);
  placement.set_y_m(y_m);
  placement.set_theta_rad(theta_rad);
}

Furnishing BoxFurniture::FurnishingOf(const v1::Object& object, const v1::ObjectStyle*,
                                      std::vector<v1::Diagnostic>&) const {
  const float width = static_cast<float>(object.width_m()), depth = static_cast<float>(object.depth_m()),
              height = static_cast<float>(object.height_m());
  Material material;
  material.name = "box";
  material.colour = colour_;
  MeshBuilder builder;
  builder.Box(material, Axes{}, {-width / 2, -depth / 2, 0}, {width / 2, depth / 2, height});
  Furnishing furnishing;
  furnishing.class_name = "box";
  furnishing.mesh = std::make_shared<Mesh>(builder.Take());
  if (object.name() == "lamp") furnishing.lights.push_back({.position = {0, 0, height + 0.3F}});
  return furnishing;
}

}  // namespace flair::renderer
