// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Step A: a room, rectangular unless the brief names another shape (see room_floor.h), with a door, windows and sockets
// where a builder would put them; the brief's own room when it brings one. Errors as ReadBrief.
absl::StatusOr<v1::Room> DescribeRoom(const v1::Brief& brief, const Handbook& handbook);

// Step B: the zones by area, needs and wishes, most important first. Errors as ReadBrief.
absl::StatusOr<v1::ZonePlan> PlanZones(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook);

// The first line of a brief's text, cut at a word when it is long.
std::string TitleOf(const std::string& text);

// Area of a room's floor, m2.
double FloorArea(const v1::Room& room);

// "floor work" -> "floor_work".
std::string IdOf(std::string_view name);

}  // namespace flair::language
