// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of messages in words, for those who name one that is not there.
#pragma once

#include <google/protobuf/descriptor.h>

#include <string>
#include <string_view>
#include <vector>

namespace flair::cli {

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
