// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "tests/fixtures/programs.h"

namespace flair::testing {

// Runs the Khronos glTF validator on files; exit code 0 when it found no errors and no warnings. Installs it with npm
// into the build folder when it is not there yet; when that fails, the exit code is that of npm and `err` what it said.
Finished ValidateGlb(const std::vector<std::filesystem::path>& files);

}  // namespace flair::testing
