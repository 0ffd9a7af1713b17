// SPDX-License-Identifier: GPL-3.0-or-later
// Briefs and rooms.
#include <algorithm>
#include <cmath>
#include <map>

#include "room/geometry/polygon.h"
#include "room/validation/field.h"

namespace flair::validation {
namespace {

constexpr double kTolerance_m = 1e-6;
constexpr Range kFloorExtent{.least = 1, .most = 100};
// Each is compared with the ones before it.
constexpr int kMostOpenings = 100;
constexpr Range kFromZero{.least = 0, .most = 100};

using WallLengths = std::map<std::string, double, std::less<>>;

flair::Polygon ToPolygon(const v1::Polygon& message) {
  flair::Polygon polygon;
  for (const v1::Point2& p : message.vertices()) polygon.vertices.push_back({p.x_m(), p.y_m()});
  return polygon;
}

void CheckFloor(const v1::Polygon& floor, const Field& at) {
  for (int i = 0; i < floor.vertices_size(); ++i) {
    const v1::Point2& p = floor.vertices(i);
    const Field vertex = at["vertices"][i];
    if (!std::isfinite(p.x_m()) || !std::isfinite(p.y_m())) {
      vertex.Reject("({}, {}) is not a point; both must be finite", p.x_m(), p.y_m());
      return;
    }
  }
  if (!at.Count(floor.vertices_size(), 3, 200, "vertices")) return;
  const flair::Polygon shape = ToPolygon(floor);
  if (SignedArea(shape.vertices) < 0) {
    at.Reject("runs clockwise; must be counter-clockwise");
  } else if (!IsSimple(shape)) {
    at.Reject("is not simple; no two edges may cross or touch but neighbours in their shared corner");
  }
  const BoundingBox box = BoundsOf(shape);
  if (std::abs(box.min.x) > kTolerance_m || std::abs(box.min.y) > kTolerance_m) {
    at.Reject("its bounding box starts at ({}, {}); must start at (0, 0)", box.min.x, box.min.y);
  }
  if (!kFloorExtent.Holds(box.width_m()) || !kFloorExtent.Holds(box.height_m())) {
    at.Reject("is {} m x {} m; each must be in {}", box.width_m(), box.height_m(), kFloorExtent.Text());
  }
}

// Lengths of the walls by name; empty when walls and floor do not go together.
WallLengths CheckWalls(const v1::Room& room, const Field& at) {
  const int count = room.floor().vertices_size();
  if (room.walls_size() != count) {
    at.Reject("has {} walls for a floor of {} edges; one per edge", room.walls_size(), count);
    return {};
  }
  WallLengths lengths;
  NameSet seen;
  const flair::Polygon floor = ToPolygon(room.floor());
  for (int i = 0; i < count; ++i) {
    if (at[i]["name"].NewId(room.walls(i).name(), seen)) lengths[room.walls(i).name()] = EdgeAt(floor, i).length_m();
  }
  return lengths;
}

void CheckLeaf(const v1::Opening& opening, const Field& at) {
  if (opening.kind() != v1::OPENING_KIND_DOOR) {
    if (opening.has_leaf()) at.Reject("is set for a window; doors only");
    return;
  }
  if (!opening.has_leaf()) {
    at.Reject("is not set; a door says how it opens");
    return;
  }
  const v1::DoorLeaf& leaf = opening.leaf();
  at["swing"].Enum(leaf.swing(), v1::DoorSwing_IsValid(leaf.swing()));
  if (leaf.swing() != v1::DOOR_SWING_INWARD && leaf.swing() != v1::DOOR_SWING_OUTWARD) return;
  at["hinge"].Enum(leaf.hinge(), v1::HingeSide_IsValid(leaf.hinge()));
  at["swing_angle_rad"].InRange(leaf.swing_angle_rad(), {.least = 0, .most = 3.141592653589794, .open_least = true});
}

void CheckOpening(const v1::Opening& opening, const WallLengths& walls, double room_height_m, const Field& at) {
  CheckLeaf(opening, at["leaf"]);
  const auto wall = walls.find(opening.wall());
  if (wall != walls.end() && kFromZero.Holds(opening.offset_m()) && kFromZero.Holds(opening.width_m())) {
    const double most = wall->second - opening.offset_m();
    if (opening.width_m() > most + kTolerance_m) {
      at["width_m"].Reject("{} does not fit wall \"{}\" ({:.6g} m from {} m); at most {:.6g}", opening.width_m(),
                           opening.wall(), wall->second, opening.offset_m(), std::max(0.0, most));
    }
  }
  if (!kFromZero.Holds(opening.sill_height_m())) return;
  if (opening.kind() == v1::OPENING_KIND_DOOR && opening.sill_height_m() != 0) {
    at["sill_height_m"].Reject("{} for a door; must be 0", opening.sill_height_m());
  }
  at["head_height_m"].InRange(
      opening.head_height_m(),
      {.least = opening.sill_height_m(), .most = std::max(room_height_m, opening.sill_height_m()), .open_least = true});
}

bool Overlap(const v1::Opening& a, const v1::Opening& b) {
  const double along =
      std::min(a.offset_m() + a.width_m(), b.offset_m() + b.width_m()) - std::max(a.offset_m(), b.offset_m());
  const double up = std::min(a.head_height_m(), b.head_height_m()) - std::max(a.sill_height_m(), b.sill_height_m());
  return a.wall() == b.wall() && along > kTolerance_m && up > kTolerance_m;
}

void CheckOpenings(const v1::Room& room, const WallLengths& walls, const NameSet& wall_names, const Field& at) {
  if (room.openings_size() > kMostOpenings) return;
  for (int i = 0; i < room.openings_size(); ++i) {
    const v1::Opening& opening = room.openings(i);
    if (!walls.empty()) at[i]["wall"].Refers(opening.wall(), wall_names, "a wall");
    CheckOpening(opening, walls, room.height_m(), at[i]);
    for (int k = 0; k < i; ++k) {
      if (Overlap(opening, room.openings(k))) at[i].Reject("overlaps {}", at[k].path());
    }
  }
}

void CheckSockets(const v1::Room& room, const WallLengths& walls, const NameSet& wall_names, const Field& at) {
  for (int i = 0; i < room.sockets_size(); ++i) {
    const v1::Socket& socket = room.sockets(i);
    if (!walls.empty()) at[i]["wall"].Refers(socket.wall(), wall_names, "a wall");
    const auto wall = walls.find(socket.wall());
    const double length_m = wall == walls.end() ? kFromZero.most : wall->second + kTolerance_m;
    at[i]["offset_m"].InRange(socket.offset_m(), {.least = 0, .most = length_m});
    at[i]["height_m"].InRange(socket.height_m(), {.least = 0, .most = std::max(0.0, room.height_m())});
  }
}

constexpr int kLongestBrief = 4000;

std::string_view Trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n\v\f");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n\v\f") - first + 1);
}

