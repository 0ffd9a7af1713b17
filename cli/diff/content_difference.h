// SPDX-License-Identifier: GPL-3.0-or-later
// Sections for the contents of artifacts; each is left out of the result when it has neither changes nor anything to
// compare.
#pragma once

#include <vector>

#include "cli/diff/difference.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

void CompareRooms(const v1::Room& a, const v1::Room& b, std::vector<Section>& sections);
void CompareZones(const v1::ZonePlan& a, const v1::ZonePlan& b, std::vector<Section>& sections);
void CompareObjects(const v1::ObjectList& a, const v1::ObjectList& b, std::vector<Section>& sections);
void CompareStyles(const v1::StyleSheet& a, const v1::StyleSheet& b, std::vector<Section>& sections);
// Sentences are paired by their words first, then by id.
void CompareSentences(const v1::ConstraintList& a, const v1::ConstraintList& b, std::vector<Section>& sections);
void CompareGraphs(const v1::LayoutGraph& a, const v1::LayoutGraph& b, std::vector<Section>& sections);
// With the graphs; also fills Difference.fates.
void CompareLayouts(const v1::SolvedLayout& a, const v1::SolvedLayout& b, Difference& difference);

// Verdicts, costs and measures of the layouts alone.
void CompareOutcomes(const v1::SolvedLayout& a, const v1::SolvedLayout& b, std::vector<Section>& sections);
// "satisfied", "violated" or "dropped".
const char* StatusName(v1::OutcomeStatus status);

}  // namespace flair::cli
