// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/pattern.h"

namespace flair::translator {

// Builder: A does not block B. Doors, windows and sockets stay free, of objects the named sides stay accessible, the
// front where none is named. Tag "gap": objects are kept away from.
void NotBlock(const Match& match, std::string_view tag, Composer& composer);

}  // namespace flair::translator
