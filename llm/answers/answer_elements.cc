// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_elements.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "llm/answers/answer_lines.h"
#include "llm/answers/answer_members.h"
#include "llm/answers/field_facts.h"

namespace flair::llm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;

bool IsText(const FieldDescriptor& field) {
  return !field.is_repeated() && field.cpp_type() == FieldDescriptor::CPPTYPE_STRING;
}

// Whether elements of the type are a text with texts about it.
bool IsTextWithTexts(const Descriptor& type) {
  return type.field_count() > 1 && IsText(*type.field(0)) && type.field(1)->is_repeated() &&
         type.field(1)->cpp_type() == FieldDescriptor::CPPTYPE_STRING;
}

// The field that a name of an element is for; null for none.
const FieldDescriptor* FieldOfName(const std::string& name, const json& element, const Descriptor& type,
                                   const FieldChoices& choices) {
  const FieldDescriptor* first = nullptr;
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (!IsText(field) || FindMember(element, field).value != nullptr) continue;
    const FieldTexts texts(field, choices);
    if (texts.get() != nullptr && FindChoice(name, *texts.get())) return &field;
    if (i == 0) first = &field;
  }
  return first;
}

json Named(const std::string& name, json element, const Descriptor& type, const FieldChoices& choices) {
  if (!element.is_object()) return element;
  const FieldDescriptor* const field = FieldOfName(name, element, type, choices);
  if (field != nullptr) element[field->name()] = name;
  return element;
}

json ObjectsOf(const json& value, const Descriptor& type, const FieldChoices& choices) {
  if (!value.is_object() || HasAnyMember(value, type)) return json::array({value});
  json elements = json::array();
  for (const auto& [name, member] : value.items()) {
    const bool texts = member.is_string() || (member.is_array() && !member.empty() && member.front().is_string());
    if (texts && IsTextWithTexts(type)) {
      elements.push_back({{type.field(0)->name(), name}, {type.field(1)->name(), member}});
    } else if (member.is_array()) {
      for (const json& item : member) elements.push_back(Named(name, item, type, choices));
    } else if (member.is_object()) {
      elements.push_back(Named(name, member, type, choices));
    }
  }
  return elements.empty() ? json::array({value}) : elements;
}

// Names in one text are several when the text is none.
json TextsOf(const json& value, const Choices* choices) {
  if (!value.is_string() || choices == nullptr) return json::array({value});
  const auto& text = value.get_ref<const std::string&>();
  if (FindChoice(text, *choices)) return json::array({value});
  json names = json::array();
  for (const absl::string_view name : absl::StrSplit(text, absl::ByAnyChar(",;&+"))) {
    names.push_back(std::string(absl::StripAsciiWhitespace(name)));
  }
  return names;
}

}  // namespace

json ElementsOf(const json& value, const FieldDescriptor& list, const FieldChoices& choices) {
  if (FactsOf(list).line()) return ListOfLines(value, *list.message_type());
  if (value.is_array()) return value;
  if (list.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) return ObjectsOf(value, *list.message_type(), choices);
  return TextsOf(value, FieldTexts(list, choices).get());
}

}  // namespace flair::llm
