// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be told of a layout, gathered and put in order by zone and object.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json.hpp"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "room/conversion/conversion.h"
#include "room/scene/scene.h"

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
  // The ids of constraints, which only those who edit by hand want to read.
  bool ids = true;
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

// Calls and places in words.

// The calls of a scene, read by the catalogue of the optimizer that placed it: another optimizer has other types and
// words. Of a call that the catalogue does not have, or whose arguments do not fit, only the type is known. Borrows
// both.
class CallWords {
 public:
  CallWords(const v1::ConstraintCatalog& catalog, const Scene& scene) : catalog_(catalog), scene_(scene) {}

  // What a call asks of its subject: "has its back flush on a wall". Begins with the verb, no full stop; "meets TYPE"
  // of a call that cannot be read.
  std::string Asked(const v1::ConstraintEdge& edge) const;
  // What is meant by a sentence of it that can be taken otherwise: "it lets whoever uses it look at a window"; else
  // empty.
  std::string Clarified(const v1::ConstraintEdge& edge) const;
  // Of a satisfied call for free floor, what stands in it and may, since it is used there: "but for the coffee table".
  // Else empty.
  std::string Excused(const v1::ConstraintEdge& edge, const PartialLayout& where,
                      const optimizer::LinkedPairs& linked) const;
  // By how much it is missed: "the desk is 0.42 m too far from the bed". Empty when there are no words or no measure.
  std::string Missed(const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) const;

  // Indices of objects, in the call's order. Those that it places: its first object, or all of its group.
  std::vector<int> Subjects(const v1::ConstraintEdge& edge) const;
  // Those by which it places them.
  std::vector<int> Anchors(const v1::ConstraintEdge& edge) const;
  // All that it names.
  std::vector<int> Named(const v1::ConstraintEdge& edge) const;

 private:
  struct Call;
  Call Read(const v1::ConstraintEdge& edge) const;
  std::string Filled(const std::string& words, const Call& call, const std::string& missed_by) const;

  const v1::ConstraintCatalog& catalog_;
  const Scene& scene_;
};

// "0.42 m", "12 degrees".
std::string MeasureText(double value, const std::string& unit);

// "a, b and c".
std::string Joined(const std::vector<std::string>& items);

// Where an object is, seen with the eyes of somebody in the room.

// "stands with its back to the north wall, under a window; nightstand 1 at its left". Begins with the verb, no full
// stop. For an object that is placed; neighbours that are not placed do not count. Walls, things and distances are
// read off the layout, whatever was asked.
std::string Standing(const Scene& scene, const PartialLayout& where, int object);

// "north", "south-east": the compass direction nearest to a direction in the room.
std::string Compass(const Vec2<double>& direction);

}  // namespace flair::cli
