// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/field_value.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/duration.pb.h>

#include <cmath>
#include <memory>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"

namespace flair::cli {
namespace {

using google::protobuf::EnumDescriptor;
using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

bool IsDuration(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE &&
         field.message_type() == google::protobuf::Duration::descriptor();
}

std::string Word(std::string text) {
  for (char& c : text) c = c == '-' ? '_' : absl::ascii_tolower(static_cast<unsigned char>(c));
  return text;
}

// "plan" of PREVIEW_VIEW_PLAN: what follows the prefix that all values share with ..._UNSPECIFIED.
std::string ShortWord(const EnumValueDescriptor& value) {
  constexpr std::string_view kZero = "unspecified";
  const std::string zero = Word(value.type()->value(0)->name());
  const std::string name = Word(value.name());
  return zero.ends_with(kZero) ? name.substr(zero.size() - kZero.size()) : name;
}

const EnumValueDescriptor* FindWord(const EnumDescriptor& type, const std::string& text) {
  const std::string word = Word(text);
  for (int i = 1; i < type.value_count(); ++i) {
    if (word == ShortWord(*type.value(i)) || word == Word(type.value(i)->name())) return type.value(i);
  }
  return nullptr;
}

std::string Words(const EnumDescriptor& type) {
  std::string words;
  for (int i = 1; i < type.value_count(); ++i) {
    if (i > 1) words += i + 1 == type.value_count() ? " or " : ", ";
    words += ShortWord(*type.value(i));
  }
  return words;
}

// Sets a field or adds to a list.
template <typename Value>
void Put(const Value& value, const FieldDescriptor& field, Message& message,
         void (google::protobuf::Reflection::*set)(Message*, const FieldDescriptor*, Value) const,
         void (google::protobuf::Reflection::*add)(Message*, const FieldDescriptor*, Value) const) {
  (message.GetReflection()->*(field.is_repeated() ? add : set))(&message, &field, value);
}

bool PutDuration(const std::string& text, const FieldDescriptor& field, Message& message) {
  double seconds = 0;
  if (!absl::SimpleAtod(text, &seconds) || !(seconds >= 0 && seconds < 1e11)) return false;
  google::protobuf::Duration duration;
  duration.set_seconds(static_cast<int64_t>(std::floor(seconds)));
  duration.set_nanos(static_cast<int32_t>(1e9 * (seconds - std::floor(seconds))));
  message.GetReflection()->MutableMessage(&message, &field)->CopyFrom(duration);
  return true;
}

bool PutOne(const std::string& text, const FieldDescriptor& field, Message& message) {
  using google::protobuf::Reflection;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32: {
      int32_t value = 0;
      if (!absl::SimpleAtoi(text, &value)) return false;
      Put(value, field, message, &Reflection::SetInt32, &Reflection::AddInt32);
      return true;
    }
    case FieldDescriptor::CPPTYPE_INT64: {
      int64_t value = 0;
      if (!absl::SimpleAtoi(text, &value)) return false;
      Put(value, field, message, &Reflection::SetInt64, &Reflection::AddInt64);
      return true;
    }
    case FieldDescriptor::CPPTYPE_DOUBLE: {
      double value = 0;
      if (!absl::SimpleAtod(text, &value) || !std::isfinite(value)) return false;
      Put(value, field, message, &Reflection::SetDouble, &Reflection::AddDouble);
      return true;
    }
    case FieldDescriptor::CPPTYPE_BOOL: {
      bool value = false;
      if (!absl::SimpleAtob(text, &value)) return false;
      Put(value, field, message, &Reflection::SetBool, &Reflection::AddBool);
      return true;
    }
    case FieldDescriptor::CPPTYPE_ENUM: {
      const EnumValueDescriptor* value = FindWord(*field.enum_type(), text);
      if (value == nullptr) return false;
      Put(value, field, message, &Reflection::SetEnum, &Reflection::AddEnum);
      return true;
    }
    default:
      return IsDuration(field) && PutDuration(text, field, message);
  }
}

std::string OneInWords(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_INT64:
      return "whole number";
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case FieldDescriptor::CPPTYPE_ENUM:
      return Words(*field.enum_type());
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return "seconds";
    default:
      return "number";
  }
}

}  // namespace

bool IsValue(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_INT64:
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_BOOL:
    case FieldDescriptor::CPPTYPE_ENUM:
      return true;
    default:
      return IsDuration(field) && !field.is_repeated();
  }
}

std::string ValuesInWords(const FieldDescriptor& field) {
  return (field.is_repeated() ? "several, with commas between, of: " : "") + OneInWords(field);
}

bool SetValue(const std::string& text, const FieldDescriptor& field, Message& message) {
  const std::unique_ptr<Message> before(message.New());
  before->CopyFrom(message);
  message.GetReflection()->ClearField(&message, &field);
  if (text.empty()) return true;
  std::vector<std::string> parts = {text};
  if (field.is_repeated()) parts = absl::StrSplit(text, ',');
  for (const std::string& part : parts) {
    if (PutOne(std::string(absl::StripAsciiWhitespace(part)), field, message)) continue;
    message.CopyFrom(*before);
    return false;
  }
  return true;
}

}  // namespace flair::cli
