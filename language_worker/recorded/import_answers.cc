// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/import_answers.h"

#include <fmt/format.h>
#include <google/protobuf/util/json_util.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/ascii.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/recorded/recorded_room.h"
#include "llm/wrappers/llm_wrappers.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// One request after the other, as an orchestrator makes them.
class Phase {
 public:
  Phase(const RecordedRoom& room, const LanguageHandlers& handlers, ImportedAnswers& result)
      : room_(room), handlers_(handlers), result_(result) {}

  absl::Status Run() {
    v1::StyleSheet style;
    RETURN_IF_ERROR(Take<v1::DescribeRoomRequest>(result_.room, &v1::DescribeRoomResponse::room));
    RETURN_IF_ERROR(Take<v1::PlanZonesRequest>(result_.zones, &v1::PlanZonesResponse::zone_plan));
    RETURN_IF_ERROR(Take<v1::ListObjectsRequest>(result_.objects, &v1::ListObjectsResponse::object_list));
    RETURN_IF_ERROR(Take<v1::ChooseStyleRequest>(style, &v1::ChooseStyleResponse::style_sheet));
    v1::ConstraintList& list = result_.constraints;
    RETURN_IF_ERROR(Take<v1::ListConstraintsRequest>(list, &v1::ListConstraintsResponse::constraint_list));
    RETURN_IF_ERROR(Take<v1::CleanConstraintsRequest>(list, &v1::CleanConstraintsResponse::constraint_list));
    return Take<v1::CompleteConstraintsRequest>(result_.completed, &v1::CompleteConstraintsResponse::constraint_list);
  }

 private:
  template <typename Request, typename Part, typename Response>
  absl::Status Take(Part& part, const Part& (Response::*get)() const) {
    Request request;
    request.set_request_id("import");
    if constexpr (requires { request.mutable_brief(); }) *request.mutable_brief() = room_.brief;
    if constexpr (requires { request.mutable_room(); }) *request.mutable_room() = result_.room;
    if constexpr (requires { request.mutable_zone_plan(); }) *request.mutable_zone_plan() = result_.zones;
    if constexpr (requires { request.mutable_object_list(); }) *request.mutable_object_list() = result_.objects;
    if constexpr (requires { request.mutable_constraint_list(); }) {
      *request.mutable_constraint_list() = result_.constraints;
    }
    ASSIGN_OR_RETURN(const Response response, handlers_.Handle(request, call_));
    part = ((response).*get)();
    result_.calls.insert(result_.calls.end(), response.model_calls().begin(), response.model_calls().end());
    return absl::OkStatus();
  }

  const RecordedRoom& room_;
  const LanguageHandlers& handlers_;
  ImportedAnswers& result_;
  runtime::CallContext call_;
};

using nlohmann::json;

std::string ToJson(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  std::string text;
  // Texts are UTF-8: they come out of a JSON file.
  const bool printed = google::protobuf::util::MessageToJsonString(message, &text, options).ok();
  return printed ? text : "{}";
}

// One line a sentence, as the prompt asks for.
std::string ToJson(const model::v1::CallsAnswer& answer) {
  json lines = json::array();
  for (const model::v1::SentenceCallsAnswer& sentence : answer.sentences()) {
    lines.push_back(fmt::format("{}: {}", sentence.id(), fmt::join(sentence.calls(), "; ")));
  }
  return json{{"sentences", lines}}.dump(-1, ' ', false, json::error_handler_t::replace);
}

// The first message of the user: the question. Repairs have another one behind it.
std::string QuestionOf(const llm::ChatRequest& request) {
  for (const llm::Message& message : request.messages) {
    if (message.role == llm::Role::kUser) return message.text;
  }
  return "";
}

// The choices of the first field of that name in a schema.
std::vector<std::string> FindChoices(const json& schema, const char* field) {
  std::vector<std::string> names;
  if (!schema.is_structured()) return names;
  if (schema.is_object() && schema.contains("properties") && schema["properties"].contains(field)) {
    const json& described = schema["properties"][field];
    // Of a list, those of its elements.
    for (const json& name : described.value("items", described).value("enum", json::array())) {
      if (name.is_string()) names.push_back(name.get<std::string>());
    }
    return names;
  }
  for (const json& part : schema) {
    names = FindChoices(part, field);
    if (!names.empty()) break;
  }
  return names;
}

constexpr size_t kLargestFile = 10'000'000;

absl::Status Bad(const std::string& why) {
  return absl::InvalidArgumentError("not a recorded room with its answers: " + why);
}

// Line breaks and tabs come from typing; a brief has none, nor blanks around it.
std::string OneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  absl::StripAsciiWhitespace(&text);
  return text;
}

