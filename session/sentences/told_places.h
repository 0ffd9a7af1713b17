// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces told by where they stand: "the painting above the bed", "the nightstand on the left".
#pragma once

#include <optional>
#include <string>

#include "session/layouts/lists.h"
#include "session/sentences/forms.h"

namespace flair::session {

// Words for a place behind a name.
struct ToldPlace {
  // The name of its list behind "told: ", such as "above".
  std::string relation;
  // The name that it is told of, and what the place is told by; that is empty for sides of the room.
  Span head, tail;
};

// Nothing when no part of the span tells a place.
std::optional<ToldPlace> ReadToldPlace(const Tokens& tokens, Span span);

// Those of `ids` that stand so to the pieces `at`: the nearest ones where being near is all that is told.
ObjectIds StandingThere(const ObjectIds& ids, const std::string& relation, const ObjectIds& at,
                        const v1::SolvedLayout& layout);
// The same to a part of the room: "the window", "the north wall", "the corner". Nothing when the words mean none.
std::optional<ObjectIds> StandingThere(const ObjectIds& ids, const std::string& relation, const Tokens& tokens,
                                       Span part, const v1::SolvedLayout& layout);
// Those at one side of the room, such as "west"; all that are about as far that way as the first one.
ObjectIds StandingFarthest(const ObjectIds& ids, const std::string& side, const v1::SolvedLayout& layout);

}  // namespace flair::session
