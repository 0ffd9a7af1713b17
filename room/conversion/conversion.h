// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms, scenes and layouts between message and value. Rooms are exact both ways but for texts that a Room value does
// not carry (type, title, descriptions, diagnostics).
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "room/scene/room.h"
#include "room/scene/scene.h"

namespace flair {

// Validates first; INVALID_ARGUMENT names the field.
absl::StatusOr<Room> RoomFromProto(const v1::Room& message);

v1::Room RoomToProto(const Room& room);

using PlacementList = google::protobuf::RepeatedPtrField<v1::Placement>;

// Validates the whole graph first; INVALID_ARGUMENT names the field.
absl::StatusOr<Scene> SceneFromProto(const v1::LayoutGraph& graph);

// A graph with the scene's room, zones and objects. What a Scene value does not carry is empty: the room's type, texts,
// edges.
v1::LayoutGraph GraphFromScene(const Scene& scene);

// A layout of which some objects may not be placed.
struct PartialLayout {
  // One per object of the scene; that of an object that is not placed is 0, 0, 0.
  Layout layout;
  // One per object.
  std::vector<bool> placed;
};

// INVALID_ARGUMENT for ids that are not in the scene, for repeated ones and for numbers that are not finite.
absl::StatusOr<PartialLayout> PosesFromPlacements(const Scene& scene, const PlacementList& placements);

// One placement per object for which `placed` holds (all when it is empty), in the scene's order; headings in
// [0, 2 pi), z from the scene (wall and ceiling objects at their elevation, surface objects on their host's top).
PlacementList PlacementsFromPoses(const Scene& scene, const Layout& layout, const std::vector<bool>& placed = {});

}  // namespace flair
