// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes as people ask for them: "20 cm longer", "bigger", "2.4 by 2.2 m".
#pragma once

#include <string>

#include "session/sentences/spoken.h"

namespace flair::session {

// What the clause makes of an object; without fields when that is its size already. `share`: how much of a change that
// names no figure, 1 for all of it.
v1::ResizeObject SizeAfter(const v1::Object& object, const Spoken& spoken, double share);

// "3.00 m long (was 1.80 m)", "2.40 m x 2.20 m (was 3.00 m x 2.20 m)".
std::string SizeChange(const v1::Object& before, v1::ResizeObject size, const Spoken& spoken);

}  // namespace flair::session
