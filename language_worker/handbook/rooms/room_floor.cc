// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/room_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flair::language {
namespace {

constexpr double kLeastArmM = 1.5;

struct Corner {
  double x_m = 0;
  double y_m = 0;
};
using Outline = std::vector<Corner>;

// Differences of lengths are off by rounding.
double Micrometres(double length_m) { return std::round(length_m * 1e6) / 1e6; }

const char* NameOf(RoomShape shape) { return shape == RoomShape::kL ? "L" : shape == RoomShape::kT ? "T" : "U"; }

double ShareOf(RoomShape shape) {
  return shape == RoomShape::kL ? 21.0 / 25 : shape == RoomShape::kT ? 3.0 / 4 : 5.0 / 6;
}

// As drawn before it is turned; w along x. Counter-clockwise.
Outline Upright(RoomShape shape, double w, double d) {
  if (shape == RoomShape::kL) {
    const double x = w - RoundToStep(2 * w / 5), y = d - RoundToStep(2 * d / 5);
    return {{0, 0}, {w, 0}, {w, y}, {x, y}, {x, d}, {0, d}};
  }
  if (shape == RoomShape::kT) {
    const double x = RoundToStep(w / 4), y = RoundToStep(d / 2);
    return {{x, 0}, {w - x, 0}, {w - x, y}, {w, y}, {w, d}, {0, d}, {0, y}, {x, y}};
  }
  const double x = RoundToStep(w / 3), y = d - RoundToStep(d / 2);
  return {{0, 0}, {w, 0}, {w, d}, {w - x, d}, {w - x, y}, {x, y}, {x, d}, {0, d}};
}

double NarrowestArm(RoomShape shape, double w, double d) {
  if (shape == RoomShape::kL) return std::min(w - RoundToStep(2 * w / 5), d - RoundToStep(2 * d / 5));
  if (shape == RoomShape::kT) return std::min(w - 2 * RoundToStep(w / 4), d - RoundToStep(d / 2));
  return std::min(RoundToStep(w / 3), d - RoundToStep(d / 2));
}

// Turned by quarters counter-clockwise about the bounding rectangle, whose lower-left corner stays (0, 0).
Outline Turned(Outline outline, double w, double d, std::size_t quarters) {
  for (std::size_t i = 0; i < quarters; ++i) {
    for (Corner& corner : outline) corner = {d - corner.y_m, corner.x_m};
    std::swap(w, d);
  }
  return outline;
}

void Warn(const char* code, const std::string& message, v1::Room& room) {
  v1::Diagnostic& diagnostic = *room.add_diagnostics();
  diagnostic.set_severity(v1::SEVERITY_WARNING);
  diagnostic.set_code(code);
  diagnostic.set_message(message);
}

void SetOutline(const Outline& outline, v1::Room& room) {
  for (const Corner& corner : outline) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(Micrometres(corner.x_m));
    vertex.set_y_m(Micrometres(corner.y_m));
  }
  constexpr const char* kCompass[] = {"south", "east", "north", "west"};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    room.add_walls()->set_name(outline.size() == 4 ? kCompass[i] : fmt::format("wall_{}", i + 1));
  }
}

}  // namespace

void SetFloor(const ShapeRequest& request, const SizeRequest& asked, const RoomSize& size, const Choice& choice,
              v1::Room& room) {
  const Outline rectangle = {{0, 0}, {size.width_m, 0}, {size.width_m, size.depth_m}, {0, size.depth_m}};
  if (!request.unknown.empty()) {
    Warn("shape_unknown",
         fmt::format(
             "A room that is \"{}\" cannot be drawn; it is a rectangle of {:g} m x {:g} m with an upright wall on "
             "every side instead. Rectangles and L, T and U shapes can be drawn, and a floor plan of your own "
             "can have any straight walls.",
             request.unknown, size.width_m, size.depth_m),
         room);
  }
  if (request.shape == RoomShape::kRectangle) return SetOutline(rectangle, room);
  double w = size.width_m, d = size.depth_m;
  if (asked.area_m2 && !asked.width_m && !asked.depth_m) {
    w = RoundToStep(w / std::sqrt(ShareOf(request.shape)));
    d = RoundToStep(d / std::sqrt(ShareOf(request.shape)));
  }
  // Turned by a quarter the sides change places, so that the room has its size after it.
  const std::size_t quarters = choice.Index("room.shape.turn", 4);
  const bool across = quarters % 2 == 1;
  const double upright_w = across ? d : w, upright_d = across ? w : d;
  if (NarrowestArm(request.shape, upright_w, upright_d) < kLeastArmM) {
    Warn("shape_too_small",
         fmt::format("{:g} m x {:g} m is too small for a room in the shape of a {}, whose arms would be narrower than "
                     "{:g} m; it is a rectangle instead.",
                     size.width_m, size.depth_m, NameOf(request.shape), kLeastArmM),
         room);
    return SetOutline(rectangle, room);
  }
  SetOutline(Turned(Upright(request.shape, upright_w, upright_d), upright_w, upright_d, quarters), room);
}

}  // namespace flair::language
