// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/recorded_room.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "absl/strings/ascii.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

using nlohmann::json;

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
