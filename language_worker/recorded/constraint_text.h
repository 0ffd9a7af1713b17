// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints that a model wrote as lists in free text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/model/v1/constraint_answers.pb.h"
#include "language_worker/recorded/object_names.h"
#include "language_worker/recorded/prompt_lines.h"
#include "language_worker/recorded/recorded_room.h"

namespace flair::language {

// A sentence with the objects that it is about.
struct RecordedSentence {
  // Indices, ascending per name; those of the heading that it stands under, else those that it names.
  std::vector<int> objects;
  std::string text;
  // It says that it must be so.
  bool must = false;
};

enum class ConstraintTextKind {
  // Under a heading for each object; the heading's first name counts.
  kIntra,
  // Under headings for pairs, zones or nothing.
  kInter,
};

// A text, and what its names mean.
struct ConstraintText {
  std::string_view name;
  std::string_view text;
  ConstraintTextKind kind = ConstraintTextKind::kIntra;
  const ObjectNames& objects;
  const std::vector<std::string>& zone_ids;
};

// The sentences in the order of the text: one of each item, several where an item has several sentences. Reads any
// bytes.
std::vector<RecordedSentence> ReadConstraintText(const ConstraintText& text, Conversion& conversion);

// The changes that make of `before` what the model's `after` says, found by the sentences' objects and words: the same
// words stay, other words for it simplify, several for one split, and what has no counterpart is removed, but not more
// than half of all: then what could not be recognised is more than what was removed. `names` are the objects' names.
model::v1::CleaningAnswer FindChanges(const std::vector<PromptSentence>& before,
                                      const std::vector<RecordedSentence>& after,
                                      const std::vector<std::string>& names);

}  // namespace flair::language
