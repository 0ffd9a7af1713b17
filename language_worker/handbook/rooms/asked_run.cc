// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/asked_run.h"

#include "language_worker/handbook/rooms/walls.h"

namespace flair::language {

std::optional<AskedRun> ReadAskedRun(const BriefFacts& facts, const v1::Room& room) {
  AskedRun asked;
  for (const Place& place : facts.places) {
    const std::string& text = place.asked->relation().text();
    const bool window = text.find("window") != std::string::npos;
    if (place.furniture->run() == hb::RUN_PART_UNSPECIFIED) {
      asked.others_at_window |= window && place.furniture->kind() == hb::FURNITURE_KIND_FLOOR;
      continue;
    }
    if (place.furniture->run() == hb::RUN_PART_BASIN && window) {
      asked.basin_at_window = true;
      continue;
    }
    const auto is_wet = [](const hb::Furniture& piece) {
      return piece.run() == hb::RUN_PART_BASIN || piece.run() == hb::RUN_PART_WASHER;
    };
    if (text.find("door") != std::string::npos && text.find("face") == std::string::npos) {
      const v1::Opening* door = OpeningOf(room, v1::OPENING_KIND_DOOR, place.side);
      if (door == nullptr && room.openings_size() > 0) door = &room.openings(0);
      const std::optional<int> wall = door == nullptr ? std::nullopt : WallNamed(room, door->wall());
      if (!wall) continue;
      asked.at_doors.push_back({place.furniture->name(), PointOn(room, *wall, door->offset_m() + door->width_m() / 2),
                                text.find("away") != std::string::npos});
      continue;
    }
    // The one is beside the other anyway.
    if (place.target != nullptr && is_wet(*place.furniture) && is_wet(*place.target)) continue;
    if (text.find("{wall}") == std::string::npos) return std::nullopt;
    if (place.side.empty()) continue;
    asked.wall = WallOf(room, place.side);
    if (asked.wall) asked.wall_of.insert_or_assign(place.furniture->name(), *asked.wall);
  }
  return asked;
}

}  // namespace flair::language
