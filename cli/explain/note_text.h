// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "cli/explain/layout_note.h"

namespace flair::cli {

struct NoteStyle {
  // Every demand, also those that say nothing new; else those with a reason and those that are not met.
  bool all = false;
  size_t width = 100;
};

// The note as an architect would write it, by zone, ending in a newline.
std::string NoteText(const LayoutNote& note, const NoteStyle& style);

// One object of it. `key` is an id, or a name such as "dining chair 2"; NOT_FOUND lists the ids.
absl::StatusOr<const ObjectNote*> FindObject(const LayoutNote& note, const std::string& key);
std::string ObjectText(const ObjectNote& object, const NoteStyle& style);

}  // namespace flair::cli
