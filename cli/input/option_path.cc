// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/option_path.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/duration.pb.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"
#include "fmt/format.h"

namespace flair::cli {

namespace {

using google::protobuf::EnumDescriptor;
using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

bool IsDuration(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE &&
         field.message_type() == google::protobuf::Duration::descriptor();
}

std::string Word(std::string text) {
  for (char& c : text) c = c == '-' ? '_' : absl::ascii_tolower(static_cast<unsigned char>(c));
  return text;
}

// "plan" of PREVIEW_VIEW_PLAN: what follows the prefix that all values share with ..._UNSPECIFIED.
std::string ShortWord(const EnumValueDescriptor& value) {
  constexpr std::string_view kZero = "unspecified";
  const std::string zero = Word(value.type()->value(0)->name());
  const std::string name = Word(value.name());
  return zero.ends_with(kZero) ? name.substr(zero.size() - kZero.size()) : name;
}

const EnumValueDescriptor* FindWord(const EnumDescriptor& type, const std::string& text) {
  const std::string word = Word(text);
  for (int i = 1; i < type.value_count(); ++i) {
    if (word == ShortWord(*type.value(i)) || word == Word(type.value(i)->name())) return type.value(i);
  }
  return nullptr;
}

std::string Words(const EnumDescriptor& type) {
  std::string words;
  for (int i = 1; i < type.value_count(); ++i) {
    if (i > 1) words += i + 1 == type.value_count() ? " or " : ", ";
    words += ShortWord(*type.value(i));
  }
  return words;
}

// Sets a field or adds to a list.
template <typename Value>
void Put(const Value& value, const FieldDescriptor& field, Message& message,
         void (google::protobuf::Reflection::*set)(Message*, const FieldDescriptor*, Value) const,
         void (google::protobuf::Reflection::*add)(Message*, const FieldDescriptor*, Value) const) {
  (message.GetReflection()->*(field.is_repeated() ? add : set))(&message, &field, value);
}

bool PutDuration(const std::string& text, const FieldDescriptor& field, Message& message) {
  double seconds = 0;
  if (!absl::SimpleAtod(text, &seconds) || !(seconds >= 0 && seconds < 1e11)) return false;
  google::protobuf::Duration duration;
  duration.set_seconds(static_cast<int64_t>(std::floor(seconds)));
  duration.set_nanos(static_cast<int32_t>(1e9 * (seconds - std::floor(seconds))));
  message.GetReflection()->MutableMessage(&message, &field)->CopyFrom(duration);
  return true;
}

bool PutOne(const std::string& text, const FieldDescriptor& field, Message& message) {
  using google::protobuf::Reflection;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32: {
      int32_t value = 0;
      if (!absl::SimpleAtoi(text, &value)) return false;
      Put(value, field, message, &Reflection::SetInt32, &Reflection::AddInt32);
      return true;
    }
    case FieldDescriptor::CPPTYPE_INT64: {
      int64_t value = 0;
      if (!absl::SimpleAtoi(text, &value)) return false;
      Put(value, field, message, &Reflection::SetInt64, &Reflection::AddInt64);
      return true;
    }
    case FieldDescriptor::CPPTYPE_DOUBLE: {
      double value = 0;
      if (!absl::SimpleAtod(text, &value) || !std::isfinite(value)) return false;
      Put(value, field, message, &Reflection::SetDouble, &Reflection::AddDouble);
      return true;
    }
    case FieldDescriptor::CPPTYPE_BOOL: {
      bool value = false;
      if (!absl::SimpleAtob(text, &value)) return false;
      Put(value, field, message, &Reflection::SetBool, &Reflection::AddBool);
      return true;
    }
    case FieldDescriptor::CPPTYPE_ENUM: {
      const EnumValueDescriptor* value = FindWord(*field.enum_type(), text);
      if (value == nullptr) return false;
      Put(value, field, message, &Reflection::SetEnum, &Reflection::AddEnum);
      return true;
    }
    default:
      return IsDuration(field) && PutDuration(text, field, message);
  }
}

std::string OneInWords(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_INT64:
      return "whole number";
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case FieldDescriptor::CPPTYPE_ENUM:
      return Words(*field.enum_type());
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return "seconds";
    default:
      return "number";
  }
}

}  // namespace

bool IsValue(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_INT64:
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_BOOL:
    case FieldDescriptor::CPPTYPE_ENUM:
      return true;
    default:
      return IsDuration(field) && !field.is_repeated();
  }
}

std::string ValuesInWords(const FieldDescriptor& field) {
  return (field.is_repeated() ? "several, with commas between, of: " : "") + OneInWords(field);
}

bool SetValue(const std::string& text, const FieldDescriptor& field, Message& message) {
  const std::unique_ptr<Message> before(message.New());
  before->CopyFrom(message);
  message.GetReflection()->ClearField(&message, &field);
  if (text.empty()) return true;
  std::vector<std::string> parts = {text};
  if (field.is_repeated()) parts = absl::StrSplit(text, ',');
  for (const std::string& part : parts) {
    if (PutOne(std::string(absl::StripAsciiWhitespace(part)), field, message)) continue;
    message.CopyFrom(*before);
    return false;
  }
  return true;
}

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// Options of one kind: what they are called, where they are in a JobSpec, and the first stage that takes them.
struct OptionGroup {
  std::string_view name;
  const char* field;
  std::string_view stage;
  // The only field that may be set; all when empty.
  std::string_view only;
};

constexpr std::array<OptionGroup, 4> kGroups = {{{"optimizer", "solve_options", "solve", ""},
                                                 {"renderer", "render_options", "render", ""},
                                                 {"models", "model_options", "room", ""},
                                                 {"brief", "brief", "brief", "seed"}}};

