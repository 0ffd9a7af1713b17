// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/prompt_texts.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "llm/answers/prompt_library.h"

namespace flair::translator {
namespace {

// As the prompt explains the kinds.
const char* KindText(v1::ParameterKind kind) {
  switch (kind) {
    case v1::PARAMETER_KIND_OBJECT:
      return "object";
    case v1::PARAMETER_KIND_OBJECTS:
      return "objects";
    case v1::PARAMETER_KIND_ZONE:
      return "zone";
    case v1::PARAMETER_KIND_FEATURE:
      return "feature";
    case v1::PARAMETER_KIND_WALL:
      return "wall";
    case v1::PARAMETER_KIND_SIDE:
      return "side";
    case v1::PARAMETER_KIND_SIDES:
      return "sides";
    case v1::PARAMETER_KIND_CORNER:
      return "corner";
    case v1::PARAMETER_KIND_NUMBER:
      return "number";
    case v1::PARAMETER_KIND_BOOLEAN:
      return "true|false";
    default:
      return "text";
  }
}

// "target", "side?", "max_distance_m? = 0.5", "others: objects": what the name says already is not said again.
std::string ParameterText(const v1::ParameterSpec& parameter) {
  std::string text = parameter.name() + (parameter.required() ? "" : "?");
  const std::string kind = KindText(parameter.kind());
  const bool clear = parameter.kind() == v1::PARAMETER_KIND_OBJECT || kind == parameter.name() ||
                     (!parameter.unit().empty() && parameter.name().ends_with("_" + parameter.unit()));
  if (!clear) text += ": " + kind;
  if (parameter.has_default_value() && parameter.default_value().has_number()) {
    text += fmt::format(" = {}", parameter.default_value().number());
  } else if (parameter.has_default_value() && !parameter.default_value().text().empty()) {
    text += " = " + parameter.default_value().text();
  }
  return text;
}

const char* PlaceText(const v1::Object& object) {
  switch (object.kind()) {
    case v1::OBJECT_KIND_WALL:
      return "on a wall";
    case v1::OBJECT_KIND_CEILING:
      return "on the ceiling";
    case v1::OBJECT_KIND_SURFACE:
      return "on another object";
    default:
      return object.walk_over() ? "on the floor, walked over" : "on the floor";
  }
}

std::string CountText(int64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::string FunctionsText(std::span<const v1::ConstraintType* const> types) {
  std::string text;
  for (const v1::ConstraintType* type : types) {
    std::vector<std::string> parameters;
    for (const v1::ParameterSpec& parameter : type->parameters()) parameters.push_back(ParameterText(parameter));
    text += fmt::format("- {}({}): {}", type->name(), fmt::join(parameters, ", "), type->summary());
    if (!type->examples().empty()) text += fmt::format(" \"{}\"", type->examples(0).sentence());
    text += "\n";
  }
  return text;
}

std::string RoomText(const v1::Room& room) {
  double width_m = 0, depth_m = 0;
  for (const v1::Point2& vertex : room.floor().vertices()) {
    width_m = std::max(width_m, vertex.x_m());
    depth_m = std::max(depth_m, vertex.y_m());
  }
  std::vector<std::string> walls;
  for (const v1::Wall& wall : room.walls()) walls.push_back(wall.name());
  const auto doors = std::count_if(room.openings().begin(), room.openings().end(),
                                   [](const v1::Opening& opening) { return opening.kind() == v1::OPENING_KIND_DOOR; });
  return fmt::format("{:.2f} x {:.2f} m; walls {}; {}, {}, {}", width_m, depth_m, fmt::join(walls, ", "),
                     CountText(doors, "door"), CountText(room.openings_size() - doors, "window"),
                     CountText(room.sockets_size(), "socket"));
}

std::string ZonesText(const v1::ZonePlan& zones) {
  std::vector<std::string> ids;
  for (const v1::Zone& zone : zones.zones()) ids.push_back(zone.id());
  return fmt::format("{}", fmt::join(ids, ", "));
}

std::string ObjectsText(const v1::ObjectList& objects, std::span<const v1::Sentence* const> sentences) {
  std::set<std::string_view> spoken_of;
  bool about_tertiaries = false;
  for (const v1::Sentence* sentence : sentences) {
    spoken_of.insert(sentence->subject_ids().begin(), sentence->subject_ids().end());
    about_tertiaries |= sentence->scope() == v1::SENTENCE_SCOPE_TERTIARY;
  }
  std::string text;
  for (const v1::Object& object : objects.objects()) {
    const bool tertiary = object.role() == v1::OBJECT_ROLE_TERTIARY;
    if (tertiary && !about_tertiaries && !spoken_of.contains(object.id())) continue;
    text += fmt::format("- {}: {}, {:.2f} x {:.2f} x {:.2f}, {}, {}\n", object.id(), llm::QuoteData(object.name()),
                        object.width_m(), object.depth_m(), object.height_m(),
                        object.zone_id().empty() ? "no zone" : object.zone_id(), PlaceText(object));
  }
  return text;
}

std::string SentencesText(std::span<const v1::Sentence* const> sentences) {
  std::string text;
  for (const v1::Sentence* sentence : sentences) {
    text += fmt::format("- {} [{}] {}\n", sentence->id(), fmt::join(sentence->subject_ids(), ", "),
                        llm::QuoteData(sentence->text()));
  }
  return text;
}

}  // namespace flair::translator
