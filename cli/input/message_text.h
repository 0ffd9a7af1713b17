// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that people write or change: as JSON or as protobuf text, with the place of every fault.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
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

}  // namespace flair::cli
