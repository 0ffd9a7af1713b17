// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace flair::runtime {

// Names the build of the running program, in hex: the linker's build id, or size and time of the file where it has
// none.
std::string BuildId();

// What this program was built from, see Producer.build; "unknown" when nobody knows. The same in all programs of one
// build. Defined in programs only (flair_program): libraries take it from WorkerContext, so that only programs are
// linked again when it changes.
std::string BuildName();

}  // namespace flair::runtime
