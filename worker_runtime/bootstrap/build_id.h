// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace flair::runtime {

// Names the build of the running program, in hex: the linker's build id, or size and time of the file where it has
// none.
std::string BuildId();

}  // namespace flair::runtime
