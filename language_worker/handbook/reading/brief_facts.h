// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/finishes.h"
#include "language_worker/handbook/reading/opening_reader.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/shape_phrase.h"
#include "language_worker/handbook/reading/size_phrase.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

// A piece of furniture that the brief asks for by name.
struct Wish {
  const hb::Furniture* furniture = nullptr;
  int count = 1;
  int seats = 0;          // "a table for eight": that many can sit at each; 0 when it is not said
  bool counted = true;    // false: a plural without a number, so that `count` is the least
  bool optional = false;  // "if there is room"
  PieceSize size = {};    // of each; within what the class can be
  // The word for several classes that it was named by, such as "chair"; null for a class's own name.
  const hb::Noun* noun = nullptr;
  int in_each = 0;       // "in blocks of four": that many stand together; 0 when it is not said
  bool in_rows = false;  // "in rows of four": side by side
};

// Where the brief wants a piece.
struct Place {
  const hb::Furniture* furniture = nullptr;
  const hb::AskedPlace* asked = nullptr;
  const hb::Furniture* target = nullptr;  // the other piece; null where the words name the room
  const hb::Furniture* other = nullptr;   // of two that it stands between
  std::string side;                       // of a wall or corner, which: "north", "far left"; empty for any
  int which = -1;                         // of several pieces the first, the second; -1 for all
  double length_m = 0;                    // "at least 1.5 m apart"; for sentences that tell a length
  int walls = 1;                          // "on three walls": shared out over so many
  std::string said;                       // the words of the brief
  std::string called;                     // its words for the piece

  // "cat basket under the table".
  std::string Words() const { return called + " " + said; }
};

// A kind of room that the room is besides its first: "kitchen/living/dining", "a bedroom with a home office".
struct FurtherKind {
  const hb::Archetype* archetype = nullptr;
  double share = 1;  // of what such a room usually is
};

// Pieces that stand together, and are there several times.
struct NamedSet {
  int count = 0;
  std::string name;                // the brief's word for it; empty for that of a person
  std::size_t begin = 0, end = 0;  // tokens that list what is in each
  std::size_t noun = 0;            // the token of its name, which may be a piece as well
  std::vector<const hb::Furniture*> pieces;
};

// More of one class in a room are not furnished by hand; nor more small things of one kind.
inline constexpr int kMostOfAKind = 40, kMostSmallThings = 8;
inline int MostOf(const hb::Furniture& furniture) {
  return furniture.kind() == hb::FURNITURE_KIND_SURFACE ? kMostSmallThings : kMostOfAKind;
}

// What a brief says, as far as the handbook knows the words. Pointers go into the handbook and are never null.
struct BriefFacts {
  SizeRequest size;
  ShapeRequest shape;
  RunForm run_form = RunForm::kAny;  // of a kitchen's units
  const hb::Archetype* archetype = nullptr;
  std::vector<FurtherKind> also;               // the room is these, too: "kitchen/living/dining"
  std::vector<std::string> other_rooms;        // named beside it, not furnished: "ensuite"
  bool archetype_named = false;                // false: the fallback, or a guess from hints
  std::vector<Wish> wishes;                    // in the order of the text, one per class
  std::vector<const hb::Furniture*> too_many;  // of which more than kMostOfAKind are asked for
  std::vector<const hb::Furniture*> refusals;
  std::vector<std::pair<const hb::Furniture*, const hb::Furniture*>> also_serves;  // the first as the second, too
  std::vector<std::string> sizes_not_had;  // "9 m desk": sizes of pieces that none of their class has
  std::vector<NamedSet> sets;
  std::vector<Place> places;
  std::vector<std::string> places_loosely_kept;  // "desk to the left of the window: is near the window."
  std::vector<std::string> places_not_known;     // words for places of which nothing could be made
  OpeningWishes openings;
  bool nothing_else = false;  // "only a bed and a wardrobe"
  std::vector<const hb::Theme*> themes;
  std::vector<const hb::Need*> needs;
  std::vector<const hb::Style*> styles;                 // named directly: "scandinavian"
  std::vector<const hb::NamedColour*> colours;          // of the room
  std::vector<const hb::NamedColour*> refused_colours;  // that are not to be in it
  std::vector<AskedFinish> finishes;
  std::vector<std::pair<const hb::Furniture*, const hb::NamedColour*>> object_colours;  // "a green armchair"
  std::vector<std::pair<const hb::Furniture*, std::string>> object_materials;           // "a glass table", "dark oak"
  std::optional<int> people;
  std::string people_said;  // its words for them
  PeopleInGroups people_in;
  std::optional<int> year;               // of its time: "around 1750"
  std::string room_words;                // what it calls the room; where no kind is named, its first words
  std::vector<std::string> unheard;      // other words of which nothing was made: "of solid oak"
  std::vector<std::size_t> told;         // tokens that a remark quotes already
  std::vector<std::string> not_known;    // things asked for that the handbook has no word for: "proofing cabinet"
  std::vector<std::string> made_plain;   // of these what is made all the same, without knowing more than the name
  std::vector<std::string> other_names;  // of pieces called otherwise: "\"flipchart\" as easel"
  std::vector<Correction> corrections;   // of misspelt words
  bool reads_as_english = true;          // false: most likely another language

  // The handbook with the classes that only this brief has; null when it has none.
  std::shared_ptr<const Handbook> own_handbook;
  std::map<std::string, std::string> base_of_own;  // the handbook's class that each of them is a kind of, by names

  const Handbook& HandbookOr(const Handbook& other) const { return own_handbook ? *own_handbook : other; }
};

// Floor area of the room, as far as the brief says it, square metres; else what is usual.
double AreaOf(const BriefFacts& facts);

// A brief while it is read.
struct Reading {
  const Handbook& handbook;
  const BriefText& text;
  std::vector<bool>& used;  // tokens that have a meaning already
  BriefFacts& facts;

  const std::vector<Token>& tokens() const { return text.tokens(); }
  void Use(std::size_t begin, std::size_t end) const { Mark(begin, end, used); }
  // That they are read a remark says, or the room itself.
  void Tell(std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i) facts.told.push_back(i);
  }
};

// Reads a brief. The same text and handbook give the same facts. Errors as ReadSize.
absl::StatusOr<BriefFacts> ReadBrief(const v1::Brief& brief, const Handbook& handbook);

}  // namespace flair::language
