// SPDX-License-Identifier: GPL-3.0-or-later
// How two artifacts of a kind differ, by meaning.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/diff/message_difference.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

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

// A graph's parts and its calls.
void CompareGraphs(const v1::LayoutGraph& a, const v1::LayoutGraph& b, std::vector<Section>& sections);
// With the graphs; also fills Difference.fates.
void CompareLayouts(const v1::SolvedLayout& a, const v1::SolvedLayout& b, Difference& difference);

}  // namespace flair::cli
