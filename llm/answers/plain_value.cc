// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/plain_value.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "llm/answers/choices.h"
#include "llm/answers/field_facts.h"
#include "llm/answers/quantity.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;
using nlohmann::json;

// Members that are a text themselves, the likelier first.
constexpr const char* kTextMembers[] = {"text", "sentence", "constraint", "id", "name", "description"};

}  // namespace

const json* PlainValueOf(const json& value, const FieldDescriptor& field) {
  if (!value.is_object() || FactsOf(field).notation()) return nullptr;
  if (const auto found = value.find("value"); found != value.end() && !value.contains("unit")) {
    return found->is_structured() ? nullptr : &*found;
  }
  if (field.cpp_type() != FieldDescriptor::CPPTYPE_STRING) return nullptr;
  if (value.size() == 1 && value.front().is_string()) return &value.front();
  for (const char* const name : kTextMembers) {
    if (const auto found = value.find(name); found != value.end() && found->is_string()) return &*found;
  }
  return nullptr;
}

json JsonIn(const std::string& text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || (text[first] != '{' && text[first] != '[')) return nullptr;
  json value = json::parse(text, nullptr, /*allow_exceptions=*/false);
  return value.is_structured() ? value : json();
}

std::optional<LengthUnit> UnitOf(const json& object, const google::protobuf::Descriptor& type) {
  for (const char* const name : {"unit", "units", "length_unit"}) {
    const auto found = object.find(name);
    if (found == object.end() || !found->is_string() || type.FindFieldByName(name) != nullptr) continue;
    const std::string_view unit = UnitNamed(Bare(found->get_ref<const std::string&>()), "m");
    if (unit.empty()) continue;
    return LengthUnit{unit, *ReadQuantity("1 " + std::string(unit), "m")};
  }
  return std::nullopt;
}

}  // namespace flair::llm
