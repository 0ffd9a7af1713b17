// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/option_path.h"

#include <google/protobuf/descriptor.h>

#include <array>

#include "absl/strings/ascii.h"
#include "cli/input/field_value.h"
#include "fmt/format.h"

namespace flair::cli {
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
