// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// Rooms and furniture for tests of what is made of scenes.

// A rectangular room `width_m` east, `depth_m` north; no openings, nothing in it.
v1::SolvedLayout EmptyRoom(double width_m, double depth_m);
// An L: 6 m x 5 m without its north-western quarter; a window in the south wall and a door in the east one.
v1::SolvedLayout LShapedRoom();
void AddWindow(v1::SolvedLayout& layout, const std::string& wall, double offset_m, double width_m);
void AddDoor(v1::SolvedLayout& layout, const std::string& wall, double offset_m);
// A box of 1 x 0.6 x 0.8 m at (x, y), heading `theta_rad`.
void AddObject(v1::SolvedLayout& layout, const std::string& id, double x_m, double y_m, double theta_rad);

// Every object as a box that fills it, in a colour; objects called "lamp" shine.
class BoxFurniture final : public FurnishingSource {
 public:
  explicit BoxFurniture(Vec3 colour = {0.5F, 0.3F, 0.2F}) : colour_(colour) {}
  Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                          std::vector<v1::Diagnostic>& diagnostics) const override;

 private:
  Vec3 colour_;
};

}  // namespace flair::renderer
