// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/mention.h"

namespace flair::translator {

// Free space of at least `distance` (null: as much as the optimizer takes) at these sides of an object.
void KeepSpaceAt(const Placed& placed, const std::vector<std::string>& sides, const Distance* distance,
                 Composer& composer);

// Free space at the sides that are named, the sides of one object in one call; at the front where none is. Of "one
// side" the one that people use.
void KeepSpace(std::vector<Placed> placed, const Distance* distance, Composer& composer);

// "Players sit on two opposite sides", of the piece that is spoken of: its own sides are kept free, or
// also those of the space that was spoken of last. False when the
// words say something else.
bool KeepsOwnSides(const Mention* mover, const Mention& place, Composer& composer);

// Free space where people use what is spoken of: behind chairs, at a side of beds, in front of everything else.
void KeepUsableSpace(const Distance* distance, Composer& composer);

}  // namespace flair::translator
