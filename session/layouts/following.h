// SPDX-License-Identifier: GPL-3.0-or-later
// What goes along with pieces that are put elsewhere.
#pragma once

#include <map>
#include <string>

#include "session/layouts/lists.h"

namespace flair::session {

using PlacesById = std::map<std::string, v1::Placement>;

// `put` with the places of what follows: what stands on a piece always; what is drawn up to it, as chairs to a table,
// and what hangs above it, where it moves along its wall, only where it is not locked and there is room for it.
PlacesById WithFollowers(const v1::SolvedLayout& layout, const PlacesById& put);

}  // namespace flair::session
