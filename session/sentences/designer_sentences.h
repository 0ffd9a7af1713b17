// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "language_worker/handbook/handbook.h"
#include "session/acts/layout_acts.h"

namespace flair::session {

// What the handbook says of these objects in this room, uses marked; models of one's own are what their names end with.
// Thread-safe.
SentencesOf SentencesOfHandbook(std::shared_ptr<const language::Handbook> handbook);

}  // namespace flair::session
