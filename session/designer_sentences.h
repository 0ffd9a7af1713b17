// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "session/layout_acts.h"

namespace flair::session {

// What the handbook says of these objects in this room, uses marked; models of one's own are what their names end with.
// The handbook is read when it is first asked: errors as language::LoadHandbook. Thread-safe.
// `overlays` are folders of the user's own, see docs/handbook.md.
SentencesOf SentencesOfHandbook(const std::vector<std::string>& overlays);

}  // namespace flair::session
