// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_root.h"

#include <nlohmann/json.hpp>
#include <string>

#include "llm/answers/choices.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;
using nlohmann::json;

// Whether a value is an object with any of the type's fields.
bool HasAnyField(const json& value, const google::protobuf::Descriptor& type) {
  if (!value.is_object()) return false;
  for (int i = 0; i < type.field_count(); ++i) {
    const std::string bare = Bare(type.field(i)->name());
    for (const auto& [key, member] : value.items()) {
      if (Bare(key) == bare) return true;
    }
  }
  return false;
}

// The only list of a type; null when it has none or several.
const FieldDescriptor* OnlyList(const google::protobuf::Descriptor& type) {
  const FieldDescriptor* list = nullptr;
  for (int i = 0; i < type.field_count(); ++i) {
    if (!type.field(i)->is_repeated()) continue;
    if (list != nullptr) return nullptr;
    list = type.field(i);
  }
  return list;
}

}  // namespace

json AnswerRoot(const json& value, const google::protobuf::Descriptor& type) {
  if (value.is_array()) {
    const FieldDescriptor* list = OnlyList(type);
    return list != nullptr ? json::object({{list->name(), value}}) : value;
  }
  if (!value.is_object() || HasAnyField(value, type)) return value;
  const json* inner = nullptr;
  for (const auto& [key, member] : value.items()) {
    if (!HasAnyField(member, type)) continue;
    if (inner != nullptr) return value;
    inner = &member;
  }
  return inner != nullptr ? *inner : value;
}

}  // namespace flair::llm
