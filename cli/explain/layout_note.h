// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be told of a layout, gathered and put in order by zone and object.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// As `flair explain --json` writes it; docs/explain.md lists the fields. Text is made of the same.
using Note = nlohmann::ordered_json;

// Calls are told as `catalog` words them. INVALID_ARGUMENT names the field when the layout is not valid.
absl::StatusOr<Note> MakeLayoutNote(const v1::SolvedLayout& layout, const v1::ConstraintCatalog& catalog);

// One object of the note. `key` is an id, or a name such as "dining chair 2"; NOT_FOUND lists the ids.
absl::StatusOr<Note> FindObject(const Note& note, const std::string& key);

// The note, or one object of it, indented, ending in a newline.
std::string NoteJson(const Note& note);

struct NoteStyle {
  // Every demand, also those that say nothing new; else those with a reason and those that are not met.
  bool all = false;
  size_t width = 100;
};

// The note as an architect would write it, by zone, ending in a newline.
std::string NoteText(const Note& note, const NoteStyle& style);

// One object of it.
std::string ObjectText(const Note& object, const NoteStyle& style);

// First letter in upper case.
inline std::string Capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

inline std::string WithoutStop(std::string text) {
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace flair::cli
