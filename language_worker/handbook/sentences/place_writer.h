// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences of what a brief says about the places of its pieces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/rooms/wall_run.h"
#include "language_worker/handbook/sentences/sentence_writer.h"

namespace flair::language {

// Writes what a brief says of the places of its pieces, for the walls and pieces that the room has. The arguments must
// outlive it.
class PlaceWriter {
 public:
  PlaceWriter(const v1::Room& room, const RoomProgram& program, const std::vector<Place>& places,
              const SentenceWriter& writer)
      : room_(room), program_(program), places_(places), writer_(writer) {}

  // The sentences about those of `group` whose place it is, without ids; empty when the room has none of what the place
  // is told by.
  std::vector<v1::Sentence> Write(const Place& place, const Group& group) const;

  // What keeps those of `group` that are in a run at their places of it: their wall, and what is at their sides.
  std::vector<v1::Sentence> WriteRun(const std::vector<RunPlace>& run, const Group& group) const;

 private:
  std::vector<v1::Sentence> WriteAbout(const Place& place, Group subjects) const;
  // "One desk by the door": the group may be a part of all that have the name.
  Group SubjectsOf(const Place& place, const Group& group) const;
  // Barber's chairs, or their mirrors, on a wall: what the kind of room has them stand before, or hang above, is there.
  Group WhatGoesThere(const Group& group) const;
  // Whoever sits at a desk looks over its back.
  std::vector<v1::Sentence> WriteOfDesks(const Place& place, hb::Relation relation, const Group& group,
                                         const Slots& further) const;
  // What stands for the target where it is placed after the furniture: of a thing on a top what carries it; of a wall
  // piece the wall that it hangs on, as a slot, or what it hangs above.
  std::string StandIn(const Place& place, Slots& further) const;
  std::vector<v1::Sentence> WriteHung(const hb::Relation& relation, const Place& place, const Group& group,
                                      const Slots& further) const;
  // What "{wall}" stands for; nothing where the words name a wall that the room does not have.
  std::optional<Slot> WallFor(const std::string& side) const;
  // "Shelves on both long walls", "two beds against opposite walls": one half here, one there.
  std::vector<v1::Sentence> WriteOnWalls(const Place& place, const Group& group) const;
  std::vector<v1::Sentence> WriteAlongTheMiddle(const Place& place, const Group& group) const;
  std::vector<v1::Sentence> WriteBetween(const Place& place, const Group& group) const;
  // Into the corners that are meant: each with its back on one wall, a side on the other.
  std::vector<v1::Sentence> WriteCorners(const Place& place, const Group& group) const;
  std::vector<v1::Sentence> WriteCorner(const Place& place, const Group& one, int corner) const;
  // One of that class, or of what came in its place: of the object's own zone first, and not `other`.
  const v1::Object* Neighbour(const hb::Furniture& furniture, const v1::Object& object, const v1::Object* other) const;

  const v1::Room& room_;
  const RoomProgram& program_;
  const std::vector<Place>& places_;  // all
  const SentenceWriter& writer_;
};

}  // namespace flair::language
