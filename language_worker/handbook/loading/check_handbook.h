// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Where an entry of the merged handbook came from, for messages.
struct EntrySource {
  std::string kind;  // "furniture", "archetype", ...
  std::string name;
  std::string file;
};

// Appends one source per named entry of `part`, in order.
void RecordSources(const std::string& file, const hb::Handbook& part, std::vector<EntrySource>& sources);

// Everything that is wrong with the data, one line each, "file: furniture "desk": ...": names given twice or missing,
// classes, zones, styles and colours that do not exist, sizes out of order, sentences without an object, unknown
// placeholders, colours that are not #RRGGBB. Empty when all is well.
std::vector<std::string> CheckHandbook(const hb::Handbook& handbook, const std::vector<EntrySource>& sources);

}  // namespace flair::language
