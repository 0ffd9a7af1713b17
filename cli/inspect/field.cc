// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/field.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <memory>
#include <vector>

#include "cli/input/field_path.h"
#include "cli/input/message_words.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

bool IsMessage(const FieldDescriptor& field) { return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE; }

// The field by which people tell the items of a list apart; null when there is none.
const FieldDescriptor* NameField(const Descriptor& type) {
  for (const char* name : {"id", "object_id", "edge_id", "zone_id", "subject_id", "instance_id", "name", "stage",
                           "step", "surface", "term", "code"}) {
    const FieldDescriptor* field = type.FindFieldByName(name);
    if (field != nullptr && field->cpp_type() == FieldDescriptor::CPPTYPE_STRING && !field->is_repeated()) return field;
  }
  return nullptr;
}

absl::Status Wrong(const std::string& path, const std::string& why) {
  return absl::InvalidArgumentError(fmt::format("--field {}: {}", path, why));
}

// One level: a message, and what the path has named in it.
class Walk {
 public:
  explicit Walk(const Message& message) : message_(&message) {}

  absl::Status Take(const PathStep& step, const std::string& here, const std::string& before) {
    return step.in_brackets ? TakeItem(step, here, before) : TakeField(step, here, before);
  }
  const FieldView& view() const { return view_; }

 private:
  absl::Status TakeField(const PathStep& step, const std::string& here, const std::string& before) {
    if (view_.field != nullptr) {
      RETURN_IF_ERROR(Enter(before));
    }
    const Descriptor& type = *message_->GetDescriptor();
    const FieldDescriptor* field = type.FindFieldByName(step.text);
    if (field == nullptr) field = type.FindFieldByCamelcaseName(step.text);
    if (field == nullptr) return Wrong(here, NoSuchField(type, step.text));
    const Reflection& reflection = *message_->GetReflection();
    if (!field->is_repeated() && field->has_presence() && !reflection.HasField(*message_, field)) {
      std::vector<const FieldDescriptor*> set;
      reflection.ListFields(*message_, &set);
      std::vector<std::string> names;
      for (const FieldDescriptor* other : set) names.push_back(other->name());
      return Wrong(here, fmt::format("is not set; set are {}", names.empty() ? "none" : ListNames(names)));
    }
    view_ = {message_, field, -1};
    return absl::OkStatus();
  }

  // Goes from the field or item that was named into its message.
  absl::Status Enter(const std::string& before) {
    const Reflection& reflection = *view_.parent->GetReflection();
    if (!IsMessage(*view_.field)) {
      return Wrong(before, fmt::format("is {}; it has no parts", Expected(*view_.field)));
    }
    if (view_.field->is_repeated() && view_.index < 0) {
      const int size = reflection.FieldSize(*view_.parent, view_.field);
      return Wrong(before, fmt::format("is a list of {}; say which, such as {}[0]{}", size, before,
                                       NameField(*view_.field->message_type()) == nullptr ? "" : ", or by id"));
    }
    message_ = view_.index < 0 ? &reflection.GetMessage(*view_.parent, view_.field)
                               : &reflection.GetRepeatedMessage(*view_.parent, view_.field, view_.index);
    return absl::OkStatus();
  }

  absl::Status TakeItem(const PathStep& step, const std::string& here, const std::string& before) {
    if (view_.field == nullptr || !view_.field->is_repeated() || view_.index >= 0) return Wrong(before, "is no list");
    const int size = view_.parent->GetReflection()->FieldSize(*view_.parent, view_.field);
    const int index = IndexOf(step);
    if (index >= 0 && index < size) {
      view_.index = index;
      return absl::OkStatus();
    }
    if (index >= 0) {
      return Wrong(here, size == 0 ? "the list is empty" : fmt::format("there are {}: [0] to [{}]", size, size - 1));
    }
    return TakeNamed(step.text, size, here);
  }

