// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/pattern.h"

namespace flair::translator {

// `mover` is near one target, at most so far where the words say so; hanging things near or above it.
void NearOne(const Placed& mover, const Target& target, const Distance* distance, Composer& composer);

// "Easy access to the shelves" of a bookcase that is spoken of: it is the target itself.
bool IsOwnPart(const Mention& mention, const Composer& composer);

// Builder: A is near B. Tag "access": B is to be got at from A.
void Near(const Match& match, std::string_view tag, Composer& composer);

}  // namespace flair::translator
