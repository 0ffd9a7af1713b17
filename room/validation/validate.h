// SPDX-License-Identifier: GPL-3.0-or-later
// The one place that says whether a message is good. Every Validate returns OK or INVALID_ARGUMENT naming path, value
// and what would be right for the first five bad fields, such as
//   room.openings[2].width_m: 7.2 does not fit wall "north" (4 m from 0.5 m); at most 3.5
// `path` names the message where it is part of another. What is accepted is finite, in range, free of dangling
// references, and safe to compute with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"

namespace google::protobuf {
class Message;
}  // namespace google::protobuf

// Declared only: a user includes the messages that it has anyway.
namespace flair::v1 {
class ComposeContactSheetRequest;
class ConstraintList;
class ObjectList;
class Room;
class StyleSheet;
class ZonePlan;
}  // namespace flair::v1

namespace flair {

namespace validation {
// What is wrong with one field.
struct Problem {
  std::string path;  // "layout_graph.edges[3].weight"
  std::string text;  // "0 is outside (0, 100]"
};
}  // namespace validation

// Any message of flair.v1. References between its parts are followed, those to what is no part of it are not.
absl::Status Validate(const google::protobuf::Message& message, std::string_view path);
// The path of a part is its usual name ("room", "options"); those of a request start with its fields.
absl::Status Validate(const google::protobuf::Message& message);

// Parts that refer to others, and the others.
absl::Status Validate(const v1::ObjectList& list, const v1::ZonePlan& plan, std::string_view path = "object_list");
absl::Status Validate(const v1::StyleSheet& sheet, const v1::Room& room, const v1::ObjectList& objects,
                      std::string_view path = "style_sheet");
absl::Status Validate(const v1::ConstraintList& list, const v1::ObjectList& objects,
                      std::string_view path = "constraint_list");
// The message `index` of a stream: the first one holds options, every further one a tile.
absl::Status Validate(const v1::ComposeContactSheetRequest& request, int index);

// Field by field, for those who say more than the path: all problems, paths from the message's own fields on.
std::vector<validation::Problem> FindProblems(const google::protobuf::Message& message);

}  // namespace flair
