// SPDX-License-Identifier: GPL-3.0-or-later
// What a solve did and found, for people.
#pragma once

#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

// A line for the layout and each of its runner-ups that is complete. `files` names where each went, in that order;
// empty when they went nowhere.
std::string VariantsTable(const v1::SolvedLayout& layout, const std::vector<std::string>& files);

// Runner-up `index` of a layout as a layout of its own; its whole-room terms are not known here.
v1::SolvedLayout VariantOf(const v1::SolvedLayout& layout, int index);

// "45 of 50 constraints hold, OOB 0.00 %, OOR 0.00 %", for a caption.
std::string LayoutLine(const v1::SolvedLayout& layout);

// A runner-up with an account of all edges; the others hold floor objects only.
bool IsComplete(const v1::RunnerUp& runner_up);

// What a person should know of a layout: its diagnostics, the edges that mean nothing (the first twenty) and the
// constraints that contradict each other, a line each ("remark", "dropped", "clash"), in the form of flair inspect;
// empty when there is nothing.
std::string LayoutRemarks(const v1::SolvedLayout& layout);

}  // namespace flair::cli
