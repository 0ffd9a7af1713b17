// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/edit_lists.h"

namespace flair::session {

// Added pieces that are put by an edit onto what they are copies of, a piece of their name and size, are put beside it
// instead: all of them by the same way to the nearest free floor where there is such a way, else each by its own. What
// finds none stays.
void PutCopiesBeside(const v1::SolvedLayout& layout, EditList& edits);

}  // namespace flair::session
