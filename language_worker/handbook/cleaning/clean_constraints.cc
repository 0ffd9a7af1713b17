// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/clean_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language_worker/handbook/cleaning/statements.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

std::string Capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

// The sentence without words that say nothing; nothing when there are none.
std::optional<std::string> WithoutFillers(const std::string& text) {
  for (const std::string& filler : WordsOf("openings_of_sentences")) {
    if (text.size() > filler.size() && text.starts_with(filler)) return Capital(text.substr(filler.size()));
  }
  return std::nullopt;
}

// What a sentence claims: its words without articles, and whether it denies them.
struct Claim {
  std::string words;
  bool denied = false;
};

Claim ClaimOf(const v1::Sentence& sentence) {
  Claim claim;
  for (const std::string& id : sentence.subject_ids()) claim.words += id + ",";
  for (const Token& token : TokensOf(sentence.text())) {
    if (token.kind == Token::Kind::kSign || IsIn("claim_fillers", token.text)) continue;
    if (token.text == "not" || token.text == "never") {
      claim.denied = !claim.denied;
    } else {
      claim.words += " " + token.text;
    }
  }
  return claim;
}

class Cleaner {
 public:
  explicit Cleaner(const v1::ConstraintList& raw) : raw_(raw) {
    for (const v1::Sentence& sentence : raw.sentences()) ids_.insert(sentence.id());
  }

  v1::ConstraintList Clean() {
    for (const v1::Sentence& sentence : raw_.sentences()) Simplify(sentence);
    for (const v1::Sentence& sentence : work_) Keep(sentence);
    v1::ConstraintList cleaned;
    for (const v1::Sentence& sentence : kept_) {
      if (dropped_.count(sentence.id()) == 0) *cleaned.add_sentences() = sentence;
    }
    for (const v1::CleaningStep& step : steps_) *cleaned.add_cleaning_steps() = step;
    *cleaned.mutable_diagnostics() = raw_.diagnostics();
    return cleaned;
  }

 private:
  v1::CleaningStep& Step(v1::CleaningAction action, std::string reason) {
    v1::CleaningStep& step = steps_.emplace_back();
    step.set_action(action);
    step.set_reason(std::move(reason));
    return step;
  }

  // An id that no sentence has had: the old one with a letter or number behind it.
  std::string NewId(const std::string& old_id) {
    for (int i = 0;; ++i) {
      const std::string id = i < 26 ? old_id + static_cast<char>('a' + i) : fmt::format("{}_{}", old_id, i);
      if (ids_.insert(id).second) return id;
    }
  }

  v1::Sentence Changed(const v1::Sentence& from, const std::string& text) {
    v1::Sentence to = from;
    to.set_id(NewId(from.id()));
    to.set_text(text);
    to.clear_made_from_ids();
    to.add_made_from_ids(from.id());
    return to;
  }

  void Simplify(const v1::Sentence& sentence) {
    if (const auto shorter = WithoutFillers(sentence.text())) {
      const v1::Sentence simple = Changed(sentence, *shorter);
      v1::CleaningStep& step = Step(v1::CLEANING_ACTION_SIMPLIFIED, "The opening words say nothing about the room.");
      step.add_from_ids(sentence.id());
      step.add_to_ids(simple.id());
      Split(simple);
    } else {
      Split(sentence);
    }
  }

  // [Paper] Tertiary constraints are not split: each says one thing.
  void Split(const v1::Sentence& sentence) {
    const std::vector<std::string> statements = SplitStatements(sentence.text());
    if (statements.size() < 2 || sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY) {
      work_.push_back(sentence);
      return;
    }
    v1::CleaningStep& step = Step(v1::CLEANING_ACTION_SPLIT, "It says several things, each a constraint of its own.");
    step.add_from_ids(sentence.id());
    for (const std::string& text : statements) {
      work_.push_back(Changed(sentence, text));
      step.add_to_ids(work_.back().id());
    }
  }

  // Adds a sentence to the result unless it repeats or contradicts one that is there.
  void Keep(const v1::Sentence& sentence) {
    const Claim claim = ClaimOf(sentence);
    const auto known = by_claim_.find(claim.words);
    if (known == by_claim_.end()) {
      if (!Outweighs(sentence)) return;
      by_claim_[claim.words] = {kept_.size(), claim.denied};
      kept_.push_back(sentence);
      stances_.push_back(StanceOf(sentence));
      return;
    }
    v1::Sentence& there = kept_[known->second.first];
    if (known->second.second == claim.denied) {
      v1::CleaningStep& step = Step(v1::CLEANING_ACTION_MERGED, "Both say the same.");
      step.add_from_ids(there.id());
      step.add_from_ids(sentence.id());
      step.add_to_ids(there.id());
      there.add_made_from_ids(sentence.id());
      there.set_weight(std::max(there.weight(), sentence.weight()));
      return;
    }
    const bool replaces = sentence.weight() > there.weight();
    const v1::Sentence& loser = replaces ? there : sentence;
    Step(v1::CLEANING_ACTION_CONTRADICTION_REMOVED,
         fmt::format("\"{}\" contradicts \"{}\", which matters {}.", loser.text(), (replaces ? sentence : there).text(),
                     replaces ? "more" : "at least as much"))
        .add_from_ids(loser.id());
    if (!replaces) return;
    there = sentence;
    stances_[known->second.first] = StanceOf(sentence);
    known->second.second = claim.denied;
  }

  // Settles contradictions with what is kept: true when the sentence may come in, for which weaker ones go.
  bool Outweighs(const v1::Sentence& sentence) {
    const Stance stance = StanceOf(sentence);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (Contradict(stance, stances_[i]) && kept_[i].weight() >= sentence.weight()) {
        Remove(sentence, kept_[i]);
        return false;
      }
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (!Contradict(stance, stances_[i])) continue;
      Remove(kept_[i], sentence);
      stances_[i] = Stance();
      dropped_.insert(kept_[i].id());
    }
    return true;
  }

  void Remove(const v1::Sentence& loser, const v1::Sentence& winner) {
    Step(v1::CLEANING_ACTION_CONTRADICTION_REMOVED,
         fmt::format("\"{}\" cannot hold together with \"{}\", which matters {}.", loser.text(), winner.text(),
                     winner.weight() > loser.weight() ? "more" : "at least as much"))
        .add_from_ids(loser.id());
  }

  const v1::ConstraintList& raw_;
  std::set<std::string> ids_;
  std::vector<v1::Sentence> work_;
  std::vector<v1::Sentence> kept_;
  std::vector<Stance> stances_;  // of kept_, in its order
  std::set<std::string> dropped_;
  std::map<std::string, std::pair<std::size_t, bool>> by_claim_;
  std::vector<v1::CleaningStep> steps_;
};

}  // namespace

v1::ConstraintList CleanConstraints(const v1::ConstraintList& raw) { return Cleaner(raw).Clean(); }

}  // namespace flair::language
