// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"

namespace flair::renderer {

// The layouts of this folder, for tests.
const std::vector<std::string>& SampleLayouts();

// Reads `name`.textproto of this folder; stops the test program when it cannot.
v1::SolvedLayout ReadSample(const std::string& name);

}  // namespace flair::renderer
