// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that people write or change: as JSON or as protobuf text, with the place of every fault.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "room/validation/validate.h"

namespace flair::cli {

enum class TextForm { kJson, kProtobufText };

// Fills `message` from the text. INVALID_ARGUMENT as "NAME:LINE: FIELD: is ...; expected ..." or, where the text is not
// well formed, "NAME:LINE: what is wrong there".
absl::Status ParseMessageText(TextForm form, const std::string& name, const std::string& text,
                              google::protobuf::Message& message);

// Where in the text a message's problems are, first things first, a line each: "NAME:LINE: FIELD: is ..."; at most ten
// and the number of further ones. INVALID_ARGUMENT; OK when there are none.
absl::Status LocateProblems(TextForm form, const std::string& name, const std::string& text,
                            const google::protobuf::Message& message, const std::vector<validation::Problem>& problems);

// The same of what has no lines: "NAME: FIELD: is ...".
absl::Status ListProblems(const std::string& name, const std::vector<validation::Problem>& problems);

// A key that an object of the JSON text has twice, in either spelling, of which one would count or both together; empty
// when there is none.
std::string RepeatedKey(std::string_view json);

// Fills `message` from proto JSON, field names as in the .proto files or in camel case. INVALID_ARGUMENT as
// ParseMessageText, in words of ours where protobuf's name its types.
absl::Status ParseJsonMessage(const std::string& name, const std::string& json, google::protobuf::Message& message);

// Messages that people write as protobuf text.

// Fills `message` from the file. Errors begin with `flag`, such as "--options", and the path: NOT_FOUND and
// FAILED_PRECONDITION as ReadFile, INVALID_ARGUMENT with line, column and `example`, what would be right.
absl::Status ReadTextMessage(const std::string& flag, const std::string& path, const std::string& example,
                             google::protobuf::Message& message);

// The parts of messages in words, for those who name one that is not there.

// "LayoutGraph has no field "edge" (did you mean edges?); it has room, zone_plan, ...".
std::string NoSuchField(const google::protobuf::Descriptor& type, std::string_view name);

// The names in a row, with " and 12 more" after the first `most`.
std::string ListNames(const std::vector<std::string>& names, size_t most = 20);

// " (did you mean desk_1?)" when one of the names is a slip of the pen away; else empty.
std::string DidYouMean(std::string_view name, const std::vector<std::string>& names);

// What a field takes: "a number", "text", "one of KIND_A, KIND_B", "an object {...}".
std::string Expected(const google::protobuf::FieldDescriptor& field);

// A request as one line: line breaks and tabs come from copying text; they mean a space.
inline std::string OneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  return text;
}

// Paths to parts of messages, and where in a JSON text such a part is.

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
