// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/geometry/footprint.h"

namespace flair {

std::string_view SideName(Side side) {
  switch (side) {
    case Side::kFront:
      return "front";
    case Side::kBack:
      return "back";
    case Side::kLeft:
      return "left";
    case Side::kRight:
      return "right";
  }
  return "";
}

std::optional<Side> SideFromName(std::string_view name) {
  for (Side side : kSides) {
    if (name == SideName(side)) return side;
  }
  return std::nullopt;
}

std::string_view CornerName(Corner corner) {
  switch (corner) {
    case Corner::kBackLeft:
      return "back_left";
    case Corner::kBackRight:
      return "back_right";
    case Corner::kFrontRight:
      return "front_right";
    case Corner::kFrontLeft:
      return "front_left";
  }
  return "";
}

std::optional<Corner> CornerFromName(std::string_view name) {
  for (Corner corner : {Corner::kBackLeft, Corner::kBackRight, Corner::kFrontRight, Corner::kFrontLeft}) {
    if (name == CornerName(corner)) return corner;
  }
  return std::nullopt;
}

}  // namespace flair
