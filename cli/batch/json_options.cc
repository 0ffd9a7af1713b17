// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/json_options.h"

#include <google/protobuf/descriptor.h>

#include <memory>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "cli/input/json_message.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using nlohmann::json;

const FieldDescriptor* FieldNamed(const Descriptor& type, const std::string& name) {
  const FieldDescriptor* field = type.FindFieldByName(name);
  return field != nullptr ? field : type.FindFieldByCamelcaseName(name);
}

// "leave-out" to MISFIT_POLICY_LEAVE_OUT; what is no word of the enum stays.
void SpellOutWord(const EnumDescriptor& type, json& value) {
  if (!value.is_string()) return;
  const std::string word = absl::StrReplaceAll(absl::AsciiStrToUpper(value.get<std::string>()), {{"-", "_"}});
  for (int i = 0; i < type.value_count(); ++i) {
    const std::string& name = type.value(i)->name();
    if (name.size() > word.size() && name.ends_with(word) && name[name.size() - word.size() - 1] == '_') {
      value = name;
      return;
    }
  }
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text, whose depth was checked.
void SpellOutWords(const Descriptor& type, json& object) {
  if (!object.is_object()) return;
  for (auto& [name, value] : object.items()) {
    const FieldDescriptor* field = FieldNamed(type, name);
    if (field == nullptr) continue;
    const auto spell_out = [field](json& one) {
      if (field->enum_type() != nullptr) SpellOutWord(*field->enum_type(), one);
      if (field->message_type() != nullptr) SpellOutWords(*field->message_type(), one);
    };
    if (field->is_repeated() && value.is_array()) {
      for (json& one : value) spell_out(one);
    } else {
      spell_out(value);
    }
  }
}

// Whether the field is a message whose own fields are named one by one.
bool HasParts(const FieldDescriptor& field, const json& value) {
  return field.message_type() != nullptr && !field.is_repeated() && value.is_object();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text, whose depth was checked.
void Clear(const json& object, Message& message) {
  for (const auto& [name, value] : object.items()) {
    const FieldDescriptor* field = FieldNamed(*message.GetDescriptor(), name);
    if (field == nullptr) continue;
    if (HasParts(*field, value)) {
      if (message.GetReflection()->HasField(message, field)) {
        Clear(value, *message.GetReflection()->MutableMessage(&message, field));
      }
    } else {
      message.GetReflection()->ClearField(&message, field);
    }
  }
}

}  // namespace

bool NestsWithin(std::string_view json, int most) {
  int depth = 0;
  bool in_string = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > most) return false;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return true;
}

absl::Status SetFromJson(const json& object, std::string_view path, Message& message) {
  if (!object.is_object()) {
    return absl::InvalidArgumentError(fmt::format(
        "{}: is {}; expected an object of {}", path,
        object.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 80), message.GetDescriptor()->name()));
  }
  json spelt = object;
  SpellOutWords(*message.GetDescriptor(), spelt);
  const std::unique_ptr<Message> said(message.New());
  // The parser says NAME:LINE: FIELD: what; everything here is on one line.
  const absl::Status status = ParseJsonMessage("", spelt.dump(-1, ' ', false, json::error_handler_t::replace), *said);
  if (!status.ok()) {
    std::string words = absl::StrReplaceAll(status.message(), {{"; or a newer Flair wrote it", ""}});
    if (words.starts_with(":1: ")) words = words.substr(4);
    return absl::InvalidArgumentError(path.empty() ? words : fmt::format("{}.{}", path, words));
  }
  Clear(object, message);
  message.MergeFrom(*said);
  return absl::OkStatus();
}

}  // namespace flair::cli
