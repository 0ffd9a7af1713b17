// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace flair::llm {

// What an object has for a field of a message.
struct Member {
  // Borrowed from the object; null when there is nothing.
  const nlohmann::json* value = nullptr;
  // The unit that its name says, when that is not the field's: "cm" for "width_cm".
  std::string_view unit = {};
};

// The members of one object by the fields that they are for. Faster than FindMember for several fields; not
// thread-safe.
class Members {
 public:
  // For fields of `type`. A value that is no object has no members. Both must outlive it.
  Members(const nlohmann::json& value, const google::protobuf::Descriptor& type) : value_(value), type_(type) {}

  // The member for a field: by the field's name, else by a name that is the same but for case, other characters
  // (pictures among them) and the unit, or one of the field's aliases; else one so named in an object among the
  // members, such as "size": {"width": 1}.
  Member Find(const google::protobuf::FieldDescriptor& field);

  // The same among its own members alone.
  Member FindOwn(const google::protobuf::FieldDescriptor& field);

 private:
  struct Named {
    // As names are compared.
    std::string name;
    const nlohmann::json* value;
  };
  void ReadNames();

  const nlohmann::json& value_;
  const google::protobuf::Descriptor& type_;
  bool names_read_ = false, inner_read_ = false;
  std::vector<Named> names_;
  // Objects among the members that are for no field themselves.
  std::vector<Members> inner_;
};

// Members::Find of a single field.
Member FindMember(const nlohmann::json& object, const google::protobuf::FieldDescriptor& field);

// How many fields of the type a value, if it is an object, has members of its own for.
int CountMembers(const nlohmann::json& value, const google::protobuf::Descriptor& type);

// Whether a value is an object with a member of its own for any field of the type.
bool HasAnyMember(const nlohmann::json& value, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
