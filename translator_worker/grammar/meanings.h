// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of facts: the meanings of english/data (protos/flair/english/v1/language.proto), which map a relation,
// the kind of its mover and the kind of its target to calls.
//
// `movers` and `targets` of a meaning name a slot of the frame (A, B, C; an A that is missing is whatever is spoken of)
// or "topic", "subjects", "pair" (mover and target of the fact before), "two" (two groups that are named together),
// "all to first". Words after the slot: "at B" puts the movers or targets at the sides that B names, "any" takes all of
// a list with "or", "alone" means targets that may be movers themselves, "own" the same where free space is spoken of,
// "first" only the first object, "shared" one target for each mover, "each" the same where the frame says "each table";
// for movers "each" means all that bear the name where only one is said to be at each side.
//
// A test is a subject with "!" before it to deny it and one of
//   nothing         it is there: A, B, C, D (the figure), mover, target, topic, subject, pair, detail; calls: an
//   earlier
//                   fact of the sentence made some; feature: one was named before; laid: a rug is; several movers;
//                   same object; own: the target moves itself, or nothing does; opposed sides;
//                   said: a person says the sentence
//   :kind|kind      of that kind: for slots a sort of frames.h or one of MentionIs, for D one of DistanceIs, for movers
//                   and targets one of PlacedIs or a list of english/data, for targets also a RefKind
//   =name|name      of that name: slots, target, scope, detail; a target without a name after "=": of any name
//   .side=x|*end    with that side, or without "=" any side
//
// The value of an argument is A or B (id of mover and target, or what the target is called), A.side (the one side that
// is named), A.sides, A.open (sides that are to be got at), A.first, B.opposite, B.zone, C.sides, D (the figure),
// B.opening (id of the door or window that is meant), B.wall and C.wall (the wall that the slot names), least, most,
// limit (most, unless exact), a number, detail, subject, last (feature), or is meant as it is written. "a/b" is b where
// a is empty. Without a value the argument is left out, after "=!" the call.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "english/frames/frames.h"
#include "flair/english/v1/language.pb.h"
#include "translator_worker/grammar/composer.h"

namespace flair::translator {

// Makes the calls of a fact with that meaning; the detail is its frame's own. Nothing for unknown meanings.
void MakeCalls(std::string_view meaning, const Match& match, std::string_view detail, Composer& composer);

// Makes the calls of the meaning's pairs, of these movers and that target, at that distance unless it is null.
void MakeCallsOf(std::string_view meaning, const std::vector<Placed>& movers, const Target& target,
                 const Length* distance, Composer& composer);

// Meanings that frames or other meanings name and that are neither in the data nor procedures.
std::vector<std::string> UnknownMeanings();

// The tables of meanings.h, parsed.

using Words = std::vector<std::string>;

Words Split(std::string_view text, char separator);

// One condition of a case, "!mover.side=front|back".
struct Condition {
  bool denied = false;
  std::string subject;
  char about = 0;  // ':', '=', '.' for sides, or 0 for being there
  Words values;

  explicit Condition(std::string_view text);
};

// A call to be, "near object=A target=B".
struct Template {
  struct Argument {
    std::string name;
    Words values;  // the first that is not empty counts
    bool required = false;
  };
  std::string type;
  std::vector<Argument> arguments;

  explicit Template(std::string_view text);
};

struct Case {
  std::vector<Condition> tests;
  std::vector<std::vector<Template>> calls;  // of each the first that can be made
  const english::v1::Case* data;

  explicit Case(const english::v1::Case& from);
};

struct Table {
  Words movers;
  Words targets;
  std::vector<Case> first;
  std::vector<Case> cases;
};

// By name. Those of english::Language::Get(), made on first use.
const std::map<std::string, Table, std::less<>>& Tables();
// Meanings that are procedures, by name.
const std::map<std::string_view, Builder>& Procedures();

}  // namespace flair::translator