// The names that the commands' flags have, too.
struct ShortName {
  std::string_view name;
  std::string_view path;
};
constexpr std::array<ShortName, 14> kShortNames = {{{"optimizer.restarts", "optimizer.max_restart_count"},
                                                    {"optimizer.threads", "optimizer.thread_count"},
                                                    {"optimizer.variants", "optimizer.variant_count"},
                                                    {"optimizer.path_width", "optimizer.path_width_m"},
                                                    {"optimizer.misfits", "optimizer.misfit_policy"},
                                                    {"optimizer.contradictions", "optimizer.find_contradictions"},
                                                    {"renderer.size", "renderer.size_px"},
                                                    {"renderer.scale", "renderer.scale_denominator"},
                                                    {"renderer.samples", "renderer.sample_count"},
                                                    {"models.max_calls", "models.budget.call_count"},
                                                    {"models.max_tokens", "models.budget.token_count"},
                                                    {"models.max_usd", "models.budget.cost_usd"},
                                                    {"models.stand_in", "models.stand_in_allowed"},
                                                    {"models.omit_texts", "models.texts_omitted"}}};

std::string ShortNameOf(const std::string& path) {
  for (const ShortName& known : kShortNames) {
    if (known.path == path) return std::string(known.name);
  }
  return path;
}

std::string PathOf(const std::string& name) {
  for (const ShortName& known : kShortNames) {
    if (known.name == name) return std::string(known.path);
  }
  return name;
}

bool HoldsOptions(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && !field.is_repeated() && !IsValue(field);
}

void AddNames(const std::string& prefix, const Descriptor& type, std::vector<OptionName>& names) {
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    const std::string path = fmt::format("{}.{}", prefix, field.name());
    if (HoldsOptions(field)) {
      AddNames(path, *field.message_type(), names);
    } else if (IsValue(field)) {
      names.push_back({ShortNameOf(path), ValuesInWords(field)});
    }
  }
}

std::vector<OptionName> NamesOf(const OptionGroup& group) {
  const FieldDescriptor& field = *v1::JobSpec::descriptor()->FindFieldByName(group.field);
  std::vector<OptionName> names;
  if (group.only.empty()) {
    AddNames(std::string(group.name), *field.message_type(), names);
  } else {
    const FieldDescriptor* only = field.message_type()->FindFieldByName(std::string(group.only));
    names.push_back({fmt::format("{}.{}", group.name, group.only), ValuesInWords(*only)});
  }
  return names;
}

const OptionGroup* GroupOf(const std::string& path) {
  for (const OptionGroup& group : kGroups) {
    if (path.substr(0, path.find('.')) == group.name) return &group;
  }
  return nullptr;
}

absl::Status NoSuchOption(const std::string& name) {
  const OptionGroup* group = GroupOf(name);
  std::string names;
  for (const OptionName& known : group == nullptr ? OptionNames() : NamesOf(*group)) {
    names += (names.empty() ? "" : ", ") + known.name;
  }
  return absl::InvalidArgumentError(fmt::format("--set {}: there is no such option; one of {}", name, names));
}

// The field at the end of a path below `message`, made on the way; null when there is none.
struct Place {
  Message* message;
  const FieldDescriptor* field;
};
Place Find(std::string_view path, Message& message) {
  const size_t dot = path.find('.');
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(std::string(path.substr(0, dot)));
  if (field == nullptr) return {nullptr, nullptr};
  if (dot == std::string_view::npos) return {IsValue(*field) ? &message : nullptr, field};
  if (!HoldsOptions(*field)) return {nullptr, nullptr};
  return Find(path.substr(dot + 1), *message.GetReflection()->MutableMessage(&message, field));
}

}  // namespace

std::vector<OptionName> OptionNames() {
  std::vector<OptionName> names;
  for (const OptionGroup& group : kGroups) {
    for (OptionName& name : NamesOf(group)) names.push_back(std::move(name));
  }
  return names;
}

absl::StatusOr<std::string_view> SetOption(const std::string& assignment, v1::JobSpec& spec) {
  const size_t equals = assignment.find('=');
  const std::string name(absl::StripAsciiWhitespace(assignment.substr(0, equals)));
  if (equals == std::string::npos) {
    return absl::InvalidArgumentError(
        fmt::format("--set {}: should be NAME=VALUE, such as optimizer.restarts=500", assignment));
  }
  const std::string path = PathOf(name);
  const OptionGroup* group = GroupOf(path);
  const size_t dot = path.find('.');
  if (group == nullptr || dot == std::string::npos) return NoSuchOption(name);
  const std::string_view rest = std::string_view(path).substr(dot + 1);
  if (!group->only.empty() && rest != group->only) return NoSuchOption(name);
  // On a copy: a name that leads nowhere must not leave a message that was made on the way.
  v1::JobSpec changed = spec;
  const FieldDescriptor* field = changed.GetDescriptor()->FindFieldByName(group->field);
  const Place place = Find(rest, *changed.GetReflection()->MutableMessage(&changed, field));
  if (place.message == nullptr) return NoSuchOption(name);
  const std::string value(absl::StripAsciiWhitespace(assignment.substr(equals + 1)));
  if (!SetValue(value, *place.field, *place.message)) {
    return absl::InvalidArgumentError(
        fmt::format("--set {}: {}: should be {}", name, value, ValuesInWords(*place.field)));
  }
  spec = std::move(changed);
  return group->stage;
}

}  // namespace flair::cli
