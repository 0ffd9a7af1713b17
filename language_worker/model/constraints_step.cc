// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/constraints_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "flair/model/v1/constraint_answers.pb.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/model/furniture_index.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

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
    if (std::find(objects.begin(), objects.end(), "") == objects.end()) continue;
    faults.push_back({fmt::format("constraints[{}]", i), "names an object that is not there"});
  }
  return faults;
}

// In all; a solver does not get better by more, and each has its price.
constexpr int kMostSentences = 600;
constexpr double kPlacementWeight = 1;

// The sentences of a list that place a tertiary: those that name it first.
std::vector<v1::Sentence> PlacingSentences(const v1::Object& object, const v1::ConstraintList& list) {
  std::vector<v1::Sentence> placing;
  for (const v1::Sentence& sentence : list.sentences()) {
    const bool first = !sentence.subject_ids().empty() && sentence.subject_ids(0) == object.id();
    if (sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY && first) placing.push_back(sentence);
  }
  return placing;
}

// Whether a list says something about an object, by its id or by its name.
bool Mentions(const v1::ConstraintList& list, const v1::Object& object) {
  const std::string name = PlainName(object.name());
  return std::any_of(list.sentences().begin(), list.sentences().end(), [&](const v1::Sentence& sentence) {
    const auto& ids = sentence.subject_ids();
    if (!ids.empty()) return std::find(ids.begin(), ids.end(), object.id()) != ids.end();
    return PlainName(sentence.text()).find(name) != std::string::npos;
  });
}

// The usual list with the placements of the tertiaries that their lister placed in the stead of its own.
v1::ConstraintList WithPlacements(const v1::ObjectList& objects, const v1::ConstraintList& usual) {
  const bool placed = std::any_of(objects.objects().begin(), objects.objects().end(), [](const v1::Object& object) {
    return object.role() == v1::OBJECT_ROLE_TERTIARY && !object.placement().empty();
  });
  if (!placed) return usual;
  v1::ConstraintList list;
  for (const v1::Sentence& sentence : usual.sentences()) {
    if (sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY) continue;
    *list.add_sentences() = sentence;
    list.mutable_sentences(list.sentences_size() - 1)->set_id(fmt::format("s{}", list.sentences_size()));
  }
  AddPlacements(objects, usual, list);
  *list.mutable_diagnostics() = usual.diagnostics();
  return list;
}

}  // namespace

absl::StatusOr<v1::ConstraintList> AskConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const ModelTools& tools, llm::Conversation& conversation) {
  const absl::StatusOr<v1::ConstraintList> usual =
      ListConstraints(request.brief, request.room, request.zones, objects, tools.handbook);
  if (!usual.ok()) return usual.status();
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
        AddUsual(*usual, i == 0 ? v1::SENTENCE_SCOPE_INTRA : v1::SENTENCE_SCOPE_INTER, list);
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
  AddPlacements(objects, *usual, list);
  if (absl::Status status = Validate(list, objects); !status.ok()) return UnusableResult("constraints", status);
  return list;
}

void AddSentence(const std::string& text, v1::SentenceScope scope, double weight,
                 const std::vector<std::string>& subjects, v1::ConstraintList& list) {
  if (text.empty() || list.sentences_size() >= kMostSentences) return;
  v1::Sentence& sentence = *list.add_sentences();
  sentence.set_id(fmt::format("s{}", list.sentences_size()));
  sentence.set_text(text);
  sentence.set_scope(scope);
  sentence.set_weight(weight);
  for (const std::string& id : subjects) {
    const auto& there = sentence.subject_ids();
    if (std::find(there.begin(), there.end(), id) == there.end()) sentence.add_subject_ids(id);
  }
}

void AddSentence(const v1::Sentence& sentence, v1::ConstraintList& list) {
  AddSentence(sentence.text(), sentence.scope(), sentence.weight(),
              {sentence.subject_ids().begin(), sentence.subject_ids().end()}, list);
}

void AddPlacements(const v1::ObjectList& objects, const v1::ConstraintList& usual, v1::ConstraintList& list) {
  for (const v1::Object& object : objects.objects()) {
    if (object.role() != v1::OBJECT_ROLE_TERTIARY) continue;
    if (object.placement().empty()) {
      for (const v1::Sentence& sentence : PlacingSentences(object, usual)) AddSentence(sentence, list);
      continue;
    }
    std::vector<std::string> subjects = {object.id()};
    if (!object.host_id().empty()) subjects.push_back(object.host_id());
    AddSentence(object.placement(), v1::SENTENCE_SCOPE_TERTIARY, kPlacementWeight, subjects, list);
  }
}

absl::StatusOr<v1::ConstraintList> UsualConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                    const Handbook& handbook) {
  const absl::StatusOr<v1::ConstraintList> usual =
      ListConstraints(request.brief, request.room, request.zones, objects, handbook);
  if (!usual.ok()) return usual.status();
  return WithPlacements(objects, *usual);
}

absl::StatusOr<v1::ConstraintList> OwnConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const Handbook& handbook) {
  v1::ConstraintList list = request.brief.constraint_list();
  ASSIGN_OR_RETURN(const v1::ConstraintList usual, UsualConstraints(request, objects, handbook));
  std::set<std::string> ids;
  for (const v1::Sentence& sentence : list.sentences()) ids.insert(sentence.id());
  int added = 0;
  for (const v1::Object& object : objects.objects()) {
    const bool unplaced = request.brief.has_object_list() && object.placement().empty();
    if (object.role() != v1::OBJECT_ROLE_TERTIARY || unplaced || Mentions(request.brief.constraint_list(), object))
      continue;
    for (const v1::Sentence& sentence : PlacingSentences(object, usual)) {
      v1::Sentence& made = *list.add_sentences();
      made = sentence;
      std::string id = fmt::format("t{}", ++added);
      while (!ids.insert(id).second) id = fmt::format("t{}", ++added);
      made.set_id(id);
    }
  }
  if (added > 0) {
    AddDiagnostic(
        v1::SEVERITY_NOTE, "placements_added",
        "What the brief's own constraints do not mention on walls, ceiling and tops goes where it usually does.", list);
  }
  return list;
}

}  // namespace flair::language
