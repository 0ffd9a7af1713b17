// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include "flair/model/v1/style_answers.pb.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "llm/answers/read_answer.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::language {
namespace {

constexpr size_t kLongestName = 60;
// A value where it stands in a text: "#7A8B6F", "#fee", "B98B55" with a digit, since "facade" is a word, "rgb(238, 85,
// 0)".
struct FoundValue {
  v1::Colour colour;
  size_t begin = 0;
  size_t end = 0;
};

std::optional<FoundValue> FindValue(std::string_view text) {
  static const auto* const kValue = new std::regex(
      R"(#([0-9a-f]{6}|[0-9a-f]{3})(?![0-9a-f])|\b((?=[a-f]*[0-9])[0-9a-f]{6})\b|\brgb\(([0-9]{1,3}), *([0-9]{1,3}), *([0-9]{1,3})\))",
      std::regex::icase);
  std::cmatch match;
  if (!std::regex_search(text.data(), text.data() + text.size(), match, *kValue)) return std::nullopt;
  std::array<int, 3> parts = {};
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string hex = match[1].matched ? match[1].str() : match[2].str();
    const size_t digits = hex.size() / parts.size();
    if (hex.empty()) parts[i] = std::stoi(match[3 + i].str());
    if (!hex.empty()) parts[i] = std::stoi(hex.substr(i * digits, digits), nullptr, 16) * (digits == 1 ? 17 : 1);
    if (parts[i] > 255) return std::nullopt;
  }
  FoundValue found;
  found.begin = static_cast<size_t>(match.position());
  found.end = found.begin + static_cast<size_t>(match.length());
  found.colour.set_red(parts[0]);
  found.colour.set_green(parts[1]);
  found.colour.set_blue(parts[2]);
  return found;
}

std::string NameIn(std::string_view text) {
  constexpr std::string_view kMarks = " \t#()[]:;,.-/|";
  const size_t first = text.find_first_not_of(kMarks);
  if (first == std::string_view::npos) return "";
  text = text.substr(first, text.find_last_not_of(kMarks) - first + 1);
  return llm::CutBytes(std::string(text), kLongestName);
}

// The handbook's colour of that name, else of the end of it: "deep forest green" is a forest green, or a green.
const hb::NamedColour* FindNamed(std::string_view name, const Handbook& handbook) {
  std::string rest = PlainName(name);
  while (!rest.empty()) {
    if (const hb::NamedColour* const named = handbook.FindColour(rest)) return named;
    rest.erase(0, std::min(rest.find(' '), rest.size() - 1) + 1);
  }
  return nullptr;
}

using llm::Fault;
using llm::FaultKind;
using model::v1::LookAnswer;
using model::v1::StyleAnswer;

struct StyleRequest {
  const v1::Brief& brief;
  const v1::Room& room;
  const v1::ObjectList& objects;
};

constexpr const char* kSubjectField = "flair.model.v1.LookAnswer.of";

// Groups by name, then openings by id: what a look is asked for.
std::vector<ObjectGroup> Subjects(const StyleRequest& request) {
  return GroupObjects(request.objects, /*floor_only=*/false);
}

std::string SubjectsText(const StyleRequest& request) {
  std::string text;
  for (const ObjectGroup& group : Subjects(request)) text += (text.empty() ? "" : ", ") + group.name;
  for (const v1::Opening& opening : request.room.openings()) text += ", " + opening.id();
  return text;
}

llm::Choices SubjectChoices(const StyleRequest& request) {
  llm::Choices choices;
  for (const ObjectGroup& group : Subjects(request)) {
    choices.names.push_back(group.name);
    for (const v1::Object* object : group.objects) choices.aliases[object->id()] = group.name;
  }
  for (const v1::Opening& opening : request.room.openings()) choices.names.push_back(opening.id());
  return choices;
}

void CheckColour(const std::string& colour, const std::string& path, const Handbook& handbook,
                 std::vector<Fault>& faults) {
  if (ReadColour(colour, handbook)) return;
  faults.push_back({path, fmt::format("is {}; a colour such as \"sage #7A8B6F\" would be right", llm::Quoted(colour))});
}

std::vector<std::string> SubjectIds(const std::string& name, const StyleRequest& request) {
  std::vector<std::string> ids = IdsOf(name, Subjects(request));
  if (ids.empty()) ids.push_back(name);  // an opening
  return ids;
}

// "warm white lacquer"; the material alone when it names its colour: "oak".
std::string FinishText(const std::string& material, const v1::Colour& colour) {
  const bool named = PlainName(material).find(PlainName(colour.name())) != std::string::npos;
  return named ? material : colour.name() + " " + material;
}

