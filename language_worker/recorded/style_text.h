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

struct RecordedColour {
  std::string name;
  // "#RRGGBB"; empty when no colour is known.
  std::string hex;
};

// The look of one thing.
struct RecordedLook {
  // "walls", "floor", "ceiling", "door" or "window"; empty for objects.
  std::string surface;
  // Indices of objects; empty for surfaces.
  std::vector<int> objects;
  std::string material;
  // The first one that the text names.
  RecordedColour colour;
  // At most a dozen words; may be empty.
  std::string description;
};

struct RecordedStyle {
  // The first sentence of prose that is about the room; may be empty.
  std::string summary;
  std::vector<RecordedLook> looks;
};

// One look for every heading of a thing, whose properties ("Colour:", "Material:", "Style:") stand behind or under it.
// Things without a known colour are kept in the remarks. Reads any bytes.
RecordedStyle ReadStyleText(std::string_view text, const ObjectNames& objects, const Handbook& handbook,
                            Conversion& conversion);

// The colour that a text names first, the longest name of several: one of the handbook, else that of a wood, a metal or
// another material whose colour goes without saying ("walnut", "brass").
RecordedColour FindColour(std::string_view text, const Handbook& handbook);

}  // namespace flair::language
