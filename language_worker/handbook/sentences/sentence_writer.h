// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/sentences/sentence_slots.h"

namespace flair::language {

// Objects of one name, in list order.
using Group = std::vector<const v1::Object*>;

// Whether a piece takes the middle of the top that it stands on: the one of the largest footprint does, and flat things
// (a runner, a mat) lie under the others. False for what stands on no top, and on one with an opening in its middle.
bool TakesCentre(const v1::ObjectList& objects, const v1::Object& object);

// "bookshelves" of "bookshelf": as the class says, or by rule.
std::string PluralOf(const std::string& name, const Handbook& handbook);

// Writes the sentences of relations about groups of objects: decides whether a relation applies, pairs objects with
// partners and fills in the words. The arguments must outlive it.
class SentenceWriter {
 public:
  // `spoken` has the same objects by the names that sentences call them by, where those are others than their classes'.
  SentenceWriter(const v1::Room& room, const v1::ZonePlan& zones, const v1::ObjectList& objects,
                 const Handbook& handbook, const RoomProgram& program, const Choice& choice,
                 const v1::ObjectList* spoken = nullptr);

  const std::map<std::string, Group>& groups() const { return groups_; }

  // The sentences of one relation about one group, without ids; empty when its condition or its partner is missing. For
  // a tertiary without `targets` the partner is its host. `further` are placeholders that only the caller knows.
  std::vector<v1::Sentence> Write(const hb::Relation& relation, const Group& group, const Slots& further = {}) const;

  // One sentence about all of `subjects`, whatever the relation's condition; `number` counts those of a relation.
  v1::Sentence WriteOne(const hb::Relation& relation, const Group& subjects, const Group& targets, std::size_t number,
                        const Slots& further = {}) const;

  // Whether it takes the middle of its top, see above.
  bool IsCentral(const v1::Object& object) const { return TakesCentre(objects_, object); }

  // Whether they stand in a row with ways in it.
  bool HasWays(const Group& group) const;

  // Whether they stand in rows, or do so only because the brief wants them to.
  bool StandsInRows(const Group& group) const;
  bool StandsInOwnRows(const Group& group) const;
  // Whether they are pulled up to another piece.
  bool IsSeated(const Group& group) const;
  // Whether they stand together by themselves: in an island, back to back and side by side, or in one of several rows.
  bool IsTogether(const Group& group) const;

  // "nightstand", or "second nightstand" when there are several.
  std::string NameOf(const v1::Object& object) const;
  // Objects as what a placeholder stands for.
  Slot SlotOf(const Group& group) const;

 private:
  bool Applies(const hb::Relation& relation, const Group& group) const;
  // Whether another object of that name stands in the zone of `object`.
  bool IsInZoneOf(const v1::Object& object, const std::string& name) const;
  // Whether one of the relation's targets does. Never for what hangs or stands on something.
  bool HasPartnerInZone(const hb::Relation& relation, const v1::Object& object) const;
  // The partners of the relation: false when it asks for some and there are none.
  bool FindTargets(const hb::Relation& relation, const v1::Object& object, Group& targets) const;
  std::vector<v1::Sentence> WriteTogether(const hb::Relation& relation, const Group& group, const Slots& further) const;
  std::vector<v1::Sentence> WriteNeighbours(const hb::Relation& relation, const Group& group) const;
  // The line of the program that the object comes from; null when it is none of ours.
  const ProgramItem* LineOf(const v1::Object& object) const;
  Group RowBefore(const v1::Object& object) const;
  std::string NameOf(const Group& group) const;
  bool IsPlural(const std::string& name) const;
  // The object's zone, else the first; null in a room without any.
  const v1::Zone* ZoneOf(const v1::Object& object) const;
  std::string ZoneName(const v1::Object& object) const;
  std::string CornerOf(const v1::Object& object) const;

  const v1::Room& room_;
  const v1::ZonePlan& zones_;
  const v1::ObjectList& objects_;
  const Handbook& handbook_;
  const RoomProgram& program_;
  const Choice& choice_;
  double area_m2_;
  std::map<std::string, Group> groups_;
  // Names that sentences call objects by, and ids of those that share one, in list order.
  std::map<std::string, std::string> spoken_by_id_;
  std::map<std::string, std::vector<std::string>> ids_by_spoken_;
};

}  // namespace flair::language
