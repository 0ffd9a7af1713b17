// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace flair::runtime {

// What this program was built from, see Producer.build; "unknown" when nobody knows. The same in all programs of one
// build. Defined in programs only (flair_program): libraries take it from WorkerContext, so that only programs are
// linked again when it changes.
std::string BuildName();

}  // namespace flair::runtime
