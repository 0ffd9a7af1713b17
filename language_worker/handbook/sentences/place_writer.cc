// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/place_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/rooms/walls.h"
#include "language_worker/handbook/sentences/fill.h"

namespace flair::language {
namespace {

bool PlaceNames(const Place& place, std::string_view slot) {
  return place.asked->relation().text().find(slot) != std::string::npos;
}

// A wall as what "{wall}" stands for.
Slot TheWall(const v1::Room& room, int wall) {
  const std::string& name = room.walls(wall).name();
  v1::Participant participant;
  participant.set_wall(name);
  return {name.starts_with("wall") ? name : fmt::format("the {} wall", name), {participant}};
}

// "Near the kitchen door", "under the north window": names the one that is meant, by its wall where it is alone there.
// Whether it has; facts tell no door from another, so that the sentence is then read as it is written.
bool NameTheOpening(const v1::Room& room, const std::string& side, hb::Relation& relation) {
  bool named = false;
  for (const auto& [kind, words] : {std::pair(v1::OPENING_KIND_DOOR, std::string_view("the door")),
                                    std::pair(v1::OPENING_KIND_WINDOW, std::string_view("the window"))}) {
    const std::size_t at = relation.text().find(words);
    const v1::Opening* one = at == std::string::npos || side.empty() ? nullptr : OpeningOf(room, kind, side);
    // "The door" is that by which one comes in.
    const auto doors = std::ranges::count(room.openings(), v1::OPENING_KIND_DOOR, &v1::Opening::kind);
    if (one == nullptr && at != std::string::npos && kind == v1::OPENING_KIND_DOOR && doors > 1)
      one = &*std::ranges::find(room.openings(), kind, &v1::Opening::kind);
    if (one == nullptr) continue;
    const bool alone = std::ranges::count_if(room.openings(), [&](const v1::Opening& other) {
                         return other.kind() == kind && other.wall() == one->wall();
                       }) == 1;
    const bool by_wall = alone && !one->wall().starts_with("wall");
    relation.mutable_text()->replace(at, words.size(),
                                     by_wall ? fmt::format("the {} {}", one->wall(), words.substr(4)) : one->id());
    named = true;
  }
  return named;
}

std::vector<v1::Sentence> AsWritten(std::vector<v1::Sentence> sentences) {
  for (v1::Sentence& sentence : sentences) sentence.clear_meaning();
  return sentences;
}

// Where a wall stands for the target.
void NameTheWall(const Slots& further, hb::Relation& relation) {
  constexpr std::string_view kTarget = "the {target}";
  const std::size_t at = relation.text().find(kTarget);
  if (at != std::string::npos && further.contains("wall"))
    relation.mutable_text()->replace(at, kTarget.size(), "{wall}");
}

// The corners of a side, "in each of the back corners"; all for no side.
std::vector<std::string> CornersOn(const std::string& side) {
  if (side.empty()) return {"far left", "near right", "far right", "near left"};
  if (side.starts_with("north") || side.starts_with("south")) return {side + " west", side + " east"};
  if (IsIn("compass", side)) return {"north " + side, "south " + side};
  const bool hand = side == "left" || side == "right";
  return hand ? std::vector{"far " + side, "near " + side} : std::vector{side + " left", side + " right"};
}

// The walls that a place names, or those that are meant where it only counts them.
std::vector<std::string> SeveralSides(const Place& place) {
  if (place.walls > 2) {
    std::vector<std::string> sides = {"far", "left", "right"};
    if (place.walls > 3) sides.push_back("near");
    return sides;
  }
  const std::size_t space = place.side.find(' ');
  if (place.said.find(" and ") != std::string::npos && space != std::string::npos)
    return {place.side.substr(0, space), place.side.substr(space + 1)};
  const bool told = !place.side.empty() && place.side != "opposite";
  return told ? std::vector<std::string>{place.side, "across " + place.side}
              : std::vector<std::string>{"left", "right"};
}

}  // namespace

std::vector<v1::Sentence> PlaceWriter::Write(const Place& place, const Group& group) const {
  const Group subjects = SubjectsOf(place, group);
  // Four desks that face each other do so in pairs; which chairs are at one table is not told here.
  const bool in_pairs =
      place.asked->relation().condition().max_count() == 2 && subjects.size() > 2 && !IsSeat(*place.furniture);
  if (!in_pairs || subjects.size() % 2 != 0) return WriteAbout(place, subjects);
  std::vector<v1::Sentence> sentences;
  for (auto pair = subjects.begin(); pair != subjects.end(); pair += 2) {
    for (v1::Sentence& sentence : WriteAbout(place, Group(pair, pair + 2))) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

std::vector<v1::Sentence> PlaceWriter::WriteAbout(const Place& place, Group subjects) const {
  if (subjects.empty()) return {};
  if (PlaceNames(place, "{wall}")) subjects = WhatGoesThere(subjects);
  if (PlaceNames(place, "{first}")) return WriteBetween(place, subjects);
  if (!place.side.empty() && PlaceNames(place, "in a corner")) return WriteCorners(place, subjects);
  const bool several =
      place.walls > 1 || (place.said.ends_with("walls") && (subjects.size() == 2 || !place.side.empty()));
  if (PlaceNames(place, "{wall}") && several && subjects.size() > 1) return WriteOnWalls(place, subjects);
  if (PlaceNames(place, "central in the room") && subjects.size() > 2) return WriteAlongTheMiddle(place, subjects);
  hb::Relation relation = place.asked->relation();
  // Rows look straight ahead: their middle faces what all look at.
  const bool ahead = PlaceNames(place, "faces the {target}") && place.which < 0 && writer_.StandsInRows(subjects);
  if (ahead) relation.set_pairing(hb::PAIRING_FRONT_ROW);
  if (ahead && writer_.StandsInOwnRows(subjects) && IsFloorPiece(*place.target))
    relation.set_text("The {target} is at most 2.4 m in front of the {object}.");
  Slots further;
  if (place.length_m > 0) further["length"] = {fmt::format("{:.3g} m", place.length_m), {}};
  if (PlaceNames(place, "{wall}")) {
    const std::optional<Slot> wall = WallFor(place.side);
    if (!wall) return {};
    const bool hangs = place.furniture->kind() == hb::FURNITURE_KIND_WALL;
    if (hangs && subjects.front()->kind() == v1::OBJECT_KIND_FLOOR) {
      relation.set_text("The {object}'s back is against {wall}.");
    }
    // "Tables at the back", "tables along the wall" stand there with their seats, not with their backs to the wall.
    const bool of_the_room = !place.side.empty() && place.said.find("wall") == std::string::npos;
    const bool region =
        of_the_room || (subjects.front()->category().ends_with("table") && !place.furniture->companions().empty());
    if (region && place.furniture->back() == hb::BACK_RULE_FREE && place.said.find("against") == std::string::npos &&
        relation.text().find("back is against") != std::string::npos) {
      relation.set_text("The {object} is within 1.5 m of {wall}.");
    }
    // "A bed along the left wall" stands lengthwise.
    constexpr double kLong = 1.3;
    const bool lengthwise = place.said.starts_with("along ") || place.said.starts_with("lengthwise");
    if (lengthwise && subjects.front()->depth_m() > kLong * subjects.front()->width_m()) {
      relation.set_text("One long side of the {object} is against {wall}.");
    }
    // It hangs on a wall anyway.
    if (wall->means.empty() && subjects.front()->kind() == v1::OBJECT_KIND_WALL) {
      relation.set_text("The {object} hangs on the wall in the {zone} zone.");
    }
    further["wall"] = *wall;
  }
  const bool named = NameTheOpening(room_, place.side, relation);
  // What stands beside a thing stands on that one's host.
  const hb::Carried carried = place.asked->carried();
  if (place.target != nullptr && carried != hb::CARRIED_ALONG) {
    const std::string target = StandIn(place, further);
    if (!target.empty()) relation.add_targets(target);
  }
  // A desk opposite the bed stands across from it, whoever sits there looks where they like.
  const bool across_from = place.target != nullptr && place.said.starts_with("opposite");
  if (!place.asked->text_of_desks().empty() && subjects.front()->category() == "desk" && !across_from) {
    const std::vector<v1::Sentence> sentences = WriteOfDesks(place, relation, subjects, further);
    if (!sentences.empty()) return named ? AsWritten(sentences) : sentences;
  }
  // What is opened from the front stands across from the foot of a bed, not at it.
  if (PlaceNames(place, "next to the front of") && place.furniture->back() == hb::BACK_RULE_WALL) {
    relation.set_text("The {object} faces the {target}.");
  }
  // Guests sit across the desk.
  const auto& relations = place.furniture->relations();
  const auto across = std::ranges::find_if(relations, [&](const hb::Relation& one) {
    return one.text().find("is next to the back of the {target}") != std::string::npos && place.target != nullptr &&
           Includes(one.targets(), place.target->name());
  });
  if (across != relations.end() && PlaceNames(place, "is in front of the {target}")) relation.set_text(across->text());
  constexpr std::size_t kMany = 3;
  if (!place.asked->text_of_many().empty() && subjects.size() >= kMany && !place.target->walk_over()) {
    relation.set_text(place.asked->text_of_many());
    // Easy chairs leave room for legs before a low table.
    constexpr double kEasyM = 0.65;
    if (relation.text().ends_with("surround the {target}.") && subjects.front()->width_m() >= kEasyM)
      relation.set_text("The {objects} surround the {target} 0.4 m away.");
    relation.set_pairing(hb::PAIRING_TOGETHER);
  }
  if (relation.targets().empty()) NameTheWall(further, relation);
  // Of many lockers beside the door, or cabinets next to the rack, one is there, and the others follow in a row.
  const bool at_one_place = relation.text().find(" near the ") != std::string::npos ||
                            relation.text() == "The {object} is next to the {target}.";
  if (at_one_place && subjects.size() >= kMany && IsOnTheFloor(*place.furniture) &&
      place.furniture->back() == hb::BACK_RULE_WALL) {
    std::vector<v1::Sentence> sentences = writer_.Write(relation, {subjects.front()}, further);
    hb::Relation row = place.asked->relation();
    row.set_text("The {objects} stand side by side in a row.");
    if (!sentences.empty()) sentences.push_back(writer_.WriteOne(row, subjects, {}, 0));
    return named ? AsWritten(std::move(sentences)) : sentences;
  }
  const bool on_a_top = carried != hb::CARRIED_UNSPECIFIED && subjects.front()->kind() == v1::OBJECT_KIND_SURFACE;
  if (on_a_top && !writer_.IsCentral(*subjects.front()))
    relation.set_text("The {object} is on the {corner} corner of the {target}.");
  // What one walks round stands in no row without gaps.
  constexpr double kPassM = 0.3;
  const auto parts = static_cast<std::size_t>(std::max(1, place.asked->parts()));
  if (parts > 1 && place.furniture->clear_sides_m() >= kPassM) return {};
  std::vector<v1::Sentence> sentences;
  for (std::size_t i = 0; i < parts; ++i) {
    const auto at = [&](std::size_t part) {
      return subjects.begin() + static_cast<std::ptrdiff_t>(subjects.size() * part / parts);
    };
    std::vector<v1::Sentence> about = writer_.Write(relation, Group(at(i), at(i + 1)), further);
    if (about.empty() && place.target != nullptr) about = WriteHung(relation, place, subjects, further);
    sentences.insert(sentences.end(), about.begin(), about.end());
  }
  // One walks round what does not belong to a wall on all four sides.
  const bool all_round =
      relation.text().find("space around the") != std::string::npos && place.said.find("three") == std::string::npos &&
      place.furniture->back() != hb::BACK_RULE_WALL && place.furniture->back() != hb::BACK_RULE_CORNER;
  if (all_round && !sentences.empty()) {
    relation.set_text("There is {length} of clear space behind the {object}.");
    for (v1::Sentence& sentence : writer_.Write(relation, subjects, further)) sentences.push_back(std::move(sentence));
  }
  return named ? AsWritten(std::move(sentences)) : sentences;
}

std::optional<Slot> PlaceWriter::WallFor(const std::string& side) const {
  const std::optional<int> wall = WallOf(room_, side);
  // Where no wall is without openings, any will do.
  if (!wall && !side.empty() && !side.starts_with("blank")) return std::nullopt;
  return wall ? TheWall(room_, *wall) : Slot{"a wall", {}};
}

std::string PlaceWriter::StandIn(const Place& place, Slots& further) const {
  const auto& groups = writer_.groups();
  const auto found = groups.find(place.target->name());
  const bool standing = found != groups.end() && IsOnTheFloor(*place.furniture) &&
                        found->second.front()->role() == v1::OBJECT_ROLE_TERTIARY;
  if (!standing) return place.target->name();
  const v1::Object& target = *found->second.front();
  if (target.kind() == v1::OBJECT_KIND_SURFACE) {
    for (const auto& [name, objects] : groups) {
      if (std::ranges::any_of(objects, [&](const v1::Object* one) { return one->id() == target.host_id(); }))
        return name;
    }
  }
  for (const Place& hung : places_) {
    if (target.kind() != v1::OBJECT_KIND_WALL || hung.furniture != place.target) continue;
    if (!PlaceNames(hung, "{wall}") && hung.target != nullptr && IsOnTheFloor(*hung.target)) return hung.target->name();
    const std::optional<Slot> wall = PlaceNames(hung, "{wall}") ? WallFor(hung.side) : std::nullopt;
    if (!wall || wall->means.empty()) continue;
    further["wall"] = *wall;
    return "";
  }
  return place.target->name();
}

Group PlaceWriter::SubjectsOf(const Place& place, const Group& group) const {
  if (place.which < 0) {
    // Each of them in a zone of its own: all are spoken of with the first.
    const Group& all = writer_.groups().at(group.front()->name());
    const bool together = place.asked->relation().pairing() == hb::PAIRING_TOGETHER && group.size() == 1;
    return together && group.front() == all.front() ? all : group;
  }
  const Group& all = writer_.groups().at(group.front()->name());
  const auto at = static_cast<std::size_t>(place.which);
  if (at >= all.size() || std::ranges::find(group, all[at]) == group.end()) return {};
  return {all[at]};
}

std::vector<v1::Sentence> PlaceWriter::WriteOfDesks(const Place& place, hb::Relation relation, const Group& group,
                                                    const Slots& further) const {
  relation.set_text(place.asked->text_of_desks());
  NameTheOpening(room_, place.side, relation);
  if (relation.targets().empty()) NameTheWall(further, relation);
  if (relation.text().find("{seat}") == std::string::npos) return writer_.Write(relation, group, further);
  relation.set_text(Fill(relation.text(), {{"seat", "{object}"}}));
  Group seats;
  for (const auto& [name, objects] : writer_.groups()) {
    for (const v1::Object* one : objects) {
      const bool here = one->zone_id() == group.front()->zone_id() && one->role() != v1::OBJECT_ROLE_TERTIARY;
      if (one->category() == "chair" && here && seats.size() < group.size()) seats.push_back(one);
    }
    if (!seats.empty()) break;
  }
  return seats.empty() ? std::vector<v1::Sentence>() : writer_.Write(relation, seats, further);
}

std::vector<v1::Sentence> PlaceWriter::WriteOnWalls(const Place& place, const Group& group) const {
  std::vector<v1::Sentence> sentences;
  const std::vector<std::string> sides = SeveralSides(place);
  std::vector<Group> shares(sides.size());
  for (std::size_t i = 0; i < group.size(); ++i) shares[i * sides.size() / group.size()].push_back(group[i]);
  for (std::size_t w = 0; w < sides.size(); ++w) {
    const std::optional<int> wall = WallOf(room_, sides[w]);
    if (!wall) return {};
    for (const v1::Object* one : shares[w])
      sentences.push_back(writer_.WriteOne(place.asked->relation(), {one}, {}, 0, {{"wall", TheWall(room_, *wall)}}));
    if (shares[w].size() < 2 || !IsOnTheFloor(*place.furniture)) continue;
    hb::Relation row = place.asked->relation();
    row.set_text("The {objects} stand side by side in a row.");
    sentences.push_back(writer_.WriteOne(row, shares[w], {}, 0));
  }
  return sentences;
}

// All of them cannot have the middle: they stand off the long walls, one behind the other.
std::vector<v1::Sentence> PlaceWriter::WriteAlongTheMiddle(const Place& place, const Group& group) const {
  constexpr double kShare = 0.3;  // of what is free beside a piece
  const std::optional<int> wall = WallOf(room_, "long"), other = WallOf(room_, "across long"),
                           end = WallOf(room_, "short");
  if (!wall || !other || !end) return writer_.Write(place.asked->relation(), group);
  std::vector<v1::Sentence> sentences;
  for (const v1::Object* object : group) {
    const double free_m = std::max(0.3, WallLength(room_, *end) - std::min(object->width_m(), object->depth_m()));
    hb::Relation relation = place.asked->relation();
    relation.set_text(fmt::format("The {{object}} is at least {:.1f} m away from {{wall}}.", kShare * free_m));
    for (const int side : {*wall, *other})
      sentences.push_back(writer_.WriteOne(relation, {object}, {}, 0, {{"wall", TheWall(room_, side)}}));
  }
  return sentences;
}

std::vector<v1::Sentence> PlaceWriter::WriteCorners(const Place& place, const Group& group) const {
  if (place.side.starts_with("each")) {
    const std::vector<std::string> corners = CornersOn(place.side.substr(std::min<std::size_t>(5, place.side.size())));
    std::vector<v1::Sentence> sentences;
    for (std::size_t i = 0; i < std::min(group.size(), corners.size()); ++i) {
      const std::optional<int> corner = CornerOf(room_, corners[i]);
      if (!corner) return writer_.Write(place.asked->relation(), group);
      for (v1::Sentence& sentence : WriteCorner(place, {group[i]}, *corner)) sentences.push_back(std::move(sentence));
    }
    return sentences;
  }
  const std::optional<int> corner = CornerOf(room_, place.side);
  return corner ? WriteCorner(place, {group.front()}, *corner) : writer_.Write(place.asked->relation(), group);
}

std::vector<v1::Sentence> PlaceWriter::WriteCorner(const Place& place, const Group& one, int corner) const {
  const int after = corner, before = (corner + room_.walls_size() - 1) % room_.walls_size();
  // The back leaves windows and doors free where it can. Along a wall that begins in the corner the left side meets
  // the other one, along a wall that ends there the right side.
  const bool on_after = !IsBlank(room_, before) || IsBlank(room_, after);
  hb::Relation back = place.asked->relation(), side = back;
  back.set_text("The {object}'s back is against {wall}.");
  side.set_text(fmt::format("The {{object}}'s {} side is against {{wall}}.", on_after ? "left" : "right"));
  // A rug has no back.
  if (place.furniture->walk_over()) {
    for (hb::Relation* near : {&back, &side}) near->set_text("The {object} is within 0.4 m of {wall}.");
  }
  std::vector<v1::Sentence> sentences = writer_.Write(back, one, {{"wall", TheWall(room_, on_after ? after : before)}});
  for (v1::Sentence& sentence : writer_.Write(side, one, {{"wall", TheWall(room_, on_after ? before : after)}})) {
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

std::vector<v1::Sentence> PlaceWriter::WriteRun(const std::vector<RunPlace>& run, const Group& group) const {
  constexpr double kSmallM = 1e-6;
  std::vector<v1::Sentence> sentences;
  const auto write = [&](const RunPlace& of, const std::string& text, const std::string& reason, const Group& targets,
                         int wall) {
    hb::Relation relation;
    relation.set_text(text);
    relation.set_reason(reason);
    relation.set_weight(3);
    Slots further;
    if (wall >= 0) further["wall"] = TheWall(room_, wall);
    sentences.push_back(writer_.WriteOne(relation, {of.object}, targets, 0, further));
  };
  for (const RunPlace& place : run) {
    if (std::ranges::find(group, place.object) == group.end()) continue;
    write(place, "The {object}'s back is against {wall}.", "the run has this wall", {}, place.wall);
    const int count = room_.walls_size(), before = (place.wall + count - 1) % count, after = (place.wall + 1) % count;
    for (const RunPlace& other : run) {
      if (other.wall == place.wall && std::abs(other.end_m() - place.offset_m) < kSmallM) {
        write(place, "The left side of the {object} is against the right side of the {target}.",
              "the run shares one worktop", {other.object}, -1);
      }
      const bool fills_corner = other.offset_m < kSmallM && other.wall == after;
      if (fills_corner && place.end_m() > kSmallM &&
          std::abs(WallLength(room_, place.wall) - place.end_m() - other.object->depth_m()) < kSmallM) {
        write(place, "The right side of the {object} is against the front of the {target}.",
              "the worktop goes round the corner", {other.object}, -1);
      }
      if (other.wall == before && std::abs(WallLength(room_, before) - other.end_m()) < kSmallM &&
          std::abs(place.offset_m - other.object->depth_m()) < kSmallM) {
        write(place, "The left side of the {object} is against the front of the {target}.",
              "the worktop goes round the corner", {other.object}, -1);
      }
    }
    if (place.at_window) write(place, "The {object} is under a window.", "a view and light while washing up", {}, -1);
    if (place.offset_m < kSmallM && !IsReentrant(room_, place.wall)) {
      write(place, "The {object}'s left side is against {wall}.", "the run begins in the corner", {}, before);
    }
    if (WallLength(room_, place.wall) - place.end_m() < kSmallM && !IsReentrant(room_, after)) {
      write(place, "The {object}'s right side is against {wall}.", "the run ends in the corner", {}, after);
    }
  }
  return sentences;
}

}  // namespace flair::language
