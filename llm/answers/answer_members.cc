// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_members.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

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

// Whether a bare name is one of these stems, alone or with a unit behind it; nothing when it is none, else the unit
// that it says, empty for the field's own.
std::optional<std::string_view> UnitIfNamed(std::string_view name, const std::vector<std::string>& stems,
                                            std::string_view unit) {
  for (const std::string& stem : stems) {
    if (!name.starts_with(stem)) continue;
    const std::string_view rest = name.substr(stem.size());
    if (rest.empty() || rest == unit) return std::string_view();
    if (const std::string_view other = unit.empty() ? "" : UnitNamed(rest, unit); !other.empty()) return other;
  }
  return std::nullopt;
}

}  // namespace

void Members::ReadNames() {
  if (std::exchange(names_read_, true)) return;
  names_.reserve(value_.size());
  for (const auto& [key, value] : value_.items()) names_.push_back({BareKey(key), &value});
}

Member Members::FindOwn(const FieldDescriptor& field) {
  if (!value_.is_object()) return {};
  if (const auto found = value_.find(field.name()); found != value_.end()) return {&*found};
  ReadNames();
  if (names_.empty()) return {};
  const std::vector<std::string> stems = StemsOf(field);
  for (const Named& member : names_) {
    const std::optional<std::string_view> unit = UnitIfNamed(member.name, stems, FactsOf(field).unit());
    if (unit) return {member.value, *unit};
  }
  return {};
}

Member Members::Find(const FieldDescriptor& field) {
  if (const Member own = FindOwn(field); own.value != nullptr) return own;
  if (!value_.is_object()) return {};
  if (!std::exchange(inner_read_, true)) {
    std::vector<std::vector<std::string>> stems;
    for (int i = 0; i < type_.field_count(); ++i) stems.push_back(StemsOf(*type_.field(i)));
    for (const Named& member : names_) {
      if (!member.value->is_object()) continue;
      bool for_a_field = false;
      for (int i = 0; i < type_.field_count(); ++i) {
        const std::string& unit = FactsOf(*type_.field(i)).unit();
        for_a_field = for_a_field || UnitIfNamed(member.name, stems[static_cast<size_t>(i)], unit).has_value();
      }
      if (!for_a_field) inner_.emplace_back(*member.value, type_);
    }
  }
  for (Members& inner : inner_) {
    if (const Member found = inner.FindOwn(field); found.value != nullptr) return found;
  }
  return {};
}

Member FindMember(const json& object, const FieldDescriptor& field) {
  return Members(object, *field.containing_type()).Find(field);
}

int CountMembers(const json& value, const Descriptor& type) {
  Members members(value, type);
  int count = 0;
  for (int i = 0; i < type.field_count(); ++i) count += members.FindOwn(*type.field(i)).value != nullptr ? 1 : 0;
  return count;
}

bool HasAnyMember(const json& value, const Descriptor& type) {
  Members members(value, type);
  for (int i = 0; i < type.field_count(); ++i) {
    if (members.FindOwn(*type.field(i)).value != nullptr) return true;
  }
  return false;
}

}  // namespace flair::llm
