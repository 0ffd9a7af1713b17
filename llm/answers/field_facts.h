// SPDX-License-Identifier: GPL-3.0-or-later
// What is declared of the fields of an answer, in the forms that schema and reader need.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <string>
#include <string_view>

#include "flair/model/v1/annotations.pb.h"
#include "llm/answers/choices.h"

namespace flair::llm {

// What is declared of a field; of an undeclared one nothing.
const model::v1::FieldFacts& FactsOf(const google::protobuf::FieldDescriptor& field);

// The texts that a field may take: those chosen at run time, else those declared, else the names of its enum in lower
// case without their prefix.
class FieldTexts {
 public:
  // `choices` must outlive it.
  FieldTexts(const google::protobuf::FieldDescriptor& field, const FieldChoices& choices);

  // Null when any text may be.
  const Choices* get() const { return any_ ? nullptr : (chosen_ != nullptr ? chosen_ : &own_); }

 private:
  Choices own_;
  const Choices* chosen_ = nullptr;
  bool any_ = false;
};

// The number of an enum's value by the name that FieldTexts gives it; 0 when it has none of that name.
int EnumNumber(const google::protobuf::EnumDescriptor& type, std::string_view name);

bool IsWhole(const google::protobuf::FieldDescriptor& field);

// The accepted numbers of a numeric field; those of its type where nothing is declared.
struct NumberRange {
  double least = 0;
  double most = 0;
};
NumberRange RangeOf(const google::protobuf::FieldDescriptor& field);

// Sets a numeric field, or adds to it when it is a list. `value` is in RangeOf the field, or 0.
void SetNumberField(double value, const google::protobuf::FieldDescriptor& field, google::protobuf::Message& message);

// What would be right in a field, for faults: "a number in metres, 0.05 to 20", "one of "door", "window"".
std::string RightFor(const google::protobuf::FieldDescriptor& field, const FieldChoices& choices);

}  // namespace flair::llm
