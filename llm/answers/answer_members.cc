// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_members.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "llm/answers/choices.h"
#include "llm/answers/field_facts.h"
#include "llm/answers/quantity.h"

namespace flair::llm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;

// The names of a field, bare and without its unit.
std::vector<std::string> StemsOf(const FieldDescriptor& field) {
  const std::string& unit = FactsOf(field).unit();
  std::string own = field.name();
  if (!unit.empty() && own.ends_with("_" + unit)) own.resize(own.size() - unit.size() - 1);
  std::vector<std::string> stems = {Bare(own)};
  for (const std::string& alias : FactsOf(field).aliases()) stems.push_back(Bare(alias));
  return stems;
}

// A key without the signs and pictures that may stand beside it: "📏 width".
std::string BareKey(const std::string& key) {
  std::string name = Bare(key);
  std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  return name;
}

Member OwnMember(const json& object, const FieldDescriptor& field) {
  if (const auto found = object.find(field.name()); found != object.end()) return {&*found};
  const std::string& unit = FactsOf(field).unit();
  const std::vector<std::string> stems = StemsOf(field);
  for (const auto& [key, value] : object.items()) {
    const std::string name = BareKey(key);
    for (const std::string& stem : stems) {
      if (!name.starts_with(stem)) continue;
      const std::string_view rest = std::string_view(name).substr(stem.size());
      if (rest.empty() || rest == unit) return {&value};
      if (const std::string_view other = unit.empty() ? "" : UnitNamed(rest, unit); !other.empty()) {
        return {&value, other};
      }
    }
  }
  return {};
}

}  // namespace

Member FindMember(const json& object, const FieldDescriptor& field) {
  if (!object.is_object()) return {};
  if (const Member own = OwnMember(object, field); own.value != nullptr) return own;
  const Descriptor& type = *field.containing_type();
  for (const auto& [key, value] : object.items()) {
    if (!value.is_object()) continue;
    const json alone = json::object({{key, nullptr}});
    if (HasAnyMember(alone, type)) continue;
    if (const Member inner = OwnMember(value, field); inner.value != nullptr) return inner;
  }
  return {};
}

bool HasAnyMember(const json& value, const Descriptor& type) {
  if (!value.is_object()) return false;
  for (int i = 0; i < type.field_count(); ++i) {
    if (OwnMember(value, *type.field(i)).value != nullptr) return true;
  }
  return false;
}

}  // namespace flair::llm
