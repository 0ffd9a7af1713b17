// SPDX-License-Identifier: GPL-3.0-or-later
// Paths to parts of messages, and where in a JSON text such a part is.
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::cli {

// One step of the way to a part of a message: a field by name, or an item of a list by number or id.
struct PathStep {
  std::string text;  // "objects", "3", "desk"
  bool in_brackets = false;
};

// "layout_graph.object_list.objects[3].width_m" in steps. INVALID_ARGUMENT when it is no path.
absl::StatusOr<std::vector<PathStep>> ParseFieldPath(std::string_view path);

// The first `count` steps as a path.
std::string PathText(const std::vector<PathStep>& steps, size_t count);

// The number in brackets, from 0 on; -1 when it is no number.
int IndexOf(const PathStep& step);

// Where in a JSON text the field begins, as a byte offset; of the innermost part on the way to it that is there. Field
// names may be those of the .proto files or in camel case. Looks once through what lies before; 0 for what is no JSON.
size_t FindJsonField(std::string_view json, const std::vector<PathStep>& path);

// The line of a byte, from 1 on.
int LineAt(std::string_view text, size_t offset);

// Fields of messages as a person writes them in one word or number: "0.7", "plan", "zones,tertiary", "2.5" seconds.

// Numbers, words, truth values and durations, and lists of them.
bool IsValue(const google::protobuf::FieldDescriptor& field);
// Messages with such fields in them.
bool HoldsOptions(const google::protobuf::FieldDescriptor& field);

// What a field takes, such as "a whole number" or "plan, birdseye or perspective".
std::string ValuesInWords(const google::protobuf::FieldDescriptor& field);

// Sets the field from text; clears it when the text is empty. Parts of a list have commas between; words of enums may
// be long or short, with - or _: PREVIEW_VIEW_PLAN, plan; "all" stands for all words of a list. False when the text is
// no value of the field, which then holds the parts before the wrong one.
bool SetValue(const std::string& text, const google::protobuf::FieldDescriptor& field,
              google::protobuf::Message& message);

// The short words of an enum but the zero, and the value that one of them means: null when there is none.
std::vector<std::string> ShortWords(const google::protobuf::EnumDescriptor& type);
const google::protobuf::EnumValueDescriptor* FindWord(const google::protobuf::EnumDescriptor& type,
                                                      const std::string& text);

}  // namespace flair::cli
