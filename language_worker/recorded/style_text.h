// SPDX-License-Identifier: GPL-3.0-or-later
// Materials and colours as a model wrote them in free text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/recorded/conversion.h"
#include "language_worker/recorded/object_names.h"

namespace flair::language {

// The look of one thing.
struct RecordedLook {
  // "walls", "floor", "ceiling", "door" or "window"; empty for objects.
  std::string surface;
  // Indices of objects; empty for surfaces.
  std::vector<int> objects;
  std::string material;
  // The first colour that the handbook knows, in the text's own words.
  const hb::NamedColour* colour = nullptr;
  // At most a dozen words; may be empty.
  std::string description;
};

struct RecordedStyle {
  // The first sentence that says something about the whole; may be empty.
  std::string summary;
  std::vector<RecordedLook> looks;
};

// One look for every heading of a thing, whose properties ("Colour:", "Material:", "Style:") stand behind or under it.
// Things without a colour that the handbook knows are kept in the remarks. Reads any bytes.
RecordedStyle ReadStyleText(std::string_view text, const ObjectNames& objects, const Handbook& handbook,
                            Conversion& conversion);

// The colour of the handbook that a text names first, the longest name of several; null when it names none.
const hb::NamedColour* FindColour(std::string_view text, const Handbook& handbook);

}  // namespace flair::language
