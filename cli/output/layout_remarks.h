// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

// What a person should know of a layout: its diagnostics, the edges that mean nothing (the first twenty) and the
// constraints that contradict each other, a line each ("remark", "dropped", "clash"), in the form of flair inspect;
// empty when there is nothing.
std::string LayoutRemarks(const v1::SolvedLayout& layout);

}  // namespace flair::cli
