// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints that a model wrote as lists in free text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language_worker/recorded/conversion.h"
#include "language_worker/recorded/object_names.h"

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

}  // namespace flair::language
