// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms between message and value. Exact both ways but for texts that a Room value does not carry (type, title,
// descriptions, diagnostics).
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/room.pb.h"
#include "room/scene/room.h"

namespace flair {

// Validates first; INVALID_ARGUMENT names the field.
absl::StatusOr<Room> RoomFromProto(const v1::Room& message);

v1::Room RoomToProto(const Room& room);

Polygon PolygonFromProto(const v1::Polygon& message);
v1::Polygon PolygonToProto(const Polygon& polygon);

}  // namespace flair
