// SPDX-License-Identifier: GPL-3.0-or-later
// How two artifacts of a kind differ, by meaning.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// What became of one thing from A to B.
enum class Became { kAdded, kRemoved, kChanged, kBetter, kWorse };

struct Change {
  Became became = Became::kChanged;
  std::string subject;    // such as "desk" or a sentence
  std::string words;      // such as "moved 0.35 m west, turned 90° left"; may be empty
  nlohmann::json detail;  // the same in figures, an object; may be null
};

// Things of one sort.
struct Section {
  std::string title;  // such as "objects"
  std::vector<Change> changes = {};
  int same_count = 0;
  std::string note = {};  // about the whole; may be empty
};

// What became of an object: ids in A and B (empty where it is not), and whether and how that shows on a plan.
struct ObjectFate {
  std::string a_id;
  std::string b_id;
  std::string words;
};

struct Difference {
  v1::ArtifactKind kind = v1::ARTIFACT_KIND_UNSPECIFIED;
  bool content_is_same = false;  // byte for byte
  bool origin_is_same = false;   // producer, options and ids of what it was made from
  std::vector<Section> sections = {};
  std::vector<ObjectFate> fates = {};  // layouts: of the objects that are not where and what they were, in A's order

  bool IsEmpty() const;
};

// Compares two artifacts by what they mean. INVALID_ARGUMENT when they are of different kinds; the two kinds of
// constraint lists go together.
absl::StatusOr<Difference> CompareArtifacts(const v1::Artifact& a, const v1::Artifact& b);

// For people: a line per section and one per change. `a` and `b` are the names that they were given by.
std::string DifferenceText(const Difference& difference, const std::string& a, const std::string& b);

// For programs: kind, a, b, content_is_same, origin_is_same, and sections with their changes.
std::string DifferenceJson(const Difference& difference, const std::string& a, const std::string& b);

// Sections for the contents of artifacts; each is left out of the result when it has neither changes nor anything to
// compare.

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
