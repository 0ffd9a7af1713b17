// SPDX-License-Identifier: GPL-3.0-or-later
// What builders of several families make. Distances are null where the sentence gives none.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/frames.h"

namespace flair::translator {

// contact.cc

// The sides that a side word means for an object; "the long sides" depend on its size: front and back when it is wider
// than deep, else left and right. Where the word leaves the side open ("one long side"), the first possible one is
// taken and a note says so. Empty for an empty word.
std::vector<std::string> SidesOf(Composer& composer, const Placed& placed);

// The single side for parameters that take one; empty when none or several are named.
std::string OneSide(Composer& composer, const Placed& placed);

// "left" for "right" and so on; empty for empty.
std::string OppositeSide(const std::string& side);

// A call that lays the rug under or before the object, unless the sentence has laid it already.
void LayRug(const char* type, const Placed& rug, const Placed& object, Composer& composer);
// A small rug is laid before a piece, once, instead of standing beside it; false for everything else.
bool LaidBeside(const Placed& mover, const Placed& other, Composer& composer);
// `mover` stands against a target: an object, at the sides that are named, or a door, window or socket.
void Contact(const Placed& mover, const Target& target, Composer& composer);
// `mover` stands beside each target, at that side of it.
void Beside(const Placed& mover, const std::vector<Placed>& targets, const std::string& target_side,
            Composer& composer);
// "One chair on each side" means all chairs.
std::vector<Placed> OneAtEach(const Mention* mention, Composer& composer);
// One mover at each side of each target; more than two stand round it.
void Flank(const std::vector<Placed>& movers, const std::vector<Placed>& targets, Composer& composer);
// At least, at most or about so far apart; a good distance where `distance` is null.
void KeepDistance(const Placed& mover, const Placed& other, const Distance* distance, Composer& composer);

// distance.cc

// `mover` stays away from objects, a wall or a feature: at least so far, at most so far where the words say so, a good
// distance where `distance` is null.
void KeepAway(const Placed& mover, const Target& target, const Distance* distance, Composer& composer);
// Free space at the named side; in front and at both sides where none is named.
void KeepFreeBeside(const Placed& placed, const Distance* distance, Composer& composer);
// "X and Y 0.5 m apart".
void ApartFromEachOther(const Match& match, std::string_view detail, Composer& composer);

// feature.cc

// A does not block B. Doors, windows and sockets stay free, of objects the named sides stay accessible, the front where
// none is named. Detail "gap": objects are kept away from.
void NotBlock(const Match& match, std::string_view detail, Composer& composer);

// near.cc

void NearOne(const Placed& mover, const Target& target, const Distance* distance, Composer& composer);
// Whether the noun phrase means just what is spoken of.
bool IsOwnPart(const Mention& mention, const Composer& composer);
// A is near B. Detail "access": it is within reach.
void Near(const Match& match, std::string_view detail, Composer& composer);

// space.cc

// Free space at those sides of the object.
void KeepSpaceAt(const Placed& placed, const std::vector<std::string>& sides, const Distance* distance,
                 Composer& composer);
// Access at the named sides of the object, in front where none is named.
void KeepFront(const Placed& placed, Composer& composer);
// Free space at the named sides of the objects, in front where none is named.
void KeepSpace(std::vector<Placed> placed, const Distance* distance, Composer& composer);
// "On both sides", said of what is spoken of: free space there, or more of it. False when something else is meant.
bool KeepsOwnSides(const Mention* mover, const Mention& place, Composer& composer);
// Space at a place relative to B, or to the topic: detail is "front", "back", "sides", "around", "all" or "named".
void SpaceAt(const Match& match, std::string_view detail, Composer& composer);

}  // namespace flair::translator
