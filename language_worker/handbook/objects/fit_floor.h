// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// [Handbook facts] the recorded rooms cover 20 to 29 % of the floor, small bedrooms up to 49 %.
inline constexpr double kCoverLimit = 0.45;

// A line of the program with its size and whether it is a primary.
struct SizedItem {
  ProgramItem item;
  double width_m = 0;
  double depth_m = 0;
  double height_m = 0;
  bool primary = false;
  const hb::Furniture* wanted = nullptr;  // the class that this smaller one stands in for; null when none

  double area_m2() const { return width_m * depth_m * item.count; }
};

// Something that had to go, and why.
struct LeftOut {
  std::string name;
  std::string reason;
  bool requested = false;
  int count = 1;  // so many
  int asked = 1;  // of so many

  // The reason, with the numbers where there were several.
  std::string Told() const;
};

// Extent of the floor's bounding box and its area.
struct FloorExtent {
  double width_m = 0;
  double depth_m = 0;
  double area_m2 = 0;
};

FloorExtent ExtentOf(const v1::Room& room);

// Gives the floor pieces sizes and makes them fit: shrinks them to their class's least size, takes smaller classes,
// then leaves out pieces, those that nobody asked for first, primaries last, and with a piece the seats that belong to
// it. At most 45 % of the floor is covered.
std::vector<SizedItem> FitFloor(const RoomProgram& program, const Handbook& handbook, const FloorExtent& floor,
                                std::vector<LeftOut>& left_out);

}  // namespace flair::language
