// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "translator_worker/grammar/composer.h"

namespace flair::translator {

// A mat beside a piece lies partly under it; false when `mover` is no rug.
bool LaidBeside(const Placed& mover, const Placed& other, Composer& composer);

// One object touches another (or a window): sides as the words name them. Both sides named, left against right and so
// on; "the side of" leaves left or right open.
void Contact(const Placed& mover, const Target& target, Composer& composer);

// `mover` stands on the given side of each target, touching: "to the left of".
void Beside(const Placed& mover, const std::vector<Placed>& targets, const std::string& target_side,
            Composer& composer);

// Who moves in "one lamp on each side": all lamps; else what the noun phrase refers to.
std::vector<Placed> OneAtEach(const Mention* mention, Composer& composer);

// "On each side of": by turns left and right of each target, each with the facing side touching.
void Flank(const std::vector<Placed>& movers, const std::vector<Placed>& targets, Composer& composer);

// At least or at most so far apart, or both; 0 m is contact. Null means a good distance apart.
void KeepDistance(const Placed& mover, const Placed& other, const Distance* distance, Composer& composer);

}  // namespace flair::translator
