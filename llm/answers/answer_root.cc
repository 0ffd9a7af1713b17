// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_root.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "llm/answers/answer_members.h"

namespace flair::llm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;

constexpr int kMostWrappers = 3;
// What wraps an answer has little else.
constexpr size_t kMostMembers = 20;

// Whether a value is objects of that type: one, a list of them, or members of an object by some name.
bool HoldsElements(const json& value, const Descriptor& type, int depth = 0) {
  if (HasAnyMember(value, type)) return true;
  constexpr int kMostDepth = 2;
  return value.is_structured() && !value.empty() && depth < kMostDepth &&
         std::ranges::all_of(value, [&](const json& item) { return HoldsElements(item, type, depth + 1); });
}

// The first list of a type whose elements these are; for any list, the only list of the type. Null for none.
const FieldDescriptor* ListFor(const json& value, const Descriptor& type) {
  const FieldDescriptor* only = nullptr;
  int count = 0;
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (!field.is_repeated()) continue;
    only = ++count == 1 ? &field : nullptr;
    const bool of_objects = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (of_objects && HoldsElements(value, *field.message_type())) return &field;
  }
  return value.is_array() ? only : nullptr;
}

// The value that a member is or, as a text, holds; null for none. `parsed` keeps what a text holds.
const json* Inner(const json& member, json& parsed) {
  if (member.is_structured()) return &member;
  if (!member.is_string() || member.get_ref<const std::string&>().find('{') == std::string::npos) return nullptr;
  parsed = json::parse(member.get_ref<const std::string&>(), nullptr, /*allow_exceptions=*/false);
  return parsed.is_structured() ? &parsed : nullptr;
}

// Whether an object is certainly of a type: by two of its fields, or its only one.
bool IsClearly(const json& value, const Descriptor& type) {
  return CountMembers(value, type) >= std::min(2, type.field_count());
}

// The object with fields of the type that a value is or wraps; none when there is none, or several. Of a call,
// {"name": "answer", "arguments": {...}}, the arguments, though a type may have a name.
std::optional<json> Wrapped(const json& value, const Descriptor& type, int wrappers = 0) {
  if (IsClearly(value, type)) return value;
  const bool has_one = HasAnyMember(value, type);
  const bool wrapper = (value.is_object() && value.size() <= kMostMembers) || (value.is_array() && value.size() == 1);
  if (!wrapper || wrappers == kMostWrappers) return has_one ? std::optional(value) : std::nullopt;
  std::optional<json> wrapped;
  for (const json& member : value) {
    if (member.is_array() && member.size() != 1) continue;
    json parsed;
    const json* const inner = Inner(member, parsed);
    std::optional<json> found = inner != nullptr ? Wrapped(*inner, type, wrappers + 1) : std::nullopt;
    if (found && has_one && !IsClearly(*found, type)) continue;
    if (found && wrapped) return has_one ? std::optional(value) : std::nullopt;
    if (found) wrapped = std::move(found);
  }
  return has_one && !wrapped ? std::optional(value) : std::move(wrapped);
}

}  // namespace

json AnswerRoot(json value, const Descriptor& type) {
  if (IsClearly(value, type)) return value;
  if (std::optional<json> wrapped = Wrapped(value, type)) return *std::move(wrapped);
  if (const FieldDescriptor* const list = ListFor(value, type)) {
    json root = json::object();
    root[list->name()] = std::move(value);
    return root;
  }
  // A list beside remarks.
  std::optional<json> root;
  if (!value.is_object()) return value;
  for (const json& member : value) {
    const FieldDescriptor* const list = member.is_array() ? ListFor(member, type) : nullptr;
    if (list == nullptr) continue;
    if (root) return value;
    root = json::object({{list->name(), member}});
  }
  return root ? *std::move(root) : value;
}

}  // namespace flair::llm
