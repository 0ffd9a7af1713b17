// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/field_facts.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace flair::llm {
namespace {

using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;

constexpr int kMostShownChoices = 24;

// "OPENING_KIND_DOOR" of OpeningKind is "door".
std::string ShortName(const EnumDescriptor& type, const std::string& name) {
  std::string prefix;
  for (const char c : type.name()) {
    if (c >= 'A' && c <= 'Z' && !prefix.empty()) prefix += '_';
    prefix += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  prefix += '_';
  std::string shown = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
  for (char& c : shown) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return shown;
}

std::string UnitWord(std::string_view unit) {
  if (unit == "m") return "metres";
  if (unit == "deg") return "degrees";
  return std::string(unit);
}

}  // namespace

const model::v1::FieldFacts& FactsOf(const FieldDescriptor& field) {
  return field.options().GetExtension(model::v1::facts);
}

FieldTexts::FieldTexts(const FieldDescriptor& field, const FieldChoices& choices) {
  if (const auto found = choices.find(field.full_name()); found != choices.end()) {
    chosen_ = &found->second;
    return;
  }
  for (const std::string& name : FactsOf(field).choices()) own_.names.push_back(name);
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM) {
    const EnumDescriptor& type = *field.enum_type();
    for (int i = 0; i < type.value_count(); ++i) {
      if (type.value(i)->number() != 0) own_.names.push_back(ShortName(type, type.value(i)->name()));
    }
  }
  any_ = own_.names.empty();
}

int EnumNumber(const EnumDescriptor& type, std::string_view name) {
  for (int i = 0; i < type.value_count(); ++i) {
    if (type.value(i)->number() != 0 && ShortName(type, type.value(i)->name()) == name) return type.value(i)->number();
  }
  return 0;
}

bool IsWhole(const FieldDescriptor& field) {
  return field.cpp_type() != FieldDescriptor::CPPTYPE_DOUBLE && field.cpp_type() != FieldDescriptor::CPPTYPE_FLOAT;
}

NumberRange RangeOf(const FieldDescriptor& field) {
  NumberRange range;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      range = {std::numeric_limits<int32_t>::min(), std::numeric_limits<int32_t>::max()};
      break;
    case FieldDescriptor::CPPTYPE_INT64:
      range = {-9007199254740992.0, 9007199254740992.0};
      break;
    case FieldDescriptor::CPPTYPE_UINT32:
      range = {0, std::numeric_limits<uint32_t>::max()};
      break;
    case FieldDescriptor::CPPTYPE_UINT64:
      range = {0, 9007199254740992.0};
      break;
    case FieldDescriptor::CPPTYPE_FLOAT:
      range = {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()};
      break;
    default:
      range = {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
  }
  const model::v1::FieldFacts& facts = FactsOf(field);
  if (facts.has_minimum()) range.least = facts.minimum();
  if (facts.has_maximum()) range.most = facts.maximum();
  return range;
}

void SetNumberField(double value, const FieldDescriptor& field, google::protobuf::Message& message) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  const auto put = [&](auto set, auto add, auto number) {
    if (field.is_repeated()) {
      (reflection.*add)(&message, &field, number);
    } else {
      (reflection.*set)(&message, &field, number);
    }
  };
  using R = google::protobuf::Reflection;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return put(&R::SetInt32, &R::AddInt32, static_cast<int32_t>(value));
    case FieldDescriptor::CPPTYPE_INT64:
      return put(&R::SetInt64, &R::AddInt64, static_cast<int64_t>(value));
    case FieldDescriptor::CPPTYPE_UINT32:
      return put(&R::SetUInt32, &R::AddUInt32, static_cast<uint32_t>(value));
    case FieldDescriptor::CPPTYPE_UINT64:
      return put(&R::SetUInt64, &R::AddUInt64, static_cast<uint64_t>(value));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return put(&R::SetFloat, &R::AddFloat, static_cast<float>(value));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return put(&R::SetDouble, &R::AddDouble, value);
    default:
      return;
  }
}

std::string RightFor(const FieldDescriptor& field, const FieldChoices& choices) {
  const model::v1::FieldFacts& facts = FactsOf(field);
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return "an object";
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case FieldDescriptor::CPPTYPE_STRING:
    case FieldDescriptor::CPPTYPE_ENUM: {
      const FieldTexts texts(field, choices);
      if (texts.get() == nullptr) return "a text";
      std::string names;
      const int count = static_cast<int>(texts.get()->names.size());
      for (int i = 0; i < std::min(count, kMostShownChoices); ++i) {
        names += fmt::format("{}\"{}\"", i > 0 ? ", " : "", texts.get()->names[static_cast<size_t>(i)]);
      }
      if (count > kMostShownChoices) names += fmt::format(" and {} more", count - kMostShownChoices);
      return "one of " + names;
    }
    default: {
      std::string right = IsWhole(field) ? "a whole number" : "a number";
      if (!facts.unit().empty()) right += " in " + UnitWord(facts.unit());
      const NumberRange range = RangeOf(field);
      if (facts.has_minimum() && facts.has_maximum())
        return fmt::format("{}, {:g} to {:g}", right, range.least, range.most);
      if (facts.has_minimum()) return fmt::format("{}, {:g} or more", right, range.least);
      if (facts.has_maximum()) return fmt::format("{}, {:g} or less", right, range.most);
      return right;
    }
  }
}

}  // namespace flair::llm
