// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/placement.pb.h"
#include "flair/v1/provenance.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// A light that shines from within a piece, in its frame O.
struct LampLight {
  Vec3 position;
  Vec3 colour{1, 0.85F, 0.65F};  // linear RGB, largest component 1
  float intensity_cd = 60;       // in every direction
  float radius_m = 0.05F;        // of the shining ball
};

// What an object is shown as.
struct Furnishing {
  std::string class_name;  // one of the furniture classes; "box" when nothing better is known
  std::shared_ptr<const Mesh> mesh;
  std::vector<LampLight> lights;
  std::string asset_id;       // empty when the mesh was made by us
  std::string asset_licence;  // as its manifest says, such as "CC-BY-4.0"; empty when it does not
};

// Where furniture comes from. Thread-safe; the same object and style give the same mesh.
class FurnishingSource {
 public:
  virtual ~FurnishingSource() = default;
  // Never fails: what is not known becomes a decent box, what went wrong on the way is said in `diagnostics`.
  // `style` may be null.
  virtual Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                                  std::vector<v1::Diagnostic>& diagnostics) const = 0;
};

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
