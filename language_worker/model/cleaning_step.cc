// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/cleaning_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/model/cleaning_changes.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/text/counted.h"

namespace flair::language {
namespace {

using llm::Fault;
using model::v1::CleaningAnswer;
std::string SentencesText(const v1::ConstraintList& list) {
  std::string text, heading;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY) continue;
    std::string own = fmt::format("[{}]\n", fmt::join(sentence.subject_ids(), ", "));
    if (own != heading) text += own;
    heading = std::move(own);
    text += fmt::format("- {} {}\n", sentence.id(), llm::QuoteData(sentence.text()));
  }
  return text;
}

v1::CleaningAction ActionOf(const Change& change) {
  if (change.to.empty()) return v1::CLEANING_ACTION_CONTRADICTION_REMOVED;
  if (change.from.size() > 1) return v1::CLEANING_ACTION_MERGED;
  return change.to.size() > 1 ? v1::CLEANING_ACTION_SPLIT : v1::CLEANING_ACTION_SIMPLIFIED;
}

std::string ReasonOf(const Change& change) {
  if (!change.reason.empty()) return change.reason;
  switch (ActionOf(change)) {
    case v1::CLEANING_ACTION_MERGED:
      return "They say the same.";
    case v1::CLEANING_ACTION_SPLIT:
      return "It says several things, each a constraint of its own.";
    case v1::CLEANING_ACTION_SIMPLIFIED:
      return "Plainer words.";
    default:
      return "It cannot hold together with the others, or says nothing about a place.";
  }
}

class Changer {
 public:
  Changer(const v1::ConstraintList& list, const ObjectWords& words)
      : list_(list), words_(words), sentences_(IndexOf(list)) {
    for (const v1::Sentence& sentence : list.sentences()) ids_.insert(sentence.id());
    // Ids of sentences that an earlier cleaning took away stay taken.
    for (const v1::CleaningStep& step : list.cleaning_steps()) {
      ids_.insert(step.from_ids().begin(), step.from_ids().end());
      ids_.insert(step.to_ids().begin(), step.to_ids().end());
    }
  }

  v1::ConstraintList Apply(const std::vector<Change>& changes) {
    std::map<std::string, std::vector<v1::Sentence>> instead;
    std::vector<v1::CleaningStep> steps;
    for (const Change& change : changes) {
      v1::CleaningStep& step = steps.emplace_back();
      step.set_action(ActionOf(change));
      step.set_reason(ReasonOf(change));
      for (const std::string& id : change.from) {
        step.add_from_ids(id);
        instead[id];  // goes
      }
      for (const std::string& text : change.to) {
        const v1::Sentence made = Make(change, text);
        step.add_to_ids(made.id());
        instead[change.from.front()].push_back(made);
      }
    }
    v1::ConstraintList changed;
    for (const v1::Sentence& sentence : list_.sentences()) {
      const auto found = instead.find(sentence.id());
      if (found == instead.end()) {
        *changed.add_sentences() = sentence;
      } else {
        for (v1::Sentence& made : found->second) *changed.add_sentences() = std::move(made);
      }
    }
    *changed.mutable_cleaning_steps() = list_.cleaning_steps();
    for (v1::CleaningStep& step : steps) *changed.add_cleaning_steps() = std::move(step);
    *changed.mutable_diagnostics() = list_.diagnostics();
    return changed;
  }

 private:
  v1::Sentence Make(const Change& change, const std::string& text) {
    v1::Sentence made = *sentences_.at(change.from.front());
    made.set_text(words_.InWords(text));
    made.set_id(NewId(change.from.front()));
    made.clear_made_from_ids();
    for (const std::string& id : change.from) {
      const v1::Sentence& from = *sentences_.at(id);
      made.add_made_from_ids(id);
      made.set_weight(std::max(made.weight(), from.weight()));
      for (const std::string& subject : from.subject_ids()) {
        const auto& there = made.subject_ids();
        if (std::find(there.begin(), there.end(), subject) == there.end()) made.add_subject_ids(subject);
      }
    }
    return made;
  }

  // The old id with a letter, or a number, behind it.
  std::string NewId(const std::string& old_id_or_longer) {
    constexpr size_t kLongest = 58;  // leaves room for what comes behind it
    const std::string old_id = old_id_or_longer.substr(0, kLongest);
    for (int i = 0;; ++i) {
      std::string id = i < 26 ? old_id + static_cast<char>('a' + i) : fmt::format("{}_{}", old_id, i);
      if (ids_.insert(id).second) return id;
    }
  }

  const v1::ConstraintList& list_;
  const ObjectWords& words_;
  const SentenceIndex sentences_;
  std::set<std::string> ids_;
};

}  // namespace

std::vector<Fault> CheckCleaning(const v1::ConstraintList& list, const CleaningAnswer& answer) {
  const SentenceIndex sentences = IndexOf(list);
  std::vector<Fault> faults;
  const size_t removed = RemovedCount(ReadChanges(answer, sentences, &faults));
  if (2 * removed > sentences.size()) {
    faults.push_back(
        {"changes",
         fmt::format("remove {} of {} sentences; only contradictions and empty words go", removed, sentences.size()),
         llm::FaultKind::kDoubtful});
  }
  return faults;
}

v1::ConstraintList ApplyCleaning(const v1::ConstraintList& list, const CleaningAnswer& answer,
                                 const ObjectWords& words) {
  const SentenceIndex sentences = IndexOf(list);
  std::vector<Change> changes = ReadChanges(answer, sentences, nullptr);
  const size_t removed = RemovedCount(changes);
  // A model that stays with throwing most of the list away is not followed in that.
  const bool too_many = 2 * removed > sentences.size();
  if (too_many) std::erase_if(changes, [](const Change& change) { return change.to.empty(); });
  v1::ConstraintList cleaned = Changer(list, words).Apply(changes);
  if (too_many) {
    AddDiagnostic(v1::SEVERITY_WARNING, "removals_refused",
                  fmt::format("The model would have removed {} of {}; they stay.", removed,
                              Counted(static_cast<int64_t>(sentences.size()), "sentence")),
                  cleaned);
  }
  return cleaned;
}

absl::StatusOr<v1::ConstraintList> AskCleaning(const v1::Room& room, const v1::ObjectList& objects,
                                               const v1::ConstraintList& raw, const ModelTools& tools,
                                               llm::Conversation& conversation) {
  v1::ConstraintList list = CleanConstraints(raw);
  const SentenceIndex sentences = IndexOf(list);
  if (sentences.empty()) return list;
  llm::Question question = MakeQuestion(tools, "cleaning", "cleaning", {{"sentences", SentencesText(list)}},
                                        CleaningAnswer::default_instance());
  question.check = llm::CheckOf<CleaningAnswer>([&](CleaningAnswer& answer) { return CheckCleaning(list, answer); });
  const absl::StatusOr<llm::Reply> reply = conversation.Ask(question);
  if (!reply.ok()) return reply.status();
  v1::ConstraintList cleaned = ApplyCleaning(list, reply->As<CleaningAnswer>(), ObjectWords(objects, room));
  AddFaults("cleaning", reply->faults, cleaned);
  if (absl::Status status = Validate(cleaned, objects); !status.ok()) return UnusableResult("cleaning", status);
  return cleaned;
}

}  // namespace flair::language