v1::StyleSheet ToStyleSheet(const StyleRequest& request, const Handbook& handbook, const StyleAnswer& answer) {
  const auto colour = [&](const std::string& text) { return ReadColour(text, handbook).value_or(v1::Colour()); };
  v1::StyleSheet sheet;
  sheet.set_name(answer.name());
  sheet.set_summary(answer.summary());
  for (const std::string& main : answer.palette()) *sheet.add_palette() = colour(main);
  std::set<std::string> seen;
  for (const model::v1::SurfaceAnswer& surface : answer.surfaces()) {
    if (!seen.insert(surface.surface()).second) continue;
    v1::SurfaceStyle& style = *sheet.add_surfaces();
    style.set_surface(surface.surface());
    style.set_material(surface.material());
    *style.mutable_colour() = colour(surface.colour());
    style.set_description(FinishText(surface.material(), style.colour()));
  }
  for (const LookAnswer& look : answer.looks()) {
    std::vector<std::string> ids;
    for (const std::string& name : look.of()) {
      for (std::string& id : SubjectIds(name, request)) ids.push_back(std::move(id));
    }
    for (const std::string& id : ids) {
      if (!seen.insert("of " + id).second) continue;
      v1::ObjectStyle& style = *sheet.add_objects();
      style.set_subject_id(id);
      style.set_material(look.material());
      *style.mutable_colour() = colour(look.colour());
      style.set_description(look.description().empty() ? FinishText(look.material(), style.colour())
                                                       : look.description());
    }
  }
  return sheet;
}

// Takes from another sheet what this one says nothing of.
void Complete(const v1::StyleSheet& other, v1::StyleSheet& sheet) {
  int taken = 0;
  std::set<std::string> there;
  for (const v1::SurfaceStyle& surface : sheet.surfaces()) there.insert(surface.surface());
  for (const v1::SurfaceStyle& surface : other.surfaces()) {
    if (there.contains(surface.surface())) continue;
    *sheet.add_surfaces() = surface;
    ++taken;
  }
  there.clear();
  for (const v1::ObjectStyle& object : sheet.objects()) there.insert(object.subject_id());
  for (const v1::ObjectStyle& object : other.objects()) {
    if (there.contains(object.subject_id())) continue;
    *sheet.add_objects() = object;
    ++taken;
  }
  if (sheet.palette().empty()) *sheet.mutable_palette() = other.palette();
  if (taken > 0) {
    AddDiagnostic(v1::SEVERITY_NOTE, "style_completed",
                  fmt::format("The model said nothing of {} among surfaces and objects; {} as the handbook has it.",
                              Counted(taken, "thing"), Form(taken, "it looks", "they look")),
                  sheet);
  }
}

// What is wrong with an answer that reads well: colours that are none, hardly anything described.
std::vector<Fault> CheckStyle(const StyleRequest& request, const ModelTools& tools, const StyleAnswer& answer) {
  std::vector<Fault> faults;
  for (int i = 0; i < answer.palette_size(); ++i) {
    CheckColour(answer.palette(i), fmt::format("palette[{}]", i), tools.handbook, faults);
  }
  for (int i = 0; i < answer.surfaces_size(); ++i) {
    CheckColour(answer.surfaces(i).colour(), fmt::format("surfaces[{}].colour", i), tools.handbook, faults);
  }
  std::set<std::string> seen;
  for (int i = 0; i < answer.looks_size(); ++i) {
    CheckColour(answer.looks(i).colour(), fmt::format("looks[{}].colour", i), tools.handbook, faults);
    seen.insert(answer.looks(i).of().begin(), answer.looks(i).of().end());
  }
  const size_t wanted = Subjects(request).size() + static_cast<size_t>(request.room.openings_size());
  // The rest looks as the handbook has it; another call is worth more than that only when hardly anything is there.
  if (4 * seen.size() < wanted) {
    faults.push_back(
        {"looks", fmt::format("describes {} of {} objects, doors and windows; all would be right", seen.size(), wanted),
         FaultKind::kDoubtful});
  }
  return faults;
}

}  // namespace

std::optional<v1::Colour> ReadColour(std::string_view text, const Handbook& handbook) {
  if (std::optional<FoundValue> value = FindValue(text)) {
    std::string name = NameIn(text.substr(0, value->begin));
    if (name.empty()) name = NameIn(text.substr(value->end));
    value->colour.set_name(name);
    return value->colour;
  }
  const std::string name = NameIn(text.substr(0, text.find('#')));
  const hb::NamedColour* named = FindNamed(name, handbook);
  if (named == nullptr) return std::nullopt;
  v1::Colour colour = ToColour(*named);
  colour.set_name(name);
  return colour;
}

absl::StatusOr<v1::StyleSheet> AskStyle(const v1::Brief& brief, const v1::Room& room, const v1::ObjectList& objects,
                                        const ModelTools& tools, llm::Conversation& conversation) {
  const StyleRequest request{brief, room, objects};
  llm::Question question = MakeQuestion(
      tools, "style", "style",
      {{"brief", llm::QuoteData(brief.text())}, {"room", ShortRoomText(room)}, {"objects", SubjectsText(request)}},
      StyleAnswer::default_instance());
  question.choices[kSubjectField] = SubjectChoices(request);
  question.check = llm::CheckOf<StyleAnswer>([&](StyleAnswer& answer) { return CheckStyle(request, tools, answer); });
  const auto make = [&](const StyleAnswer& answer) -> absl::StatusOr<v1::StyleSheet> {
    v1::StyleSheet sheet = ToStyleSheet(request, tools.handbook, answer);
    ASSIGN_OR_RETURN(const v1::StyleSheet usual, ChooseStyle(brief, room, objects, tools.handbook));
    Complete(usual, sheet);
    return sheet;
  };
  return AskFor<StyleAnswer, v1::StyleSheet>(
      question, conversation, make, [&](const v1::StyleSheet& sheet) { return Validate(sheet, room, objects); });
}

}  // namespace flair::language
