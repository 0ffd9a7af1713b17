// SPDX-License-Identifier: GPL-3.0-or-later
// Where pieces are told to go, as sentences that a translator reads.
#pragma once

#include <optional>
#include <vector>

#include "room/scene/room.h"
#include "session/sentences/piece_wishes.h"
#include "session/sentences/spoken.h"

namespace flair::session {

// "Move the screen to the opposite wall", "the sofa has the window on its left"; nothing for clauses of other acts.
std::optional<std::vector<WishedSentence>> PlacesSaid(const Spoken& spoken, const v1::SolvedLayout& layout,
                                                      const Room& room);

// "The {} is in the south-east corner" as sentences about a corner and its two walls; others stay one.
std::vector<WishedSentence> WithCorners(const WishedSentence& wished, const v1::Room& room);

}  // namespace flair::session
