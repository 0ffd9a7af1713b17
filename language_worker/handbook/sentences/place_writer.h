// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/sentences/sentence_writer.h"

namespace flair::language {

// Writes what a brief says of the places of its pieces, for the walls and pieces that the room has. The arguments must
// outlive it.
class PlaceWriter {
 public:
  PlaceWriter(const v1::Room& room, const RoomProgram& program, const SentenceWriter& writer);

  // The sentences about those of `group` whose place it is, without ids; empty when the room has none of what the place
  // is told by.
  std::vector<v1::Sentence> Write(const Place& place, const Group& group) const;

 private:
  Group SubjectsOf(const Place& place, const Group& group) const;
  std::vector<v1::Sentence> WriteOfDesks(const Place& place, const Group& group) const;
  std::vector<v1::Sentence> WriteBetween(const Place& place, const Group& group) const;
  std::vector<v1::Sentence> WriteCorner(const Place& place, const Group& group) const;
  const v1::Object* Neighbour(const hb::Furniture& furniture, const v1::Object& object, const v1::Object* other) const;

  const v1::Room& room_;
  const RoomProgram& program_;
  const SentenceWriter& writer_;
};

}  // namespace flair::language
