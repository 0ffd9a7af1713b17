// SPDX-License-Identifier: GPL-3.0-or-later
// Things that a brief names and the handbook has no class for: each gets a class that only this brief has, after the
// class that its last word names ("reagent cabinet"), else after what WordNet knows of it ("honey extractor"), else
// after the handbook's plain thing of its kind.
#pragma once

#include <string>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

struct OwnClass {
  hb::Furniture furniture;
  std::string base = {};  // name of the handbook's class that it is a kind of; empty for none
  bool unplaced = false;  // is a piece only if the brief lists it or says where it goes
  bool listed = false;    // among what the room is to have: "with a honey extractor, two kick wheels and ..."
  bool plain = false;     // nobody knows what it looks like or where it stands
  const hb::Furniture* like = nullptr;  // of an unplaced one: the class of the handbook that it is made like
};

// The classes for what a reading of the brief left over: `used` are the tokens that it understood. None of them for a
// thing that only sets a mood ("a touch of gold"), a part of the room, or a word for people.
std::vector<OwnClass> OwnClassesOf(const Handbook& handbook, const std::vector<Token>& tokens,
                                   const std::vector<Mention>& mentions, const std::vector<bool>& used);

// Of those the ones that are pieces: what is listed, and what has a place in `facts`, which were read with all of them.
// Each with what carries it.
std::vector<OwnClass> Placed(std::vector<OwnClass> classes, const BriefFacts& facts, const Handbook& handbook);

// Classes for pieces that the brief puts where their class does not belong: a potted plant on a table, a sculpture in a
// corner of the room, a television on the wall. Each is the class, carried otherwise.
std::vector<OwnClass> OtherwiseCarried(const BriefFacts& facts);

inline bool IsOnTheFloor(const hb::Furniture& furniture) {
  return furniture.kind() == hb::FURNITURE_KIND_FLOOR || furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED;
}

// The handbook's plain thing of that kind: what has no words of its own and is named as said.
const hb::Furniture* PlainThing(hb::FurnitureKind kind, const Handbook& handbook);

// Whether a class is only for a reading that finds out what carries it.
inline bool IsOfAnyKind(const hb::Furniture& furniture) { return furniture.category().empty(); }

}  // namespace flair::language
