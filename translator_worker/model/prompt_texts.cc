// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/prompt_texts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "llm/answers/choices.h"
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

// Where it is when it does not simply stand on the floor; with what separates it.
const char* PlaceText(const v1::Object& object) {
  switch (object.kind()) {
    case v1::OBJECT_KIND_WALL:
      return ", on a wall";
    case v1::OBJECT_KIND_CEILING:
      return ", on the ceiling";
    case v1::OBJECT_KIND_SURFACE:
      return ", on another object";
    default:
      return object.walk_over() ? ", walked over" : "";
  }
}

std::string CountText(int64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// Without the marks of code.
std::string Plain(std::string text) {
  std::erase(text, '`');
  return text;
}

// Words of a text in lower case.
std::set<std::string> WordsOf(std::string_view text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower >= 'a' && lower <= 'z') {
      word += lower;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  if (!word.empty()) words.insert(word);
  return words;
}

// An example that says a type's name in other words; one in the name's own tells a model nothing.
std::string ExampleOf(const v1::ConstraintType& type) {
  if (type.examples().empty()) return "";
  const std::set<std::string> said = WordsOf(type.examples(0).sentence()), name = WordsOf(type.name());
  if (std::includes(said.begin(), said.end(), name.begin(), name.end())) return "";
  return fmt::format(" \"{}\"", type.examples(0).sentence());
}

double Rounded(double value_m) { return std::round(value_m * 100) / 100; }

// "dining_chair_3" without its number.
std::string_view WithoutNumber(std::string_view id) {
  const size_t last = id.find_last_not_of("0123456789");
  const bool numbered = last != std::string_view::npos && last > 0 && last + 1 < id.size() && id[last] == '_';
  return numbered ? id.substr(0, last) : id;
}

// Equal but for their ids.
bool Alike(const v1::Object& a, const v1::Object& b) {
  return a.name() == b.name() && a.zone_id() == b.zone_id() && a.kind() == b.kind() && a.width_m() == b.width_m() &&
         a.depth_m() == b.depth_m() && a.walk_over() == b.walk_over();
}

std::string ObjectLine(std::span<const v1::Object* const> alike) {
  const v1::Object& first = *alike.front();
  std::vector<std::string> ids;
  for (const v1::Object* object : alike) ids.push_back(object->id());
  std::string line = fmt::format("- {}: ", fmt::join(ids, ", "));
  // A name that the id tells is not said again.
  if (llm::Bare(WithoutNumber(first.id())) != llm::Bare(first.name())) line += llm::QuoteData(first.name()) + ", ";
  return line + fmt::format("{} x {}, {}{}\n", Rounded(first.width_m()), Rounded(first.depth_m()),
                            first.zone_id().empty() ? "no zone" : first.zone_id(), PlaceText(first));
}

}  // namespace

std::string FunctionsText(std::span<const v1::ConstraintType* const> types) {
  std::string text;
  for (const v1::ConstraintType* type : types) {
    std::vector<std::string> parameters;
    for (const v1::ParameterSpec& parameter : type->parameters()) parameters.push_back(ParameterText(parameter));
    text += fmt::format("- {}({}): {}{}", type->name(), fmt::join(parameters, ", "), Plain(type->summary()),
                        ExampleOf(*type));
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
  std::vector<const v1::Object*> shown;
  for (const v1::Object& object : objects.objects()) {
    const bool tertiary = object.role() == v1::OBJECT_ROLE_TERTIARY;
    if (!tertiary || about_tertiaries || spoken_of.contains(object.id())) shown.push_back(&object);
  }
  std::string text;
  for (size_t begin = 0, end = 0; begin < shown.size(); begin = end) {
    while (end < shown.size() && Alike(*shown[begin], *shown[end])) ++end;
    text += ObjectLine(std::span(shown).subspan(begin, end - begin));
  }
  return text;
}

std::string SentencesText(std::span<const v1::Sentence* const> sentences) {
  std::string text, heading;
  for (const v1::Sentence* sentence : sentences) {
    std::string own = fmt::format("[{}]\n", fmt::join(sentence->subject_ids(), ", "));
    if (own != heading) text += own;
    heading = std::move(own);
    text += fmt::format("- {} {}\n", sentence->id(), llm::QuoteData(sentence->text()));
  }
  return text;
}

}  // namespace flair::translator
