// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>

#include <initializer_list>
#include <memory>
#include <optional>

#include "absl/algorithm/container.h"
#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_replace.h"
#include "cli/batch/batch_input.h"
#include "cli/input/artifact_file.h"
#include "cli/input/message_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/nests_within.h"

namespace flair::cli {
namespace {

using nlohmann::json;

constexpr int kDeepest = 64;
constexpr size_t kLongestKey = 200;

// Takes the member out that has one of the names.
std::optional<json> Take(json& object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto found = object.find(name);
    if (found == object.end()) continue;
    json value = std::move(*found);
    object.erase(found);
    return value;
  }
  return std::nullopt;
}

absl::Status Wrong(std::string_view field, const json& value, std::string_view right) {
  std::string shown = JsonText(value);
  if (shown.size() > 80) shown = shown.substr(0, 77) + "...";
  return InvalidArgument("{}: is {}; {}", field, shown, right);
}

absl::Status ReadKey(const std::optional<json>& value, std::string& key) {
  if (!value.has_value()) return absl::OkStatus();
  if (value->is_number_integer()) {
    key = value->dump();
    return absl::OkStatus();
  }
  if (value->is_string()) key = value->get<std::string>();
  const bool printable =
      absl::c_none_of(key, [](char c) { return absl::ascii_iscntrl(static_cast<unsigned char>(c)); });
  if (!key.empty() && key.size() <= kLongestKey && printable) return absl::OkStatus();
  return Wrong("id", *value,
               fmt::format("expected your name for this line: 1 to {} bytes of text, or a whole number", kLongestKey));
}

absl::Status ReadVariants(const std::optional<json>& value, v1::JobSpec& spec) {
  if (!value.has_value()) return absl::OkStatus();
  if (!value->is_number_integer() || *value < 1 || *value > 32) {
    return Wrong("variants", *value, "expected a whole number, 1 to 32");
  }
  spec.mutable_solve_options()->set_variant_count(value->get<int>());
  return absl::OkStatus();
}

// "views": names, or objects of RenderOptions, each over what `render` says.
absl::Status ReadViews(const std::optional<json>& value, v1::JobSpec& spec) {
  if (!value.has_value()) return absl::OkStatus();
  if (!value->is_array() || value->empty() || value->size() > 5) {
    return Wrong("views", *value,
                 "expected 1 to 5 of \"plan\", \"birdseye\", \"perspective\" or {\"view\": ...} in []");
  }
  std::vector<v1::RenderOptions> views;
  for (size_t i = 0; i < value->size(); ++i) {
    const json& view = (*value)[i];
    v1::RenderOptions options = spec.render_options();
    const json object = view.is_string() ? json{{"view", view}} : view;
    RETURN_IF_ERROR(SetFromJson(object, fmt::format("views[{}]", i), options));
    views.push_back(std::move(options));
  }
  SetViews(views, spec);
  return absl::OkStatus();
}

absl::Status ReadBrief(json& object, v1::JobSpec& spec) {
  const std::optional<json> brief = Take(object, {"brief"});
  if (brief.has_value() && !object.empty()) {
    return InvalidArgument(
        "{}: not beside \"brief\", which has the brief's own fields; a line may have brief, id, variants, "
        "views, solve, render, models, replay",
        object.begin().key());
  }
  absl::Status status = SetFromJson(brief.value_or(object), brief.has_value() ? "brief" : "", *spec.mutable_brief());
  if (status.ok() || brief.has_value() || !absl::StrContains(status.message(), "has no field")) return status;
  return InvalidArgument("{}; and a line may have id, variants, views, solve, render, models", status.message());
}

absl::Status ReadObject(json object, BriefLine& line) {
  v1::JobSpec& spec = line.spec;
  RETURN_IF_ERROR(ReadKey(Take(object, {"id"}), line.key));
  const auto part = [&](std::initializer_list<const char*> names, auto mutable_part) {
    const std::optional<json> value = Take(object, names);
    return value.has_value() ? SetFromJson(*value, *names.begin(), *(spec.*mutable_part)()) : absl::OkStatus();
  };
  RETURN_IF_ERROR(part({"solve", "solve_options", "solveOptions"}, &v1::JobSpec::mutable_solve_options));
  RETURN_IF_ERROR(part({"render", "render_options", "renderOptions"}, &v1::JobSpec::mutable_render_options));
  RETURN_IF_ERROR(part({"models", "model_options", "modelOptions"}, &v1::JobSpec::mutable_model_options));
  RETURN_IF_ERROR(part({"replay"}, &v1::JobSpec::mutable_replay));
  RETURN_IF_ERROR(ReadVariants(Take(object, {"variants"}), spec));
  if (const std::optional<json> further = Take(object, {"further_views", "furtherViews"})) {
    RETURN_IF_ERROR(SetFromJson(json{{"further_views", *further}}, "", spec));
  }
  RETURN_IF_ERROR(ReadViews(Take(object, {"views"}), spec));
  return ReadBrief(object, spec);
}

absl::Status ReadJson(std::string_view text, BriefLine& line) {
  if (!NestsWithin(text, kDeepest)) return InvalidArgument("nests deeper than {} levels", kDeepest);
  json value = json::parse(text, nullptr, false);
  if (value.is_discarded()) {
    v1::Brief nothing;
    const absl::Status status = ParseJsonMessage("", std::string(text), nothing);  // says where and why
    std::string_view words(status.message().data(), status.message().size());
    if (words.starts_with(":1: ")) words.remove_prefix(4);
    return InvalidArgument("is not JSON: {}; a line that begins with {} is read as JSON", words, text.front());
  }
  if (const std::string key = RepeatedKey(text); !key.empty()) {
    return InvalidArgument("\"{}\" stands twice in one object; keep one", key);
  }
  if (value.is_object()) return ReadObject(std::move(value), line);
  line.spec.mutable_brief()->set_text(value.get<std::string>());
  return absl::OkStatus();
}

// What every job must keep to, in the words of a line.
absl::Status Check(const v1::JobSpec& spec) {
  const absl::Status status = Validate(spec, "");
  if (status.ok()) return status;
  return absl::InvalidArgumentError(absl::StrReplaceAll(
      status.message(),
      {{"\n", "; "}, {"solve_options.", "solve."}, {"render_options.", "render."}, {"model_options.", "models."}}));
}

namespace pb = google::protobuf;

const pb::FieldDescriptor* FieldNamed(const pb::Descriptor& type, const std::string& name) {
  const pb::FieldDescriptor* field = type.FindFieldByName(name);
  return field != nullptr ? field : type.FindFieldByCamelcaseName(name);
}

// "leave-out" to MISFIT_POLICY_LEAVE_OUT; what is no word of the enum stays.
void SpellOutWord(const pb::EnumDescriptor& type, json& value) {
  if (!value.is_string()) return;
  if (const auto* const word = FindWord(type, value.get<std::string>())) value = word->name();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text, whose depth was checked.
void SpellOutWords(const pb::Descriptor& type, json& object) {
  if (!object.is_object()) return;
  for (auto& [name, value] : object.items()) {
    const pb::FieldDescriptor* field = FieldNamed(type, name);
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
bool HasParts(const pb::FieldDescriptor& field, const json& value) {
  return field.message_type() != nullptr && !field.is_repeated() && value.is_object();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text, whose depth was checked.
void Clear(const json& object, pb::Message& message) {
  for (const auto& [name, value] : object.items()) {
    const pb::FieldDescriptor* field = FieldNamed(*message.GetDescriptor(), name);
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

void SetViews(const std::vector<v1::RenderOptions>& views, v1::JobSpec& spec) {
  if (views.empty()) return;
  *spec.mutable_render_options() = views.front();
  spec.mutable_further_views()->Assign(views.begin() + 1, views.end());
}

absl::StatusOr<BriefLine> ReadBriefLine(std::string_view line, const v1::JobSpec& defaults) {
  BriefLine read;
  read.spec = defaults;
  const std::string stripped(absl::StripAsciiWhitespace(absl::string_view(line.data(), line.size())));
  const std::string_view text = stripped;
  absl::Status status;
  if (text.starts_with('{') || text.starts_with('"')) {
    status = ReadJson(text, read);
  } else if (text.starts_with('[')) {
    status =
        absl::InvalidArgumentError("is a JSON array; expected one brief per line: text, \"text\" or {\"text\": ...}");
  } else {
    read.spec.mutable_brief()->set_text(stripped);
  }
  if (!status.ok()) return status;
  v1::Brief& brief = *read.spec.mutable_brief();
  brief.set_text(OneLine(brief.text()));
  if (brief.has_room()) CompleteRoom(*brief.mutable_room());
  if (status = Check(read.spec); !status.ok()) return status;
  return read;
}

absl::Status SetFromJson(const json& object, std::string_view path, pb::Message& message) {
  if (!object.is_object()) {
    return InvalidArgument("{}: is {}; expected an object of {}", path, JsonText(object).substr(0, 80),
                           message.GetDescriptor()->name());
  }
  json spelt = object;
  SpellOutWords(*message.GetDescriptor(), spelt);
  const std::unique_ptr<pb::Message> said(message.New());
  // The parser says NAME:LINE: FIELD: what; everything here is on one line.
  const absl::Status status = ParseJsonMessage("", JsonText(spelt), *said);
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
