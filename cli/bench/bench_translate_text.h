// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of translations, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/bench_translate_score.h"

namespace flair::cli {

// "near(object=floor_1, target=floor_0)".
std::string EdgeText(const v1::ConstraintEdge& edge);

// Tables by kind of list, by function and by room, and the totals. `cpu_ms` is of all translations together.
std::string TranslateScoreText(const TranslateScore& score, double cpu_ms);

// Every sentence of which something is not correct: what is accepted, what was made, what was remarked.
std::string TranslateMissesText(const TranslateScore& score);

// All of it, with the lines that could not be measured.
std::string TranslateScoreToJson(const TranslateScore& score, const std::vector<std::string>& failures, double cpu_ms);

}  // namespace flair::cli