// Byte of the first control character (C0, DEL), or npos.
size_t FindControlCharacter(std::string_view text) {
  const auto found = std::ranges::find_if(text, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  return found == text.end() ? std::string_view::npos : static_cast<size_t>(found - text.begin());
}

// Whether a letter of any script is in it. Counts two- and three-byte characters outside the symbol blocks U+2000 to
// U+2BFF and U+FE00 to U+FE0F as letters, four-byte ones (emoji) not.
bool HasLetter(std::string_view text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= 0xC3 && c < 0xE0)) return true;
    if (c < 0xE0 || c >= 0xF0 || i + 1 >= text.size()) continue;
    const auto next = static_cast<unsigned char>(text[i + 1]);
    const bool symbol = (c == 0xE2 && next >= 0x80 && next < 0xB0) || (c == 0xEF && next == 0xB8);
    if (!symbol) return true;
  }
  return false;
}

}  // namespace

void Check(const v1::Room& room, const Known&, const Field& at) {
  CheckFloor(room.floor(), at["floor"]);
  const WallLengths walls = CheckWalls(room, at["walls"]);
  NameSet wall_names;
  for (const auto& [name, length] : walls) wall_names.insert(name);
  CheckOpenings(room, walls, wall_names, at["openings"]);
  CheckSockets(room, walls, wall_names, at["sockets"]);
}

void Check(const v1::Brief& brief, const Known&, const Field& at) {
  const Field text = at["text"];
  const std::string_view trimmed = Trimmed(brief.text());
  if (trimmed.empty()) {
    text.Reject("is empty; say what room you want, such as \"A bedroom that is 4m x 5m.\"");
  } else if (text.Text(trimmed, 1, kLongestBrief)) {
    const size_t control = FindControlCharacter(trimmed);
    if (control != std::string_view::npos) {
      text.Reject("has the control character 0x{:02x} at byte {}; plain text only",
                  static_cast<unsigned char>(trimmed[control]), control);
    } else if (!HasLetter(trimmed)) {
      text.Reject("\"{}\" has no word; say what room you want, such as \"A bedroom that is 4m x 5m.\"", trimmed);
    }
  }
}

}  // namespace flair::validation
