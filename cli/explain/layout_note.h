// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be told of a layout, gathered and put in order: by zone and object. Text and JSON are made of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

enum class DemandFate { kHolds, kMissed, kDropped, kNotUnderstood };

// One sentence, or one call that comes from none, with what became of it.
struct Demand {
  // Empty for a call of no sentence.
  std::string sentence_id;
  // The sentence as written; empty for a call of no sentence.
  std::string text;
  // The same as said of its object, without full stop: "Its back is against a wall".
  std::string about_it;
  // The designer's reason; may be empty.
  std::string reason;
  std::vector<std::string> edge_ids;
  // Types of those calls.
  std::vector<std::string> types;
  DemandFate fate = DemandFate::kHolds;
  // Of what does not hold: why, one clause.
  std::string shortfall;
  std::optional<double> missed_by;
  std::string unit;
  // Ids of objects that it names besides its subject.
  std::vector<std::string> other_ids;
};

struct ObjectNote {
  std::string id;
  // "the desk", "dining chair 2".
  std::string name;
  std::string zone_id;
  // "primary", "secondary" or "tertiary".
  std::string role;
  bool requested = false;
  bool pinned = false;
  bool placed = false;
  // Verb first; see Standing(). Empty when not placed.
  std::string standing;
  v1::Placement placement;
  std::vector<Demand> demands;
  // Names of objects that have a place because of where this one is.
  std::vector<std::string> followers;
  // Remarks of the solver about it.
  std::vector<std::string> remarks;
};

struct ZoneNote {
  // Empty for what belongs to the whole room.
  std::string id;
  std::string name;
  std::string purpose;
  std::vector<ObjectNote> objects;
};

struct LayoutNote {
  // "A bedroom of 4 m x 5 m (20 m2), 3 m high, with a door in the south wall ...". One sentence with full stop.
  std::string room;
  // Ids are unique over all zones.
  std::vector<ZoneNote> zones;
  // Demands whose object is not in the list.
  std::vector<Demand> homeless;
  // What was left out and why, a sentence each.
  std::vector<std::string> left_out;
  // Demands that clash, a sentence each.
  std::vector<std::string> clashes;
  // Remarks about the room or the layout as a whole.
  std::vector<std::string> remarks;
};

// INVALID_ARGUMENT names the field when the layout is not valid.
absl::StatusOr<LayoutNote> MakeLayoutNote(const v1::SolvedLayout& layout);

struct DemandCount {
  int held = 0, missed = 0, dropped = 0, not_understood = 0;
  int all() const { return held + missed + dropped + not_understood; }
};
// A demand of several objects counts once.
DemandCount CountDemands(const LayoutNote& note);

// "holds", "missed", "dropped" or "not understood".
const char* FateName(DemandFate fate);

}  // namespace flair::cli
