// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

// `name` without the words that only say that it is a zone.
std::string ZoneWords(const std::string& name) {
  std::istringstream words(FlairGptWords(name));
  std::string left;
  for (std::string word; words >> word;) {
    if (FlairGptMeaning("zone_words", word) == nullptr) left += (left.empty() ? "" : " ") + word;
  }
  return left;
}

std::string Quoted(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

// The sides that a word means on an object that is `wide`: not deeper than wide. INVALID_ARGUMENT when none.
absl::StatusOr<Words> SidesNamed(const std::string& word, bool wide) {
  const Words ends = {"front", "back"}, flanks = {"left", "right"};
  if (word == "all" || word == "every" || word == "all sides") return Words{"front", "back", "left", "right"};
  if (word == "side" || word == "sides") return flanks;
  if (word.rfind("long", 0) == 0 || word == "length") return wide ? ends : flanks;
  if (word.rfind("short", 0) == 0 || word == "width") return wide ? flanks : ends;
  if (const json* side = FlairGptMeaning("sides", word)) return Words{*side};
  return InvalidArgument("unknown side \"{}\"", word);
}

absl::StatusOr<std::string> Corner(const json& value) {
  const json* const corner = value.is_string() ? FlairGptMeaning("corners", value) : nullptr;
  if (corner == nullptr) return InvalidArgument("unknown corner {}", Quoted(value));
  return corner->get<std::string>();
}

}  // namespace

std::string FlairGptWords(const std::string& name) {
  std::string words;
  for (char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte)) words += static_cast<char>(std::tolower(byte));
    if (!std::isalnum(byte) && !words.empty() && words.back() != ' ') words += ' ';
  }
  if (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

std::string FlairGptObjectId(bool tertiary, int index) {
  return fmt::format("{}_{}", tertiary ? "item" : "floor", index);
}

absl::StatusOr<std::string> FlairGptArguments::ObjectId(const json& recorded, bool tertiary) const {
  const json value = recorded.is_array() && recorded.size() == 1 ? json(recorded[0]) : recorded;
  std::string id;
  if (value.is_number()) {
    const double index = value.get<double>();
    if (index == std::floor(index) && std::abs(index) <= kLargestIndex) {
      id = FlairGptObjectId(tertiary, static_cast<int>(index));
    }
  }
  int matches = 0;
  for (const v1::Object& object : graph_.object_list().objects()) {
    if (object.id() == id) return id;
    if (value.is_string() && FlairGptWords(object.name()) == FlairGptWords(value) && ++matches > 0) id = object.id();
  }
  if (value.is_string() && matches == 1) return id;
  return NotFound("no object {}", Quoted(recorded));
}

absl::StatusOr<std::string> FlairGptArguments::Feature(const json& value) const {
  const json* const feature = value.is_string() ? FlairGptMeaning("features", FlairGptWords(value)) : nullptr;
  if (feature == nullptr) return NotFound("no feature {}", Quoted(value));
  const std::string kind = *feature;
  for (const v1::Opening& opening : graph_.room().openings()) {
    if (kind == (opening.kind() == v1::OPENING_KIND_DOOR ? "door" : "window")) return kind;
  }
  if (kind == "socket" && graph_.room().sockets_size() > 0) return kind;
  return NotFound("the room has no {}", kind);
}

absl::StatusOr<std::string> FlairGptArguments::ZoneId(const json& value) const {
  std::vector<std::string> matches;
  for (const v1::Zone& zone : graph_.zone_plan().zones()) {
    if (!value.is_string()) break;
    if (FlairGptWords(zone.name()) == FlairGptWords(value)) return zone.id();
    const std::string left = ZoneWords(value);
    if (!left.empty() && ZoneWords(zone.name()) == left) matches.push_back(zone.id());
  }
  if (matches.size() == 1) return matches.front();
  return NotFound("no zone {}", Quoted(value));
}

absl::StatusOr<Words> FlairGptArguments::Sides(const json& value, const std::string& object_id) const {
  Words words, sides;
  if (value.is_string()) words.push_back(value);
  if (value.is_array()) {
    for (const json& word : value) words.push_back(word.is_string() ? word.get<std::string>() : Quoted(word));
  }
  bool wide = true;
  for (const v1::Object& object : graph_.object_list().objects()) {
    if (object.id() == object_id) wide = object.width_m() >= object.depth_m();
  }
  for (const std::string& word : words) {
    if (word == "one" || word == "any") return Words{"front"};
    ASSIGN_OR_RETURN(const Words named, SidesNamed(word, wide));
    for (const std::string& side : named) {
      if (std::ranges::find(sides, side) == sides.end()) sides.push_back(side);
    }
  }
  return sides;
}

absl::StatusOr<Words> FlairGptArguments::Objects(const json& value) const {
  if (!value.is_array()) return InvalidArgument("{} is not a list of objects", Quoted(value));
  Words ids;
  for (const json& item : value) {
    ASSIGN_OR_RETURN(std::string id, ObjectId(item, false));
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(std::move(id));
  }
  return ids;
}

absl::StatusOr<std::optional<v1::Argument>> FlairGptArguments::Read(const FlairGptParameter& parameter,
                                                                    const json& value,
                                                                    const std::string& object_id) const {
  if (parameter.kind == FlairGptKind::kIgnored) return std::nullopt;
  if (value.is_null()) {
    if (parameter.required) return InvalidArgument("{} is not given", parameter.name);
    return std::nullopt;
  }
  v1::Argument argument;
  argument.set_name(parameter.name);
  v1::ArgumentValue& read = *argument.mutable_value();
  std::string text;
  switch (parameter.kind) {
    case FlairGptKind::kNumber:
      if (!value.is_number()) return InvalidArgument("{} is {}, not a number", parameter.name, Quoted(value));
      read.set_number(value.get<double>());
      return argument;
    case FlairGptKind::kFlag:
      read.set_flag(value.is_boolean() && value.get<bool>());
      return argument;
    case FlairGptKind::kFloorObjects: {
      ASSIGN_OR_RETURN(const Words ids, Objects(value));
      read.mutable_texts()->mutable_items()->Add(ids.begin(), ids.end());
      return argument;
    }
    case FlairGptKind::kSides: {
      ASSIGN_OR_RETURN(const Words sides, Sides(value, object_id));
      if (sides.empty()) return std::nullopt;
      read.mutable_texts()->mutable_items()->Add(sides.begin(), sides.end());
      return argument;
    }
    case FlairGptKind::kSide: {
      ASSIGN_OR_RETURN(const Words sides, Sides(value, object_id));
      // "At its sides" where one side is asked for leaves the side open.
      if (sides.size() != 1) return std::nullopt;
      text = sides.front();
      break;
    }
    case FlairGptKind::kZone: {
      ASSIGN_OR_RETURN(text, ZoneId(value));
      break;
    }
    case FlairGptKind::kFeature: {
      ASSIGN_OR_RETURN(text, Feature(value));
      break;
    }
    case FlairGptKind::kCorner: {
      ASSIGN_OR_RETURN(text, Corner(value));
      break;
    }
    default: {
      ASSIGN_OR_RETURN(text, ObjectId(value, parameter.kind == FlairGptKind::kItem));
    }
  }
  read.set_text(text);
  return argument;
}

}  // namespace flair::evaluation
