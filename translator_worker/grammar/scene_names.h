// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "english/frames/term.h"
#include "english/text.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"

namespace flair::translator {

using english::IsOneOf;
using english::Lexicon;
using english::Phrase;
using english::RefKind;
using english::Token;

// Which objects a name means first. Small things on tables, walls and ceilings are chosen after the sentences about
// floor objects are written: "the TV" there is the TV stand.
enum class NamedObjects { kAll, kFloorFirst };

// Finds the room's own objects, zones and walls in a sentence, by full name, by id, by the end of the name ("cauldron"
// for "large cauldron"), by number ("chair 2"), by zone ("the reading chair") or by a synonym. Furniture that the room
// lacks is found as absent. Borrows its arguments.
class SceneNames : public english::Names {
 public:
  SceneNames(const v1::Room& room, const v1::ZonePlan& zones, const v1::ObjectList& objects,
             NamedObjects named = NamedObjects::kAll);

  Found Find(const std::vector<Token>& tokens, size_t at) const override;

  // Index of the zone's main object: its first primary, else its first object; -1 when it has none.
  int MainObject(const std::string& zone_id) const;

 private:
  struct Candidate {
    int object;
    // Less is a better match.
    int rank;
  };

  void Add(const std::vector<std::string>& words, int object, int rank);
  void AddNamesOf(int object, int rank);
  Found FindObject(const std::vector<Token>& tokens, size_t at) const;
  Found FindInZone(const std::vector<Token>& tokens, size_t at) const;
  // "Nightstand 2", "chairs 1 and 2": keeps those with these numbers.
  void TakeNumbers(const std::vector<Token>& tokens, size_t at, Found& found) const;
  // Length of the zone's name at tokens[at], 0 when another word stands there.
  size_t ZoneLength(const v1::Zone& zone, const std::vector<Token>& tokens, size_t at) const;
  Found FindObjectByWords(const std::vector<Token>& tokens, size_t at) const;
  Found FindZone(const std::vector<Token>& tokens, size_t at) const;
  // "The eating area" of a zone "dining": another word for the same use.
  Found FindZoneByUse(const std::vector<Token>& tokens, size_t at) const;
  Found FindWall(const std::vector<Token>& tokens, size_t at) const;
  Found FindCorner(const std::vector<Token>& tokens, size_t at) const;
  // "Door 2", "window_1", "the north window" where the wall has one only.
  Found FindOpening(const std::vector<Token>& tokens, size_t at) const;

  const v1::Room& room_;
  const v1::ZonePlan& zones_;
  const v1::ObjectList& objects_;
  // Singular words joined by spaces; an empty list is furniture that the room does not have.
  std::map<std::string, std::vector<Candidate>> names_;
  // Whole names without any space, for "table lamp" and "tablelamp1".
  std::map<std::string, std::vector<Candidate>> joined_names_;
  // The number at the end of an object's name; 0 when it has none.
  std::vector<int> numbers_;
};

// The lower-case words of a name; underscores and hyphens separate.
std::vector<std::string> NameWords(const std::string& name);

}  // namespace flair::translator
