// SPDX-License-Identifier: GPL-3.0-or-later
// Ways and goals that people name, in a room.
#pragma once

#include <optional>
#include <string>

#include "room/scene/scene.h"
#include "session/sentences/spoken.h"

namespace flair::session {

// "West", "north-east", "forward" or "back" from where something stands, as a unit vector; nothing for other words.
std::optional<Vec2<double>> WayOf(const std::string& way, const v1::Placement& at);

// The way from where something stands to a target; straight towards a wall. Nothing when there is no such target.
std::optional<Vec2<double>> WayTo(const Target& target, const Scene& scene, const v1::SolvedLayout& layout,
                                  const v1::Placement& at);

// That way, but along the wall at which it stands where it leads into the wall; no way where nothing is left of it.
Vec2<double> AlongWall(const Vec2<double>& way, const Room& room, const v1::Placement& at, const v1::Object& object);

// The middle of the rectangle round a room.
Vec2<double> MiddleOf(const Room& room);

// The wall that something stands nearest to, and the one that is opposite; -1 for none.
int NearestWall(const Room& room, const v1::Placement& at);
int OppositeWall(const Room& room, int wall);

}  // namespace flair::session
