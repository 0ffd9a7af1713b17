// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using model::v1::InterAnswer;
using model::v1::IntraAnswer;

constexpr double kMustWeight = 2;
constexpr double kShouldWeight = 1;

// The sentences of an entry of either answer.
template <typename Entry>
void AddSentences(const Entry& entry, v1::SentenceScope scope, const std::vector<std::string>& subjects,
                  const ObjectWords& words, v1::ConstraintList& list) {
  for (const std::string& text : entry.must()) AddSentence(words.InWords(text), scope, kMustWeight, subjects, list);
  for (const std::string& text : entry.should()) AddSentence(words.InWords(text), scope, kShouldWeight, subjects, list);
}

void AddIntra(const IntraAnswer& answer, const std::vector<ObjectGroup>& groups, const ObjectWords& words,
              v1::ConstraintList& list) {
  for (const model::v1::ObjectSentencesAnswer& object : answer.objects()) {
    AddSentences(object, v1::SENTENCE_SCOPE_INTRA, IdsOf(object.object(), groups), words, list);
  }
}

void AddInter(const InterAnswer& answer, const std::vector<ObjectGroup>& groups, const ObjectWords& words,
              v1::ConstraintList& list) {
  for (const model::v1::PairAnswer& pair : answer.constraints()) {
    std::vector<std::string> subjects;
    for (const std::string& name : pair.objects()) {
      for (std::string& id : IdsOf(name, groups)) subjects.push_back(std::move(id));
    }
    AddSentences(pair, v1::SENTENCE_SCOPE_INTER, subjects, words, list);
  }
}

// The handbook's sentences of a scope.
void AddUsual(const v1::ConstraintList& usual, v1::SentenceScope scope, v1::ConstraintList& list) {
  for (const v1::Sentence& sentence : usual.sentences()) {
    if (sentence.scope() == scope) AddSentence(sentence, list);
  }
}

// OK when there are answers to go on with: all, or one where the handbook may stand in for the other.
absl::Status FailureOf(const std::vector<absl::StatusOr<llm::Reply>>& replies, const llm::Conversation& conversation) {
  absl::Status failure;
  size_t failed = 0;
  for (const absl::StatusOr<llm::Reply>& reply : replies) {
    if (reply.ok()) continue;
    if (!conversation.MayStandIn(reply.status())) return reply.status();
    failure = failure.ok() ? reply.status() : BothFailed(failure, reply.status());
    ++failed;
  }
  return failed == replies.size() ? failure : absl::OkStatus();
}

// A sentence with an object that there is not is of no use.
std::vector<llm::Fault> CheckInter(const InterAnswer& answer) {
  std::vector<llm::Fault> faults;
  for (int i = 0; i < answer.constraints_size(); ++i) {
    const auto& objects = answer.constraints(i).objects();
    if (std::ranges::find(objects, "") == objects.end()) continue;
    faults.push_back({fmt::format("constraints[{}]", i), "names an object that is not there"});
  }
  return faults;
}

}  // namespace

absl::StatusOr<v1::ConstraintList> AskConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const ModelTools& tools, llm::Conversation& conversation) {
  ASSIGN_OR_RETURN(const v1::ConstraintList usual,
                   ListConstraints(request.brief, request.room, request.zones, objects, tools.handbook));
  const std::vector<ObjectGroup> groups = GroupObjects(objects, /*floor_only=*/true);
  v1::ConstraintList list;
  if (!groups.empty()) {
    llm::PromptValues values = {{"brief", llm::QuoteData(request.brief.text())},
                                {"room", RoomText(request.room)},
                                {"objects", GroupsText(groups)}};
    std::vector<llm::Question> questions;
    questions.push_back(MakeQuestion(tools, "constraints.intra", "intra", values, IntraAnswer::default_instance()));
    questions.back().choices["flair.model.v1.ObjectSentencesAnswer.object"] = GroupChoices(groups);
    if (groups.size() > 1 || groups.front().objects.size() > 1) {
      values["room"] = ShortRoomText(request.room);
      questions.push_back(MakeQuestion(tools, "constraints.inter", "inter", values, InterAnswer::default_instance()));
      questions.back().choices["flair.model.v1.PairAnswer.objects"] = GroupChoices(groups);
      questions.back().check = llm::CheckOf<InterAnswer>([](InterAnswer& answer) { return CheckInter(answer); });
    }
    const std::vector<absl::StatusOr<llm::Reply>> replies = conversation.AskAll(questions);
    RETURN_IF_ERROR(FailureOf(replies, conversation));
    const ObjectWords words(objects, request.room);
    for (size_t i = 0; i < replies.size(); ++i) {
      if (!replies[i].ok()) {
        AddUsual(usual, i == 0 ? v1::SENTENCE_SCOPE_INTRA : v1::SENTENCE_SCOPE_INTER, list);
        AddStandIn(replies[i].status(), list);
        continue;
      }
      if (i == 0) AddIntra(replies[i]->As<IntraAnswer>(), groups, words, list);
      if (i == 1) AddInter(replies[i]->As<InterAnswer>(), groups, words, list);
      AddFaults(questions[i].step, replies[i]->faults, list);
    }
    if (list.sentences().empty()) {
      return absl::DataLossError(
          "step \"constraints\": the model's answers have no usable sentence, also after a repair");
    }
  }
  AddPlacements(objects, usual, list);
  RETURN_IF_ERROR(CheckResult("constraints", Validate(list, objects)));
  return list;
}

}  // namespace flair::language
