// SPDX-License-Identifier: GPL-3.0-or-later
// Messages for people, read off their descriptors: names with units, values, lists as tables. A new field needs no
// code; what reads badly gets a row in one of the tables of message_view.cc.
#pragma once

#include <google/protobuf/message.h>

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/room.pb.h"

namespace flair::cli {

// How numbers of a field are shown, by the end of its name: those of height_m as metres with two digits.
struct Unit {
  std::string_view suffix;
  std::string_view sign;  // with the space before it
  double factor;
  int digits;
};
const Unit& UnitOf(std::string_view field);

// "head height" of head_height_m, "zone" of zone_id, "heading" of theta_rad, "restarts" of restart_count.
std::string NameInWords(const google::protobuf::FieldDescriptor& field);

// OBJECT_KIND_FLOOR of ObjectKind: "floor".
std::string EnumInWords(const google::protobuf::EnumValueDescriptor& value);
template <typename Enum>
std::string EnumInWords(Enum value) {
  const auto* known = google::protobuf::GetEnumDescriptor<Enum>()->FindValueByNumber(static_cast<int>(value));
  return known == nullptr ? "unknown" : EnumInWords(*known);
}

// "0.9 m", "door", "a, b", "chalk #f0ede4"; of a message its fields with their names; empty for what is not set.
std::string ValueInWords(const google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field);

// "OOB 0 %, OOR 0 %, reachable floor 98.61 %": of what is set, and of all numbers.
std::string FieldsInWords(const google::protobuf::Message& message);

// The field by which people tell the items of a list apart; null when there is none.
const google::protobuf::FieldDescriptor* NameField(const google::protobuf::Descriptor& type);

// "seed       7", a line for each field that is set but for lists of messages and what holds such lists.
std::string FieldLines(const google::protobuf::Message& message, const std::set<std::string>& but = {});

// A column that no field has; a title that begins with ">" sets it to the right.
struct ExtraColumn {
  std::string title;
  std::function<std::string(int item)> cell;
};

// A heading and a table of the list's items, with a column for each field that some item has; equal pieces of furniture
// share a row. Empty for an empty list. `title` is that of the heading, before the number of items.
std::string ListTable(const google::protobuf::Message& message, const std::string& list, const std::string& title,
                      size_t most_rows, const std::vector<ExtraColumn>& extra = {});

// How far a floor reaches from the room's origin, metres.
struct Extent {
  double width_m = 0;
  double depth_m = 0;
};
Extent ExtentOf(const v1::Polygon& floor);

// "\nOBJECTS, 18\n".
std::string Heading(const std::string& title);

// All of a message: FieldLines, then its lists as tables and its larger parts with their names as headings.
std::string MessageText(const google::protobuf::Message& message, size_t most_rows);

}  // namespace flair::cli
