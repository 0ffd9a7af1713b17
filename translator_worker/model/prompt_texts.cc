// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/prompt_texts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "absl/strings/ascii.h"
#include "fmt/format.h"
#include "llm/answers/prompt_library.h"

namespace flair::translator {
namespace {

// As the prompt explains the kinds.
std::string KindText(v1::ParameterKind kind) {
  constexpr size_t kPrefix = sizeof("PARAMETER_KIND_") - 1;
  if (kind == v1::PARAMETER_KIND_BOOLEAN) return "true|false";
  if (!v1::ParameterKind_IsValid(kind) || kind == v1::PARAMETER_KIND_UNSPECIFIED) return "text";
  return absl::AsciiStrToLower(v1::ParameterKind_Name(kind).substr(kPrefix));
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

using Families = std::vector<std::string_view>;

const Families& FamiliesOf(v1::SentenceScope scope) {
  static const Families intra = {"wall", "feature", "space", "room"};
  static const Families inter = {"pair", "group", "space", "wall"};
  static const Families tertiary = {"rug", "surface", "on_wall", "ceiling", "wall", "pair"};
  return scope == v1::SENTENCE_SCOPE_INTRA ? intra : (scope == v1::SENTENCE_SCOPE_INTER ? inter : tertiary);
}

bool IsOurs(std::string_view family) {
  static const Families ours = {"wall",  "feature", "space",   "room",    "pair",
                                "group", "rug",     "surface", "on_wall", "ceiling"};
  return std::ranges::find(ours, family) != ours.end();
}

bool Any(const v1::ObjectList& list, v1::ObjectKind kind, bool tertiary_only) {
  return std::ranges::any_of(list.objects(), [&](const v1::Object& object) {
    return object.kind() == kind && (!tertiary_only || object.role() == v1::OBJECT_ROLE_TERTIARY);
  });
}

// Whether a sentence of the pass has the word, in lower case or at its beginning.
bool Says(const v1::TranslateRequest& request, const Pass& pass, std::string_view word_without_first) {
  return std::ranges::any_of(request.constraint_list().sentences(), [&](const v1::Sentence& sentence) {
    return sentence.scope() == pass.scope && sentence.text().find(word_without_first) != std::string::npos;
  });
}

// Whether a pass has what the types of a family are about, or speaks of it.
bool HasUseFor(std::string_view family, const Pass& pass, const v1::TranslateRequest& request) {
  const v1::ObjectList& objects = request.object_list();
  if (family == "on_wall") return Any(objects, v1::OBJECT_KIND_WALL, false) || Says(request, pass, "wall");
  if (family == "ceiling") return Any(objects, v1::OBJECT_KIND_CEILING, false) || Says(request, pass, "eiling");
  // Of the small things only those on the floor stand at walls, and only some of them are rugs.
  const bool small_on_floor = Any(objects, v1::OBJECT_KIND_FLOOR, true);
  if (family == "rug") return small_on_floor || Says(request, pass, "rug");
  if (family != "wall" || pass.scope == v1::SENTENCE_SCOPE_INTRA) return true;
  // What stands at a wall by itself is told where objects are told one by one.
  if (pass.scope == v1::SENTENCE_SCOPE_INTER) return Says(request, pass, "wall") || Says(request, pass, "corner");
  return small_on_floor;
}

// Whether there is something for every argument that a type needs.
bool CanBeCalled(const v1::ConstraintType& type, const v1::TranslateRequest& request) {
  int object_count = 0;
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (!parameter.required()) continue;
    const v1::ParameterKind kind = parameter.kind();
    object_count += kind == v1::PARAMETER_KIND_OBJECT || kind == v1::PARAMETER_KIND_OBJECTS ? 1 : 0;
    if (kind == v1::PARAMETER_KIND_ZONE && request.zone_plan().zones().empty()) return false;
    if (kind == v1::PARAMETER_KIND_FEATURE && request.room().openings().empty() && request.room().sockets().empty()) {
      return false;
    }
  }
  return object_count <= request.object_list().objects_size();
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
  const auto doors = std::ranges::count_if(
      room.openings(), [](const v1::Opening& opening) { return opening.kind() == v1::OPENING_KIND_DOOR; });
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

std::vector<const v1::ConstraintType*> TypesFor(const Pass& pass, const v1::TranslateRequest& request) {
  const Families& families = FamiliesOf(pass.scope);
  std::vector<const v1::ConstraintType*> types;
  for (const v1::ConstraintType& type : request.catalog().types()) {
    if (type.built_in() || !CanBeCalled(type, request)) continue;
    const bool wanted =
        std::ranges::find(families, type.family()) != families.end() && HasUseFor(type.family(), pass, request);
    if (wanted || !IsOurs(type.family())) types.push_back(&type);
  }
  return types;
}

}  // namespace flair::translator
