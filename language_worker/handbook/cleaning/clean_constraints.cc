// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/clean_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

std::string Capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

// The sentence without words that say nothing; nothing when there are none.
std::optional<std::string> WithoutFillers(const std::string& text) {
  constexpr std::array<std::string_view, 8> kFillers = {
      "Ensure that ", "Ensure ", "Make sure that ", "Make sure ", "Please ", "It is important that ", "- ", "* "};
  for (const std::string_view filler : kFillers) {
    if (text.size() > filler.size() && text.compare(0, filler.size(), filler) == 0)
      return Capital(text.substr(filler.size()));
  }
  return std::nullopt;
}

// "… doors or windows …" as one sentence about doors and one about windows.
std::optional<std::pair<std::string, std::string>> SplitOpenings(const std::string& text) {
  constexpr std::array<std::array<std::string_view, 2>, 2> kNouns = {{{"doors", "windows"}, {"door", "window"}}};
  for (const auto& [door, window] : kNouns) {
    for (const std::string_view joint : {" or ", " and ", " or the ", " and the ", " or any ", " nor "}) {
      for (const auto& [first, second] : {std::pair(door, window), std::pair(window, door)}) {
        const std::string both = std::string(first) + std::string(joint) + std::string(second);
        const std::size_t at = text.find(both);
        const char after = at == std::string::npos || at + both.size() >= text.size() ? '.' : text[at + both.size()];
        if (at == std::string::npos || std::isalpha(static_cast<unsigned char>(after)) != 0) continue;
        const auto with = [&](std::string_view noun) { return std::string(text).replace(at, both.size(), noun); };
        return std::pair(with(first), with(second));
      }
    }
  }
  return std::nullopt;
}

// What a sentence claims: its words without articles, and whether it denies them.
struct Claim {
  std::string words;
  bool denied = false;
};

Claim ClaimOf(const v1::Sentence& sentence) {
  static const std::set<std::string, std::less<>> kDropped = {"the", "a",   "an",     "should",     "must",
                                                              "is",  "are", "be",     "does",       "do",
                                                              "its", "it",  "placed", "positioned", "located"};
  Claim claim;
  for (const std::string& id : sentence.subject_ids()) claim.words += id + ",";
  for (const Token& token : Tokenize(sentence.text())) {
    if (token.kind == Token::Kind::kSign || kDropped.count(token.text) > 0) continue;
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
    for (const v1::Sentence& sentence : kept_) *cleaned.add_sentences() = sentence;
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

  void Split(const v1::Sentence& sentence) {
    const auto parts = SplitOpenings(sentence.text());
    if (!parts) {
      work_.push_back(sentence);
      return;
    }
    v1::CleaningStep& step = Step(v1::CLEANING_ACTION_SPLIT, "Doors and windows are two constraints.");
    step.add_from_ids(sentence.id());
    for (const std::string& text : {parts->first, parts->second}) {
      work_.push_back(Changed(sentence, text));
      step.add_to_ids(work_.back().id());
    }
  }

  // Adds a sentence to the result unless it repeats or contradicts one that is there.
  void Keep(const v1::Sentence& sentence) {
    const Claim claim = ClaimOf(sentence);
    const auto known = by_claim_.find(claim.words);
    if (known == by_claim_.end()) {
      by_claim_[claim.words] = {kept_.size(), claim.denied};
      kept_.push_back(sentence);
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
    known->second.second = claim.denied;
  }

  const v1::ConstraintList& raw_;
  std::set<std::string> ids_;
  std::vector<v1::Sentence> work_;
  std::vector<v1::Sentence> kept_;
  std::map<std::string, std::pair<std::size_t, bool>> by_claim_;
  std::vector<v1::CleaningStep> steps_;
};

}  // namespace

v1::ConstraintList CleanConstraints(const v1::ConstraintList& raw) { return Cleaner(raw).Clean(); }

}  // namespace flair::language
