// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of messages as a person writes them in one word or number: "0.7", "plan", "zones,tertiary", "2.5" seconds.
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <vector>

namespace flair::cli {

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
