// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/choosing/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// A line of the list of what the room should hold, before it is known whether everything fits.
struct ProgramItem {
  const hb::Furniture* furniture = nullptr;
  const hb::ObjectEntry* entry = nullptr;  // null for wishes
  int count = 1;
  std::string zone;  // name; empty when it belongs to the whole room
  bool requested = false;
  int drop_order = 0;                      // higher goes first
  int seats = 0;                           // at each, as far as it is known how many
  const hb::Furniture* seat_of = nullptr;  // what it is pulled up to, in the same zone; null for what stands by itself
  bool optional = false;                   // asked for only if there is room
};

// What the room is to be, from the archetype, the needs, the themes and the wishes of a brief.
struct RoomProgram {
  const hb::Archetype* archetype = nullptr;
  std::vector<FurtherKind> also;         // of a room that is several kinds in one the others
  std::vector<hb::ZoneSpec> zones;       // most important first
  std::vector<ProgramItem> floor_items;  // most important first
  std::vector<ProgramItem> tertiary_items;
  std::vector<const hb::Changes*> changes;                       // of needs and themes, in order of application
  std::vector<std::pair<std::string, std::string>> substitutes;  // class that went, class that came for it
  double primary_scale = 1;
  int max_tertiaries = 12;
};

// Whether a condition holds, as far as area, room and chance go. `key` names the choice for `chance`.
bool Holds(const hb::Condition& condition, const hb::Archetype& archetype, double area_m2, const Choice& choice,
           const std::string& key);

// The archetype that the brief asks for, after needs and themes had their say ("a bedroom for a baby" is a nursery).
const hb::Archetype& EffectiveArchetype(const BriefFacts& facts, const Handbook& handbook);

// The other kinds that the room is, too; none where needs or themes made another room of it.
std::vector<FurtherKind> AlsoOf(const BriefFacts& facts, const hb::Archetype& archetype);

// Usual floor area, m2.
double UsualArea(const hb::Archetype& archetype);

// Needs first, then themes.
std::vector<const hb::Changes*> AllChanges(const BriefFacts& facts);

// The classes, each followed by what came in its place: a lamp for the double bed hangs over the vampire's coffin.
std::vector<std::string> WithSubstitutes(const google::protobuf::RepeatedPtrField<std::string>& classes,
                                         const RoomProgram& program);

// The program for a room of that floor area. Deterministic.
RoomProgram MakeRoomProgram(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice);

}  // namespace flair::language
