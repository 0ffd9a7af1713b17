// SPDX-License-Identifier: GPL-3.0-or-later
// How two artifacts of a kind differ, by meaning.
#pragma once

#include <string>
#include <vector>

#include "flair/v1/artifact.pb.h"
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

}  // namespace flair::cli
