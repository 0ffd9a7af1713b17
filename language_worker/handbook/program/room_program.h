// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/piece_words.h"

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
  PieceSize size = {};                     // as asked for
  int in_each = 0;                         // that many are a group of their own; 0 when nobody says so
  bool in_rows = false;                    // those stand side by side, not back to back
  bool behind_each_other = false;          // stands in rows
  bool own_rows = false;                   // in rows that the brief wants and its kind of room does not know
  int abreast = 0;                         // of a row, so many stand without a way between them; 0 for all
  double way_m = 0;                        // that way
  int essential = 0;                       // so many of them the room cannot do without
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
  std::vector<const hb::Essential*> essentials;                  // what the room cannot do without
  double primary_scale = 1;
  int max_tertiaries = 12;
  bool listed = false;  // whether the brief lists what is in the room, rather than naming a piece or two
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
template <typename Classes>
std::vector<std::string> WithSubstitutes(const Classes& classes, const RoomProgram& program) {
  std::vector<std::string> all;
  for (const std::string& name : classes) {
    all.push_back(name);
    for (const auto& [went, came] : program.substitutes) {
      if (went == name && !Includes(all, came)) all.push_back(came);
    }
  }
  return all;
}

// The program for a room of that floor area. Deterministic.
RoomProgram MakeRoomProgram(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice);

// Questions to a program that is being made.

bool Lists(const std::vector<ProgramItem>& items, const std::string& name);
bool Lists(const RoomProgram& program, const std::string& name);

bool HasZone(const RoomProgram& program, const std::string& name);

// The zone where a class belongs when nothing says so; empty when there are none.
std::string HomeOf(const hb::Furniture& furniture, const RoomProgram& program);

// Takes a class out of a program.
void Remove(const std::string& name, RoomProgram& program);

// Brings what the brief asks for into the program of its kind of room: wishes with the seats that belong to them, what
// it refuses, one piece for each person, and nothing else where it says so.
void ApplyWishes(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program);

// Of the stock of its kind of room the less stays, the more pieces the brief names: from four on, pieces or people who
// need it aside, only lamps and pictures. What the room cannot do without stays, and must be marked.
void KeepStock(const BriefFacts& facts, RoomProgram& program);

// A television that is asked for has its stand: brings a host for what is too large for any other top, where the brief
// puts it on none.
void BringHosts(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program);

// How many classes of pieces the brief names that stand or hang in the room.
int PiecesNamed(const BriefFacts& facts);

// Whether what the brief lists goes with the room's kind at all: curtains are sewn in a "spare room" without a bed.
bool DoesWhatItsKindDoes(const BriefFacts& facts, const RoomProgram& program);

// How many can sit round a table of that size: 0.6 m each along its sides, one at each end that is wide enough; round
// ones by their circumference.
int SeatsRound(const hb::Furniture& table, double width_m, double depth_m);

// The least width from `start_m` on at which that many can sit round a table of that depth.
double WidthForSeats(const hb::Furniture& table, int seats, double start_m, double depth_m);

// Says which seats belong to which pieces, takes as many tables as the people need, and gives every table with its
// chairs, and every row of what stands in rows, a zone of its own: they are placed together.
void SplitIntoGroups(const BriefFacts& facts, double area_m2, const Handbook& handbook, RoomProgram& program);

}  // namespace flair::language
