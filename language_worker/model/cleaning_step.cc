// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "llm/answers/read_answer.h"
#include "room/validation/validate.h"
#include "worker_runtime/text/counted.h"

namespace flair::language {
namespace {

using llm::Fault;
using model::v1::ChangeAnswer;
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
    made.clear_meaning();
    made.set_id(NewId(change.from.front()));
    made.clear_made_from_ids();
    for (const std::string& id : change.from) {
      const v1::Sentence& from = *sentences_.at(id);
      made.add_made_from_ids(id);
      made.set_weight(std::max(made.weight(), from.weight()));
      for (const std::string& subject : from.subject_ids()) {
        const auto& there = made.subject_ids();
        if (std::ranges::find(there, subject) == there.end()) made.add_subject_ids(subject);
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

// "s1, s2 and s3" as words.
std::vector<std::string> WordsOf(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : std::string(text) + " ") {
    const bool within = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (within) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

// What stands in "none(why)" and its like; nothing for a sentence.
std::optional<std::string> RemovalReason(std::string_view text) {
  constexpr std::string_view kAround = " \t.,;:-()[]\"'`";
  text.remove_prefix(std::min(text.find_first_not_of(kAround), text.size()));
  const size_t end = std::min(text.find_first_of(" \t:()-,."), text.size());
  static constexpr std::array<std::string_view, 8> kNone = {"",     "none",   "null",    "nothing",
                                                            "goes", "remove", "removed", "delete"};
  const std::string word = llm::Bare(text.substr(0, end));
  if (std::ranges::find(kNone, word) == kNone.end()) return std::nullopt;
  // A sentence may begin so: "Nothing stands before the door."
  if (word == "nothing" && end < text.size() && text[end] == ' ') return std::nullopt;
  text.remove_prefix(end);
  const size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(kAround) - first + 1));
}

class Reader {
 public:
  explicit Reader(const SentenceIndex& sentences) : sentences_(sentences) {
    for (const auto& [id, sentence] : sentences) ids_.names.push_back(id);
  }

  // What is wrong with an element; else takes it.
  std::string Add(const ChangeAnswer& answer) {
    Change change;
    for (const std::string& word : WordsOf(answer.from())) {
      const std::optional<std::string> id = llm::FindChoice(word, ids_);
      if (!id && word == "and") continue;
      if (!id) return fmt::format("names {}, which is no sentence of the list", llm::Quoted(word));
      if (std::ranges::find(change.from, *id) == change.from.end()) change.from.push_back(*id);
    }
    if (change.from.empty()) return "names no sentence; its id before a colon would be right";
    for (const std::string& text : answer.to()) {
      if (std::optional<std::string> reason = RemovalReason(text)) {
        if (change.reason.empty()) change.reason = *std::move(reason);
      } else {
        change.to.push_back(text);
      }
    }
    const v1::SentenceScope scope = sentences_.at(change.from.front())->scope();
    for (const std::string& id : change.from) {
      if (sentences_.at(id)->scope() != scope) return "joins sentences about one object with others about several";
    }
    if (change.from.size() > 1 && change.to.size() > 1) {
      return "makes several sentences of several; one of them, or several of one, would be right";
    }
    return Join(std::move(change));
  }

  std::vector<Change> TakeChanges() {
    std::erase_if(changes_, [&](const Change& change) {
      return change.from.size() == 1 && change.to.size() == 1 &&
             change.to.front() == sentences_.at(change.from.front())->text();
    });
    return std::move(changes_);
  }

 private:
  // A further line about the same sentence is a further part of it.
  std::string Join(Change change) {
    constexpr size_t kMostParts = 8;
    for (const std::string& id : change.from) {
      const auto other = changed_.find(id);
      if (other == changed_.end()) continue;
      Change& first = changes_[other->second];
      if (first.from != change.from || change.from.size() > 1 || first.to.empty() || change.to.empty() ||
          first.to.size() + change.to.size() > kMostParts) {
        return fmt::format("changes {}, which another one changes", id);
      }
      for (std::string& text : change.to) first.to.push_back(std::move(text));
      return "";
    }
    for (const std::string& id : change.from) changed_[id] = changes_.size();
    changes_.push_back(std::move(change));
    return "";
  }

  const SentenceIndex& sentences_;
  llm::Choices ids_;
  std::vector<Change> changes_;
  std::map<std::string, size_t> changed_;
};

// Sentences that go without another in their place.
size_t RemovedCount(const std::vector<Change>& changes) {
  size_t count = 0;
  for (const Change& change : changes) count += change.to.empty() ? change.from.size() : 0;
  return count;
}

// What is wrong with an answer that reads well: changes that do not do what they are called, sentences changed twice.
std::vector<Fault> CheckCleaning(const SentenceIndex& sentences, const CleaningAnswer& answer) {
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

// The list after the changes of an answer from which what was wrong has been left out.
v1::ConstraintList ApplyCleaning(const v1::ConstraintList& list, const SentenceIndex& sentences,
                                 const CleaningAnswer& answer, const ObjectWords& words) {
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

}  // namespace

absl::StatusOr<v1::ConstraintList> AskCleaning(const v1::Room& room, const v1::ObjectList& objects,
                                               const v1::ConstraintList& raw, const ModelTools& tools,
                                               llm::Conversation& conversation) {
  const v1::ConstraintList list = CleanConstraints(raw);
  const SentenceIndex sentences = IndexOf(list);
  if (sentences.empty()) return list;
  llm::Question question = MakeQuestion(tools, "cleaning", "cleaning", {{"sentences", SentencesText(list)}},
                                        CleaningAnswer::default_instance());
  question.check =
      llm::CheckOf<CleaningAnswer>([&](CleaningAnswer& answer) { return CheckCleaning(sentences, answer); });
  const auto make = [&](const CleaningAnswer& answer) -> absl::StatusOr<v1::ConstraintList> {
    return ApplyCleaning(list, sentences, answer, ObjectWords(objects, room));
  };
  return AskFor<CleaningAnswer, v1::ConstraintList>(
      question, conversation, make, [&](const v1::ConstraintList& cleaned) { return Validate(cleaned, objects); });
}

SentenceIndex IndexOf(const v1::ConstraintList& list) {
  SentenceIndex index;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.scope() != v1::SENTENCE_SCOPE_TERTIARY) index[sentence.id()] = &sentence;
  }
  return index;
}

std::vector<Change> ReadChanges(const CleaningAnswer& answer, const SentenceIndex& sentences,
                                std::vector<Fault>* faults) {
  Reader reader(sentences);
  for (int i = 0; i < answer.changes_size(); ++i) {
    std::string fault = reader.Add(answer.changes(i));
    if (!fault.empty() && faults != nullptr) faults->push_back({fmt::format("changes[{}]", i), std::move(fault)});
  }
  return reader.TakeChanges();
}

}  // namespace flair::language