absl::Status ReadTexts(const json& problem, RecordedRoom& room) {
  const auto language = problem.find("language");
  if (language == problem.end() || !language->is_object()) {
    return Bad("language: should be an object with the texts that the model wrote");
  }
  for (const auto& [name, text] : language->items()) {
    if (text.is_null()) continue;
    if (!text.is_string()) return Bad(fmt::format("language.{}: should be text", name));
    room.texts[name] = text.get<std::string>();
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<ImportedAnswers> ImportAnswers(const RecordedRoom& room, const Handbook& handbook,
                                              const llm::PromptLibrary& prompts, const std::string& folder) {
  auto recorded = std::make_unique<RecordedRoomClient>(room, handbook);
  const RecordedRoomClient& client = *recorded;
  absl::StatusOr<std::unique_ptr<llm::LlmClient>> recording = llm::MakeRecordingClient(std::move(recorded), folder);
  if (!recording.ok()) return recording.status();
  const ModelHandlers handlers(handbook, *std::move(recording), prompts);
  ImportedAnswers result;
  RETURN_IF_ERROR(Phase(room, handlers, result).Run());
  result.conversions = client.conversions();
  return result;
}

absl::StatusOr<std::string> RecordedRoomClient::Answer(const std::string& step, const llm::ChatRequest& request) {
  Conversion conversion;
  const auto keep = [&](const auto& answer) {
    const std::lock_guard lock(mutex_);
    conversions_[step] = std::move(conversion);
    return ToJson(answer);
  };
  const std::string question = QuestionOf(request);
  if (step == "room") return keep(answers_.Room());
  if (step == "zones") return keep(answers_.Zones());
  if (step == "objects.floor") return keep(answers_.FloorObjects());
  if (step == "objects.tertiary") return keep(answers_.Tertiaries(question, conversion));
  if (step == "constraints.intra") return keep(answers_.Intra(question, conversion));
  if (step == "constraints.inter") return keep(answers_.Inter(question, conversion));
  // The sentences are those that the recorded model had cleaned.
  if (step == "cleaning") return keep(model::v1::CleaningAnswer());
  const json schema = json::parse(request.schema, nullptr, /*allow_exceptions=*/false);
  if (step == "style") return keep(answers_.Style(FindChoices(schema, "of")));
  if (step.starts_with("translation.")) return keep(FindCalls(room_, step, question, conversion));
  return NotFound("step \"{}\": a recorded room has no answer to it", step);
}

absl::StatusOr<llm::ChatAnswer> RecordedRoomClient::Ask(const llm::ChatRequest& request, runtime::CallContext&) {
  // A repair shows what was answered; that is answered again.
  const bool repair = request.step.ends_with("/repair") && request.messages.size() > 2;
  llm::ChatAnswer answer;
  ASSIGN_OR_RETURN(answer.text,
                   repair ? request.messages[request.messages.size() - 2].text : Answer(request.step, request));
  answer.model = "gpt-4o-recorded";
  answer.usage.estimated = true;
  answer.usage.input_token_count = llm::EstimateTokens(request);
  answer.usage.output_token_count = llm::EstimateTokens(answer.text);
  return answer;
}

std::map<std::string, Conversion> RecordedRoomClient::conversions() const {
  const std::lock_guard lock(mutex_);
  return conversions_;
}

std::string_view RecordedRoom::Text(std::string_view name) const {
  const auto found = texts.find(name);
  return found == texts.end() ? std::string_view() : found->second;
}

std::vector<const v1::Object*> RecordedRoom::FloorObjects() const {
  std::vector<const v1::Object*> objects;
  for (const v1::Object& object : graph.object_list().objects()) {
    if (object.role() != v1::OBJECT_ROLE_TERTIARY) objects.push_back(&object);
  }
  return objects;
}

std::vector<const v1::Object*> RecordedRoom::Tertiaries() const {
  std::vector<const v1::Object*> objects;
  for (const v1::Object& object : graph.object_list().objects()) {
    if (object.role() == v1::OBJECT_ROLE_TERTIARY) objects.push_back(&object);
  }
  return objects;
}

absl::StatusOr<RecordedRoom> ReadRecordedRoom(const std::string& text) {
  if (text.size() > kLargestFile) return Bad(fmt::format("has {} bytes; at most {}", text.size(), kLargestFile));
  const absl::StatusOr<json> problem = evaluation::ParseFlairGptText(text);
  if (!problem.ok()) return Bad(std::string(problem.status().message()));
  RecordedRoom room;
  room.digest = runtime::Sha256Hex(text).substr(0, 8);
  const json prompt = problem->is_object() ? problem->value("prompt", json()) : json();
  if (!prompt.is_string()) return Bad("prompt: should be the text that the model was asked with");
  room.brief.set_text(OneLine(prompt.get<std::string>()));
  if (absl::Status status = Validate(room.brief); !status.ok()) {
    return Bad(fmt::format("prompt: {}", std::string(status.message())));
  }
  ASSIGN_OR_RETURN(v1::LayoutGraph graph, evaluation::ReadFlairGptProblem(*problem));
  room.graph = std::move(graph);
  if (room.FloorObjects().empty()) return Bad("primary: names no object");
  if (room.graph.zone_plan().zones().empty()) return Bad("zones: names no zone");
  RETURN_IF_ERROR(ReadTexts(*problem, room));
  return room;
}

}  // namespace flair::language