  absl::Status TakeNamed(const std::string& name, int size, const std::string& here) {
    const FieldDescriptor* id = IsMessage(*view_.field) ? NameField(*view_.field->message_type()) : nullptr;
    if (id == nullptr) return Wrong(here, fmt::format("items have no ids; a number from 0 to {}", size - 1));
    std::vector<std::string> names;
    for (int i = 0; i < size; ++i) {
      const Message& item = view_.parent->GetReflection()->GetRepeatedMessage(*view_.parent, view_.field, i);
      names.push_back(item.GetReflection()->GetString(item, id));
      if (names.back() != name) continue;
      view_.index = i;
      return absl::OkStatus();
    }
    return Wrong(here, fmt::format("no item has the {} \"{}\"{}; there {}", id->name(), name, DidYouMean(name, names),
                                   names.empty() ? "is none" : "are " + ListNames(names)));
  }

  const Message* message_;
  FieldView view_;
};

// A name of the content's own parts, such as "placements", stands for solved_layout.placements.
void CompletePath(const Message& message, std::vector<PathStep>& steps) {
  const Descriptor& type = *message.GetDescriptor();
  const google::protobuf::OneofDescriptor* content = type.FindOneofByName("content");
  if (content == nullptr) return;
  const FieldDescriptor* own = type.FindFieldByName(steps.front().text);
  const FieldDescriptor* set = message.GetReflection()->GetOneofFieldDescriptor(message, content);
  if (own != nullptr && (own == set || own->containing_oneof() != content)) return;
  if (set == nullptr || set->message_type()->FindFieldByName(steps.front().text) == nullptr) return;
  steps.insert(steps.begin(), PathStep{set->name(), false});
}

// One value of the field, `index` -1 for the only one.
std::string ValueText(const FieldView& view, int index) {
  const Reflection& reflection = *view.parent->GetReflection();
  if (IsMessage(*view.field)) {
    return ToText(index < 0 ? reflection.GetMessage(*view.parent, view.field)
                            : reflection.GetRepeatedMessage(*view.parent, view.field, index));
  }
  if (view.field->cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
    std::string scratch;
    return index < 0 ? reflection.GetStringReference(*view.parent, view.field, &scratch)
                     : reflection.GetRepeatedStringReference(*view.parent, view.field, index, &scratch);
  }
  std::string text;
  google::protobuf::TextFormat::PrintFieldValueToString(*view.parent, view.field, index, &text);
  return text;
}

std::string JsonText(const FieldView& view) {
  // The JSON of a message that has nothing but the field.
  const std::unique_ptr<Message> only(view.parent->New());
  only->CopyFrom(*view.parent);
  std::vector<const FieldDescriptor*> set;
  only->GetReflection()->ListFields(*only, &set);
  for (const FieldDescriptor* field : set) {
    if (field != view.field) only->GetReflection()->ClearField(only.get(), field);
  }
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = !IsMessage(*view.field);
  std::string text;
  (void)google::protobuf::util::MessageToJsonString(*only, &text, options);
  const nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, nullptr, false);
  const auto found = json.find(view.field->name());
  if (found == json.end()) return "null\n";
  const bool item = view.index >= 0 && static_cast<size_t>(view.index) < found->size();
  return (item ? (*found)[static_cast<size_t>(view.index)] : *found).dump(1) + "\n";
}

}  // namespace

absl::StatusOr<FieldView> FindField(const Message& message, const std::string& path) {
  absl::StatusOr<std::vector<PathStep>> steps = ParseFieldPath(path);
  if (!steps.ok()) return absl::InvalidArgumentError(fmt::format("--field: {}", std::string(steps.status().message())));
  CompletePath(message, *steps);
  Walk walk(message);
  for (size_t i = 0; i < steps->size(); ++i) {
    RETURN_IF_ERROR(walk.Take((*steps)[i], PathText(*steps, i + 1), PathText(*steps, i)));
  }
  return walk.view();
}

std::string FieldText(const FieldView& view, FieldFormat format) {
  if (format == FieldFormat::kJson) return JsonText(view);
  const bool is_list = view.field->is_repeated() && view.index < 0;
  const bool is_bytes = view.field->type() == FieldDescriptor::TYPE_BYTES;
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
