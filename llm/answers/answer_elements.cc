// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_elements.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "llm/answers/answer_lines.h"
#include "llm/answers/answer_members.h"
#include "llm/answers/field_facts.h"
#include "llm/answers/plain_value.h"

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

// Lines of a text without what marks them as a list.
json LinesOf(const std::string& text) {
  json lines = json::array();
  for (absl::string_view line : absl::StrSplit(text, '\n')) {
    line = absl::StripAsciiWhitespace(line);
    const size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    if (digits > 0 && digits < 3 && (line.substr(digits, 2) == ". " || line.substr(digits, 2) == ") ")) {
      line.remove_prefix(digits + 2);
    }
    for (const absl::string_view mark : {"- ", "* ", "• "}) absl::ConsumePrefix(&line, mark);
    if (!line.empty()) lines.push_back(std::string(line));
  }
  return lines;
}

// Names in one text are several when the text is none; other texts are in lines.
json TextsOf(const json& value, const Choices* choices) {
  if (!value.is_string()) return json::array({value});
  const auto& text = value.get_ref<const std::string&>();
  if (choices == nullptr) return text.find('\n') == std::string::npos ? json::array({value}) : LinesOf(text);
  if (FindChoice(text, *choices)) return json::array({value});
  json names = json::array();
  for (const absl::string_view name : absl::StrSplit(text, absl::ByAnyChar(",;&+\n"))) {
    names.push_back(std::string(absl::StripAsciiWhitespace(name)));
  }
  return names;
}

// Whether a name is a choice of some field of a type.
bool IsChoiceOf(const std::string& name, const Descriptor& type, const FieldChoices& choices) {
  for (int i = 0; i < type.field_count(); ++i) {
    if (!IsText(*type.field(i))) continue;
    const FieldTexts texts(*type.field(i), choices);
    if (texts.get() != nullptr && FindChoice(name, *texts.get())) return true;
  }
  return false;
}

}  // namespace

json ElementsOf(const json& value, const FieldDescriptor& list, const FieldChoices& choices) {
  if (FactsOf(list).line()) return ListOfLines(value, *list.message_type());
  if (value.is_array()) return value;
  if (value.is_string() && !FactsOf(list).notation()) {
    if (const json inner = JsonIn(value.get_ref<const std::string&>()); !inner.is_null()) {
      return ElementsOf(inner, list, choices);
    }
  }
  if (list.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) return ObjectsOf(value, *list.message_type(), choices);
  return TextsOf(value, FieldTexts(list, choices).get());
}

json MembersByChoice(const json& object, const FieldDescriptor& list, const FieldChoices& choices) {
  if (!object.is_object() || list.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) return nullptr;
  json members;
  for (const auto& [name, member] : object.items()) {
    if (!member.is_structured() || !IsChoiceOf(name, *list.message_type(), choices)) continue;
    json alone = json::object();
    alone[name] = nullptr;
    if (!HasAnyMember(alone, *list.containing_type())) members[name] = member;
  }
  return members;
}

json ObjectOfText(const std::string& text, const Descriptor& type) {
  if (json inner = JsonIn(text); inner.is_object()) return inner;
  if (type.field_count() != 2 || !IsText(*type.field(0)) || !IsText(*type.field(1))) return nullptr;
  for (const std::string_view between : {": ", " - ", " – ", " — "}) {
    const size_t at = text.find(between);
    if (at == std::string::npos || at == 0) continue;
    json object = json::object();
    object[type.field(0)->name()] = text.substr(0, at);
    object[type.field(1)->name()] = text.substr(at + between.size());
    return object;
  }
  return nullptr;
}

}  // namespace flair::llm
