// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a problem as a model is told them: short, exact, strangers' words quoted.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"
#include "llm/answers/read_answer.h"

namespace flair::language {

// "bedroom", 4 m x 5 m (20 m2), 3 m high, 1 door, 2 windows
std::string ShortRoomText(const v1::Room& room);

// With its walls: "bedroom", 4 m x 5 m (20 m2), 3 m high; south wall 4 m: door_1 0.9 m wide; ...
std::string RoomText(const v1::Room& room);

// One line a zone: - sleeping: "Sleep and rest."
std::string ZonesText(const v1::ZonePlan& plan);

// Objects that are equal but for their number, in the order of the list: those of one name, zone, role, kind and size.
struct ObjectGroup {
  // What it is called in questions: the id of a single one, else "dining_chair" for dining_chair_1 and its like;
  // unique.
  std::string name;
  std::vector<const v1::Object*> objects;
};
std::vector<ObjectGroup> GroupObjects(const v1::ObjectList& list, bool floor_only);

// One line a group: - dining_chair_1 to dining_chair_4, together dining_chair (dining): 0.45 x 0.5 x 0.9 m
std::string GroupsText(const std::vector<ObjectGroup>& groups);

// The names that an answer may use for the groups: each group's, and those of its members. Names as people would say
// them
// ("dining chair 2") are understood too.
llm::Choices GroupChoices(const std::vector<ObjectGroup>& groups);

// The ids of what an answer named: of a group's members, or of a single object.
std::vector<std::string> IdsOf(const std::string& name, const std::vector<ObjectGroup>& groups);

// Turns the ids that a model writes into its sentences, because it was shown them, into words: "double_bed" is "double
// bed", "nightstand_2" the "second nightstand", "window_1" a "window". Immutable, thread-safe.
class ObjectWords {
 public:
  ObjectWords(const v1::ObjectList& objects, const v1::Room& room);

  std::string InWords(const std::string& sentence) const;

 private:
  std::map<std::string, std::string, std::less<>> words_;
};

// "first" to "tenth", then "11th"; `number` counts from 0.
std::string Ordinal(size_t number);

// The colour that a model wrote as its name and value, in any order: "sage #7A8B6F", "#7A8B6F sage", "sage rgb(122,
// 139, 111)"; without a value the handbook's of that name. Nothing when it is none. Pure; any text is good input.
std::optional<v1::Colour> ReadColour(std::string_view text, const Handbook& handbook);

}  // namespace flair::language
