// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints and places of small things that a model wrote as lists in free text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "language_worker/recorded/object_names.h"
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

// Where one of the tertiaries goes.
struct RecordedPlacement {
  // One or two short sentences without the sizes; empty when the text has none for it.
  std::string text;
  // The floor objects that the place is told by, indices; empty when it names none.
  std::vector<int> hosts;
  // The item of the text that it is from; the same for several of a kind.
  int line = 0;
};

// One for each tertiary, in their order. Items are found by the words of the tertiaries' names, each once, the best
// first, but those of several equal tertiaries more often. Reads any bytes. Counts every item of the text's list.
std::vector<RecordedPlacement> ReadTertiaryText(std::string_view text, const std::vector<const v1::Object*>& tertiaries,
                                                const ObjectNames& floor_objects, Conversion& conversion);

}  // namespace flair::language
