// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <vector>

#include "cli/input/message_text.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

namespace pb = google::protobuf;

bool IsMessage(const pb::FieldDescriptor& field) { return field.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE; }

absl::Status Wrong(const std::string& path, const std::string& why) {
  return InvalidArgument("--field {}: {}", path, why);
}

// Puts a field of the message into `view`.
absl::Status TakeField(const pb::Message& message, const PathStep& step, const std::string& here, FieldView& view) {
  const pb::Descriptor& type = *message.GetDescriptor();
  const pb::FieldDescriptor* field = type.FindFieldByName(step.text);
  if (field == nullptr) field = type.FindFieldByCamelcaseName(step.text);
  if (field == nullptr) return Wrong(here, NoSuchField(type, step.text));
  const pb::Reflection& reflection = *message.GetReflection();
  if (!field->is_repeated() && field->has_presence() && !reflection.HasField(message, field)) {
    std::vector<const pb::FieldDescriptor*> set;
    reflection.ListFields(message, &set);
    std::vector<std::string> names;
    for (const pb::FieldDescriptor* other : set) names.push_back(other->name());
    return Wrong(here, fmt::format("is not set; set are {}", names.empty() ? "none" : ListNames(names)));
  }
  view = {&message, field, -1};
  return absl::OkStatus();
}

// The message that the view, called `before`, is.
absl::StatusOr<const pb::Message*> Enter(const FieldView& view, const std::string& before) {
  const pb::Reflection& reflection = *view.parent->GetReflection();
  if (!IsMessage(*view.field)) return Wrong(before, fmt::format("is {}; it has no parts", Expected(*view.field)));
  if (view.field->is_repeated() && view.index < 0) {
    const int size = reflection.FieldSize(*view.parent, view.field);
    return Wrong(before, fmt::format("is a list of {}; say which, such as {}[0]{}", size, before,
                                     NameField(*view.field->message_type()) == nullptr ? "" : ", or by id"));
  }
  return view.index < 0 ? &reflection.GetMessage(*view.parent, view.field)
                        : &reflection.GetRepeatedMessage(*view.parent, view.field, view.index);
}

// The index of the item that the step names, in the list that is the view.
absl::StatusOr<int> FindItem(const FieldView& view, const PathStep& step, const std::string& here) {
  const pb::Reflection& reflection = *view.parent->GetReflection();
  const int size = reflection.FieldSize(*view.parent, view.field);
  const int index = IndexOf(step);
  if (index >= 0 && index < size) return index;
  if (index >= 0) {
    return Wrong(here, size == 0 ? "the list is empty" : fmt::format("there are {}: [0] to [{}]", size, size - 1));
  }
  const pb::FieldDescriptor* id = IsMessage(*view.field) ? NameField(*view.field->message_type()) : nullptr;
  if (id == nullptr) return Wrong(here, fmt::format("items have no ids; a number from 0 to {}", size - 1));
  std::vector<std::string> names;
  for (int i = 0; i < size; ++i) {
    const pb::Message& item = reflection.GetRepeatedMessage(*view.parent, view.field, i);
    names.push_back(item.GetReflection()->GetString(item, id));
    if (names.back() == step.text) return i;
  }
  return Wrong(here, fmt::format("no item has the {} \"{}\"{}; there {}", id->name(), step.text,
                                 DidYouMean(step.text, names), names.empty() ? "is none" : "are " + ListNames(names)));
}

// A name of the content's own parts, such as "placements", stands for solved_layout.placements.
void CompletePath(const pb::Message& message, std::vector<PathStep>& steps) {
  const pb::Descriptor& type = *message.GetDescriptor();
  const pb::OneofDescriptor* content = type.FindOneofByName("content");
  if (content == nullptr) return;
  const pb::FieldDescriptor* own = type.FindFieldByName(steps.front().text);
  const pb::FieldDescriptor* set = message.GetReflection()->GetOneofFieldDescriptor(message, content);
  if (own != nullptr && (own == set || own->containing_oneof() != content)) return;
  if (set == nullptr || set->message_type()->FindFieldByName(steps.front().text) == nullptr) return;
  steps.insert(steps.begin(), PathStep{set->name(), false});
}

// One value of the field, `index` -1 for the only one.
std::string ValueText(const FieldView& view, int index) {
  const pb::Reflection& reflection = *view.parent->GetReflection();
  if (IsMessage(*view.field)) {
    return ToText(index < 0 ? reflection.GetMessage(*view.parent, view.field)
                            : reflection.GetRepeatedMessage(*view.parent, view.field, index));
  }
  if (view.field->cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
    std::string scratch;
    return index < 0 ? reflection.GetStringReference(*view.parent, view.field, &scratch)
                     : reflection.GetRepeatedStringReference(*view.parent, view.field, index, &scratch);
  }
  std::string text;
  pb::TextFormat::PrintFieldValueToString(*view.parent, view.field, index, &text);
  return text;
}

std::string JsonText(const FieldView& view) {
  pb::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = !IsMessage(*view.field);
  std::string text;
  (void)pb::util::MessageToJsonString(*view.parent, &text, options);
  const nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, nullptr, false);
  const auto found = json.find(view.field->name());
  if (found == json.end()) return "null\n";
  const bool item = view.index >= 0 && static_cast<size_t>(view.index) < found->size();
  return (item ? (*found)[static_cast<size_t>(view.index)] : *found).dump(1) + "\n";
}

}  // namespace

absl::StatusOr<FieldView> FindField(const pb::Message& message, const std::string& path) {
  absl::StatusOr<std::vector<PathStep>> steps = ParseFieldPath(path);
  if (!steps.ok()) return InvalidArgument("--field: {}", steps.status().message());
  CompletePath(message, *steps);
  FieldView view;
  for (size_t i = 0; i < steps->size(); ++i) {
    const PathStep& step = (*steps)[i];
    const std::string here = PathText(*steps, i + 1), before = PathText(*steps, i);
    if (!step.in_brackets) {
      const pb::Message* in = &message;
      if (view.field != nullptr) {
        ASSIGN_OR_RETURN(in, Enter(view, before));
      }
      RETURN_IF_ERROR(TakeField(*in, step, here, view));
    } else if (view.field == nullptr || !view.field->is_repeated() || view.index >= 0) {
      return Wrong(before, "is not a list");
    } else {
      ASSIGN_OR_RETURN(view.index, FindItem(view, step, here));
    }
  }
  return view;
}

std::string FieldText(const FieldView& view, FieldFormat format) {
  if (format == FieldFormat::kJson) return JsonText(view);
  const bool is_list = view.field->is_repeated() && view.index < 0;
  const bool is_bytes = view.field->type() == pb::FieldDescriptor::TYPE_BYTES;
  if (!is_list) {
    std::string text = ValueText(view, view.index);
    if (!is_bytes && !text.ends_with('\n')) text += '\n';
    return text;
  }
  std::string text;
  for (int i = 0; i < view.parent->GetReflection()->FieldSize(*view.parent, view.field); ++i) {
    if (i > 0 && IsMessage(*view.field)) text += '\n';
    text += ValueText(view, i);
    if (!text.ends_with('\n')) text += '\n';
  }
  return text;
}

}  // namespace flair::cli
