// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of meanings ask of code: sides, groups that are named together, and the meanings that are procedures.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "english/frames/frames.h"
#include "translator_worker/grammar/composer.h"

namespace flair::translator {

// A meaning that is a procedure, under its name.
struct Procedure {
  std::string_view name;
  Builder build;
};
std::vector<Procedure> GroupProcedures();
std::vector<Procedure> SpaceProcedures();

// sides.cc

// The sides that a side word means for an object; "the long sides" depend on its size: front and back when it is wider
// than deep, else left and right. Where the word leaves the side open ("one long side"), the first possible one is
// taken and a note says so. Empty for an empty word.
std::vector<std::string> SidesOf(Composer& composer, const Placed& placed);
// The same of sides that are to be got at; "one side" is the usual one unless another of the object is among `all`.
std::vector<std::string> OpenSidesOf(Composer& composer, const Placed& placed, const std::vector<Placed>& all);
// The single side for parameters that take one; empty when none or several are named.
std::string OneSide(Composer& composer, const Placed& placed);
// "left" for "right" and so on; empty for empty.
std::string OppositeSide(const std::string& side);
// Whether the noun phrase names several sides of what is spoken of, "on both sides", or one more after another: free
// space there, where another thing would be beside them.
bool AreOwnSides(const Mention& place, const Composer& composer);

// groups.cc

// Movers with what each of them is related to.
using Groups = std::pair<std::vector<Placed>, std::vector<Placed>>;
// Two groups of which each member is meant with each of the other: two objects, or "the racks and the desk". Both
// empty, with a remark, when it is not two.
Groups TwoGroups(const Mention* mention, Composer& composer);
// All of several with the first of them; one alone with what it was related to last.
Groups AllAndFirst(const Mention* mention, Composer& composer);
// The movers; "one chair on each side" means all chairs, where the place, unless it is null, names several sides.
std::vector<Placed> OneAtEach(const Mention* mention, const Mention* place, Composer& composer);
// Whether the noun phrase is of that kind: "in-room" (a feature that the room has), "area" ("the shower area"), "many"
// (a list), "some-feature" (with a feature in it), "sided" (with a side in it), "bare" (a side of what is spoken of),
// "own-part" (just what is spoken of), "own-sides" (AreOwnSides), "several-things" (two that are named, or several of a
// name), or a sort of forms.
bool MentionIs(const std::string& kind, const Mention& mention, const Composer& composer);
// Whether the place of the fact may be at what is spoken of itself: free space, when nobody else is.
bool MayBeOwnSpace(const Match& match, const Composer& composer);

}  // namespace flair::translator
