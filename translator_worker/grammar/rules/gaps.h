// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/pattern.h"

namespace flair::translator {

// `mover` stays away from objects, a wall or a feature: at least so far, at most so far where the words say so, a good
// distance where `distance` is null.
void KeepAway(const Placed& mover, const Target& target, const Distance* distance, Composer& composer);

// Free space at the named side; in front and at both sides where none is named.
void KeepFreeBeside(const Placed& placed, const Distance* distance, Composer& composer);

// Builders of gaps. Between: every pair of the list B; "them" is the last pair spoken of, or the objects that the
// sentence is about; tag "touching" leaves no gap. BetweenOrAnything: "between the backs of the chairs and any wall or
// furniture" is free space there. BetweenAndWall: B and the wall C. ApartFromEachOther: "X and Y 0.5 m apart".
void Between(const Match& match, std::string_view tag, Composer& composer);
void BetweenOrAnything(const Match& match, std::string_view tag, Composer& composer);
void BetweenAndWall(const Match& match, std::string_view tag, Composer& composer);
void ApartFromEachOther(const Match& match, std::string_view tag, Composer& composer);

// Builder: a bare distance belongs to the fact before it, to its pair, else it is free space in front.
void BareDistance(const Match& match, std::string_view tag, Composer& composer);

// Builder: refuses "nothing between the sofa and the TV stand".
void NothingBetween(const Match& match, std::string_view tag, Composer& composer);

}  // namespace flair::translator
