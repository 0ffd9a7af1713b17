// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/provenance.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/model/object_size.h"
#include "llm/answers/conversation.h"
#include "llm/answers/prompt_library.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {

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
