// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>

#include "flair/model/v1/style_answers.pb.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/colour_text.h"
#include "language_worker/model/prompt_text.h"
#include "language_worker/model/steps.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::language {
namespace {

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
