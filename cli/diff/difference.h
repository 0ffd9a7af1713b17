// SPDX-License-Identifier: GPL-3.0-or-later
// How two artifacts of a kind differ, by meaning.
#pragma once

#include <google/protobuf/message.h>

#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// How two messages of one type differ, by their descriptors: what of a list is the same thing, and which fields of it
// changed. Types that need more than that have a row in the tables of message_difference.cc.

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

// Adds it when it has anything to tell.
void AddSection(Section section, std::vector<Section>& sections);

// "1.60 -> 1.80 m" for the field width_m; enough digits to tell the two apart.
std::string NumberWords(const std::string& field, double a, double b);

// A change for each field of the messages that differs: "width", "1.60 -> 1.80 m", with both values. Fields in `but`
// are not looked at.
Section FieldsSection(const std::string& title, const google::protobuf::Message& a, const google::protobuf::Message& b,
                      const std::set<std::string>& but = {});

// All of them in one change of `subject`; into `section`, which counts it as the same when no field differs.
void CompareThing(const std::string& subject, const google::protobuf::Message& a, const google::protobuf::Message& b,
                  const std::set<std::string>& but, Section& section);

// Everything that two messages hold: a section of their own fields, and one for each list of things and for each part
// that has such lists.
void CompareMessages(const google::protobuf::Message& a, const google::protobuf::Message& b,
                     std::vector<Section>& sections);

// One list of both: added, removed and changed items.
void CompareLists(const google::protobuf::Message& a, const google::protobuf::Message& b, const std::string& list,
                  std::vector<Section>& sections);

// Which things of two lists are the same: their indices in A and B; -1 where there is none.
struct Pair {
  int a = -1;
  int b = -1;
};

// Pairs things whose keys are equal, for each round of keys in turn among those that are left; several of one key in
// their order. All of A in its order, then what only B has. `a[round][i]` is a key; an empty one pairs nothing.
using Keys = std::vector<std::vector<std::string>>;
std::vector<Pair> MatchKeys(const Keys& a, const Keys& b);

// The items of a list of both messages.
std::vector<Pair> MatchItems(const google::protobuf::Message& a, const google::protobuf::Message& b,
                             const std::string& list);

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
