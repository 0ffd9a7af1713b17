// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/pattern.h"

namespace flair::translator {

// Whether the words mean a door, window or socket that was spoken of before a call was made of it.
bool IsOfFeature(const Mention* mention, const Composer& composer);

// Builder: free space at a place relative to B, or to the topic. Tag: "front", "back", "sides", "around", or "named"
// for the side that the words name.
void SpaceAt(const Match& match, std::string_view tag, Composer& composer);

// Builder: "a clear path around the bed" is space; other vague things around it are not.
void PathAround(const Match& match, std::string_view tag, Composer& composer);

}  // namespace flair::translator
