// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/placement.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/scene/furnishing.h"

namespace flair::renderer {

// A part of the room's shell, in room frame R.
struct ShellPart {
  enum class Kind { kFloor, kCeiling, kWall, kDoor, kWindow, kSkirting };
  Kind kind = Kind::kFloor;
  std::string id;  // "floor", "ceiling", a wall's name, an opening's id
  int wall = -1;   // index in the room's walls, for walls and what is in them
  Mesh mesh;
  Mesh stub;  // of a wall: what is left of it in views that cut it away, kStubHeight_m high
};

inline constexpr float kStubHeight_m = 0.1F;

// "floor", "wall" and so on: how exports and annotations name it.
constexpr std::string_view NameOf(ShellPart::Kind kind) {
  constexpr std::string_view kNames[] = {"floor", "ceiling", "wall", "door", "window", "skirting"};
  return kNames[static_cast<int>(kind)];
}

// An object where it stands.
struct SceneObject {
  const v1::Object* object = nullptr;      // in the layout that the scene was made of
  const v1::ObjectStyle* style = nullptr;  // null when it has none
  v1::Placement placement;
  Furnishing furnishing;
  int wall = -1;  // index in the room's walls of the one that it, or what it lies on, hangs on
};

// A window as a source of daylight: a rectangle in room frame R, from its lower corner nearer to the wall's start.
struct DaylightWindow {
  Vec3 corner;
  Vec3 along;   // of the opening's width, along the wall
  Vec3 up;      // of the opening's height
  Vec3 inward;  // unit
};

// A camera, upright; see v1::ViewCamera.
struct SceneCamera {
  std::string name;
  Vec3 eye;
  Vec3 target;
  float field_of_view_rad = 1;  // vertical
};

// A furnished room in three dimensions, room frame R (x east, y north, z up), metres. Holds pointers into the layout.
struct Scene {
  const v1::SolvedLayout* layout = nullptr;
  std::vector<ShellPart> shell;
  std::vector<SceneObject> objects;  // those with a placement, in the object list's order
  std::vector<DaylightWindow> windows;
  SceneCamera birdseye;
  SceneCamera perspective;
  std::vector<v1::Diagnostic> diagnostics;
};

// Makes the scene of a valid layout (room/validation), which must outlive it. INVALID_ARGUMENT names the field that
// cannot be shown.
absl::StatusOr<Scene> BuildScene(const v1::SolvedLayout& layout, const FurnishingSource& source);

}  // namespace flair::renderer
