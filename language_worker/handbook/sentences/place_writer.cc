// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/place_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "language_worker/handbook/rooms/wall_words.h"
#include "language_worker/handbook/sentences/fill.h"

namespace flair::language {
namespace {

using Fillings = std::map<std::string, std::string, std::less<>>;

bool PlaceNames(const Place& place, std::string_view slot) {
  return place.asked->relation().text().find(slot) != std::string::npos;
}

std::string TheWall(const v1::Room& room, int wall) {
  const std::string& name = room.walls(wall).name();
  return name.starts_with("wall") ? name : fmt::format("the {} wall", name);
}

bool HasOpenings(const v1::Room& room, int wall) {
  return std::ranges::any_of(room.openings(),
                             [&](const v1::Opening& one) { return one.wall() == room.walls(wall).name(); });
}

hb::Relation Filled(const Place& place, const Fillings& words) {
  hb::Relation relation = place.asked->relation();
  relation.set_text(Fill(relation.text(), words));
  return relation;
}

}  // namespace

PlaceWriter::PlaceWriter(const v1::Room& room, const RoomProgram& program, const SentenceWriter& writer)
    : room_(room), program_(program), writer_(writer) {}

std::vector<v1::Sentence> PlaceWriter::Write(const Place& place, const Group& group) const {
  const Group subjects = SubjectsOf(place, group);
  if (subjects.empty()) return {};
  if (!place.asked->text_of_desks().empty() && subjects.front()->category() == "desk") {
    const std::vector<v1::Sentence> sentences = WriteOfDesks(place, subjects);
    if (!sentences.empty()) return sentences;
  }
  if (PlaceNames(place, "{first}")) return WriteBetween(place, subjects);
  if (!place.side.empty() && PlaceNames(place, "in a corner")) return WriteCorner(place, subjects);
  Fillings words;
  if (PlaceNames(place, "{wall}")) {
    const std::optional<int> wall = WallOf(room_, place.side);
    if (!wall && !place.side.empty()) return {};
    words["wall"] = wall ? TheWall(room_, *wall) : "a wall";
  }
  hb::Relation relation = Filled(place, words);
  if (place.target != nullptr) relation.add_targets(place.target->name());
  return writer_.Write(relation, subjects);
}

// "One desk by the door": the group may be a part of all that have the name.
Group PlaceWriter::SubjectsOf(const Place& place, const Group& group) const {
  if (place.which < 0) return group;
  const Group& all = writer_.groups().at(group.front()->name());
  const auto at = static_cast<std::size_t>(place.which);
  if (at >= all.size() || std::ranges::find(group, all[at]) == group.end()) return {};
  return {all[at]};
}

// Whoever sits at a desk looks over its back.
std::vector<v1::Sentence> PlaceWriter::WriteOfDesks(const Place& place, const Group& group) const {
  hb::Relation relation = place.asked->relation();
  relation.set_text(place.asked->text_of_desks());
  if (place.target != nullptr) relation.add_targets(place.target->name());
  if (relation.text().find("{seat}") == std::string::npos) return writer_.Write(relation, group);
  relation.set_text(Fill(relation.text(), {{"seat", "{object}"}}));
  Group seats;
  for (const auto& [name, objects] : writer_.groups()) {
    for (const v1::Object* one : objects) {
      const bool here = one->zone_id() == group.front()->zone_id() && one->role() != v1::OBJECT_ROLE_TERTIARY;
      if (one->category() == "chair" && here && seats.size() < group.size()) seats.push_back(one);
    }
    if (!seats.empty()) break;
  }
  return seats.empty() ? std::vector<v1::Sentence>() : writer_.Write(relation, seats);
}

std::vector<v1::Sentence> PlaceWriter::WriteBetween(const Place& place, const Group& group) const {
  std::vector<v1::Sentence> sentences;
  for (const v1::Object* object : group) {
    const v1::Object* first = Neighbour(*place.target, *object, nullptr);
    const v1::Object* second = first == nullptr ? nullptr : Neighbour(*place.other, *object, first);
    if (second == nullptr) continue;
    const hb::Relation relation =
        Filled(place, {{"first", writer_.NameOf(*first)}, {"second", writer_.NameOf(*second)}});
    v1::Sentence sentence = writer_.WriteOne(relation, {object}, {}, 0);
    sentence.add_subject_ids(first->id());
    sentence.add_subject_ids(second->id());
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

// One of that class, or of what came in its place: of the object's own zone first, and not `other`.
const v1::Object* PlaceWriter::Neighbour(const hb::Furniture& furniture, const v1::Object& object,
                                         const v1::Object* other) const {
  google::protobuf::RepeatedPtrField<std::string> classes;
  *classes.Add() = furniture.name();
  const v1::Object* best = nullptr;
  for (const std::string& name : WithSubstitutes(classes, program_)) {
    const auto found = writer_.groups().find(name);
    if (found == writer_.groups().end()) continue;
    for (const v1::Object* one : found->second) {
      if (one == &object || one == other) continue;
      if (best == nullptr || (best->zone_id() != object.zone_id() && one->zone_id() == object.zone_id())) best = one;
    }
  }
  return best;
}

// Into the one corner that is meant: its back on one wall, a side on the other.
std::vector<v1::Sentence> PlaceWriter::WriteCorner(const Place& place, const Group& group) const {
  const std::optional<int> corner = CornerOf(room_, place.side);
  if (!corner) return writer_.Write(place.asked->relation(), group);
  const int after = *corner, before = (*corner + room_.walls_size() - 1) % room_.walls_size();
  // The back leaves windows and doors free where it can. Along a wall that begins in the corner the left side meets the
  // other one, along a wall that ends there the right side.
  const bool on_after = HasOpenings(room_, before) || !HasOpenings(room_, after);
  hb::Relation back = place.asked->relation(), side = back;
  back.set_text(fmt::format("The {{object}}'s back is against {}.", TheWall(room_, on_after ? after : before)));
  side.set_text(fmt::format("The {{object}}'s {} side is against {}.", on_after ? "left" : "right",
                            TheWall(room_, on_after ? before : after)));
  std::vector<v1::Sentence> sentences = writer_.Write(back, {group.front()});
  for (v1::Sentence& sentence : writer_.Write(side, {group.front()})) sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace flair::language
