// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of messages that hold values, read from a person's text.
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace flair::cli {

// True for numbers, words, truth values and durations, and for lists of them; false for other messages.
bool IsValue(const google::protobuf::FieldDescriptor& field);

// What such a field takes, in words: "whole number", "true or false", "plan, birdseye or perspective", "numbers with
// commas between".
std::string ValuesInWords(const google::protobuf::FieldDescriptor& field);

// Sets the field from text; clears it when the text is empty. False when the text is no value of the field, which then
// is as it was. Words of enums may be long or short, with - or _: PREVIEW_VIEW_PLAN, plan.
bool SetValue(const std::string& text, const google::protobuf::FieldDescriptor& field,
              google::protobuf::Message& message);

}  // namespace flair::cli
