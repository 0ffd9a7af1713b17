// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/provenance.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/parts/furniture_index.h"
#include "llm/answers/conversation.h"
#include "llm/answers/prompt_library.h"
#include "llm/answers/read_answer.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {

// Whether a name is that of something to walk over: "rug", "bath mat", "carpet runner".
bool IsRugName(std::string_view name);

// Extents of one object, metres.
struct ObjectSize {
  double width_m = 0;
  double depth_m = 0;
  double height_m = 0;
};

// "2.2 m x 0.6 m"
std::string FootprintText(const ObjectSize& size);

// What is odd about a size of that class, as a fault's text: more than 2.5 times as large as the class gets or as much
// smaller, as lengths in a wrong unit are; empty when nothing is, or the class is not known.
std::string OddSize(const ObjectSize& size, const hb::Furniture* furniture);

// What is wrong with the footprint of an object at a path of an answer: larger than the room in any turn, which is
// wrong, or odd for its class.
std::optional<llm::Fault> FootprintFault(const std::string& path, const ObjectSize& size, const FloorExtent& floor,
                                         const hb::Furniture* furniture);

// The object that an element of an answer describes: id, name, size no higher than the room, description, category.
template <typename Answer>
v1::Object DescribedObject(const Answer& answer, const std::string& id, const v1::Room& room,
                           const hb::Furniture* furniture) {
  v1::Object object;
  object.set_id(id);
  const std::string name = PlainName(answer.name());
  object.set_name(name.empty() ? answer.name() : name);
  object.set_width_m(answer.width_m());
  object.set_depth_m(answer.depth_m());
  object.set_height_m(std::min(answer.height_m(), room.height_m()));
  object.set_description(answer.description());
  object.set_requested(answer.requested());
  if (furniture != nullptr) {
    object.set_category(furniture->category());
    object.set_rim_sides_m(furniture->rim_sides_m());
    object.set_rim_ends_m(furniture->rim_ends_m());
    object.set_sat_at(furniture->sat_at());
    object.set_seat(furniture->has_seat_height_m());
  }
  return object;
}

// What the steps share; the parts outlive them. Immutable, thread-safe.
struct ModelTools {
  const llm::PromptLibrary& prompts;
  const Handbook& handbook;
  const FurnitureIndex& furniture;
};

// The prompts of this worker, for PromptLibrary::Load.
std::vector<llm::PromptSpec> LanguagePrompts();

// Where they are: share/flair/prompts/language beside the program's own folder when installed, else the source tree.
std::filesystem::path DefaultPromptsFolder();

// A question of a step: the system prompt, the step's prompt filled in, and the type of the answer.
llm::Question MakeQuestion(const ModelTools& tools, std::string step, std::string_view prompt,
                           const llm::PromptValues& values, const google::protobuf::Message& answer);

// Adds a remark for every fault that an answer had to the end: "left_out" for elements that were, else "model_answer".
template <typename WithDiagnostics>
void AddFaults(std::string_view step, const std::vector<llm::Fault>& faults, WithDiagnostics& to) {
  constexpr int kMost = 40;
  int told = 0;
  for (const llm::Fault& fault : faults) {
    if (++told > kMost) {
      AddDiagnostic(v1::SEVERITY_NOTE, "model_answer",
                    "The model's answer to \"" + std::string(step) + "\" has " + std::to_string(faults.size()) +
                        " faults; these are the first.",
                    to);
      return;
    }
    const bool wrong = fault.kind == llm::FaultKind::kWrong;
    AddDiagnostic(wrong ? v1::SEVERITY_WARNING : v1::SEVERITY_NOTE, wrong ? "left_out" : "model_answer",
                  "The model's answer to \"" + std::string(step) + "\": " + fault.Sentence() +
                      (wrong ? "; it was left out." : "."),
                  to);
  }
}

// The remark for what the handbook answered after the model had failed.
template <typename WithDiagnostics>
void AddStandIn(const absl::Status& failure, WithDiagnostics& to) {
  AddDiagnostic(v1::SEVERITY_WARNING, "stand_in",
                "The handbook answered instead of the model: " + std::string(failure.message()), to);
}

// The failure of a stage of which two steps failed.
absl::Status BothFailed(const absl::Status& first, const absl::Status& second);

// OK, or an error for a result that the model's answer was turned into and that does not validate after all.
absl::Status CheckResult(std::string_view step, const absl::Status& status);

// Asks a question and turns the answer into an artifact with `make(answer)`, which returns it or an error; adds remarks
// on the faults that the answer has to the end, and validates the artifact with `validate(artifact)`.
template <typename Answer, typename Artifact, typename Make, typename IsValid>
absl::StatusOr<Artifact> AskFor(const llm::Question& question, llm::Conversation& conversation, const Make& make,
                                const IsValid& validate) {
  ASSIGN_OR_RETURN(const llm::Reply reply, conversation.Ask(question));
  absl::StatusOr<Artifact> artifact = make(reply.As<Answer>());
  if (!artifact.ok()) return artifact;
  AddFaults(question.step, reply.faults, *artifact);
  RETURN_IF_ERROR(CheckResult(question.step, validate(*artifact)));
  return artifact;
}

// Makes ids of names that strangers gave: short, of a-z, 0-9 and "_", none twice.
class IdMaker {
 public:
  // An id for one thing: "desk", or "desk_2" when that is taken; `fallback` for names without a letter of ours.
  std::string Make(std::string_view name, std::string_view fallback);

  // Ids for `count` equal things: "dining_chair_1" and so on, or as Make for a single one.
  std::vector<std::string> MakeSeveral(std::string_view name, int count, std::string_view fallback);

  // This id, made elsewhere, or one like it when it is taken.
  std::string MakeLike(const std::string& id);

  // For an id that was made elsewhere.
  void Take(const std::string& id) { taken_.insert(id); }

 private:
  std::set<std::string, std::less<>> taken_;
};

}  // namespace flair::language
