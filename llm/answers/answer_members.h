// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace flair::llm {

// What an object has for a field of a message.
struct Member {
  // Borrowed from the object; null when there is nothing.
  const nlohmann::json* value = nullptr;
  // The unit that its name says, when that is not the field's: "cm" for "width_cm".
  std::string_view unit = {};
};

// The member for a field: by the field's name, else by a name that is the same but for case, other characters
// (pictures among them) and the unit, or one of the field's aliases; else one so named in an object among the members,
// such as "size": {"width": 1}.
Member FindMember(const nlohmann::json& object, const google::protobuf::FieldDescriptor& field);

// Whether a value is an object with a member of its own for any field of the type.
bool HasAnyMember(const nlohmann::json& value, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
