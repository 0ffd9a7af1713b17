// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/clean_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

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
    to.clear_meaning();
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

namespace {

using Kind = Stance::Kind;
using Parts = std::optional<std::pair<std::string, std::string>>;

bool IsLetterAt(std::string_view text, std::size_t i) {
  return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
}

bool StartsWithWord(std::string_view text, std::string_view word) {
  return text.starts_with(word) && !IsLetterAt(text, word.size());
}

std::string Sentence(std::string text) {
  while (!text.empty() && std::string_view(" ,;.").find(text.back()) != std::string_view::npos) text.pop_back();
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

// "… doors or windows …"
Parts SplitOpenings(const std::string& text) {
  constexpr std::array<std::array<std::string_view, 2>, 4> kNouns = {
      {{"doors", "windows"}, {"windows", "doors"}, {"door", "window"}, {"window", "door"}}};
  for (const auto& [first, second] : kNouns) {
    for (const std::string& joint : WordsOf("joints_of_openings")) {
      const std::string both = std::string(first) + " " + joint + " " + std::string(second);
      const std::size_t at = text.find(both);
      if (at == std::string::npos || IsLetterAt(text, at + both.size())) continue;
      const auto with = [&](std::string_view noun) { return std::string(text).replace(at, both.size(), noun); };
      return std::pair(with(first), with(second));
    }
  }
  return std::nullopt;
}

// Where the first word or phrase of a list stands in a clause, between spaces, and where it ends; of two at one place
// the longer.
std::pair<std::size_t, std::size_t> FirstOf(std::string_view list, std::string_view clause) {
  std::pair<std::size_t, std::size_t> first = {std::string_view::npos, 0};
  for (const std::string& words : WordsOf(list)) {
    const std::size_t at = clause.find(" " + words + " ");
    if (at == std::string_view::npos || at > first.first) continue;
    first = {at, std::max(at == first.first ? first.second : 0, at + words.size() + 2)};
  }
  return first;
}

Parts SplitClauses(const std::string& text) {
  if (const std::size_t semicolon = text.find("; "); semicolon != std::string::npos) {
    return std::pair(Sentence(text.substr(0, semicolon)), Sentence(text.substr(semicolon + 2)));
  }
  for (std::size_t at = text.find(" and "); at != std::string::npos; at = text.find(" and ", at + 1)) {
    const std::string_view rest = std::string_view(text).substr(at + 5);
    const std::string left = text.substr(0, at);
    const auto begins = [&](std::string_view list) {
      return std::ranges::any_of(WordsOf(list), [&](const std::string& one) { return StartsWithWord(rest, one); });
    };
    // Who the sentence is about, or that with the copula, "The desk is ", to which a place can be added.
    const std::size_t subject = FirstOf("sentence_verbs", left).first;
    if (subject != std::string::npos && begins("sentence_verbs")) {
      return std::pair(Sentence(left), Sentence(left.substr(0, subject) + " " + std::string(rest)));
    }
    const auto [copula, end] = FirstOf("copulas", left);
    if (copula != std::string::npos && begins("places_in_clauses")) {
      return std::pair(Sentence(left), Sentence(left.substr(0, end) + std::string(rest)));
    }
  }
  return std::nullopt;
}

bool SaysAny(const std::vector<Token>& tokens, std::string_view list) {
  return std::ranges::any_of(PhrasesOf(list), [&](const Phrase& phrase) { return phrase.Occurs(tokens); });
}

// A feature or wall that the sentence names; "wall" for walls in general.
std::string FeatureOf(const std::vector<Token>& tokens) {
  for (const std::string& feature : WordsOf("features_of_rooms")) {
    if (Phrase(feature).Occurs(tokens)) return feature;
  }
  return "";
}

double FirstNumber(const std::vector<Token>& tokens, double otherwise) {
  const auto number = std::ranges::find(tokens, Token::Kind::kNumber, &Token::kind);
  return number == tokens.end() ? otherwise : number->number;
}

Kind KindOf(const std::vector<Token>& tokens, const std::string& feature) {
  const bool denied = SaysAny(tokens, "denials");
  const bool of_walls = feature.ends_with("wall");
  if (SaysAny(tokens, "middle_of_the_room")) return Kind::kCentral;
  if (SaysAny(tokens, "in_a_corner")) return denied ? Kind::kNone : Kind::kInCorner;
  if (of_walls && Phrase("against").Occurs(tokens)) return denied ? Kind::kOffWalls : Kind::kAtWall;
  if (SaysAny(tokens, "away_from")) return denied ? Kind::kNone : of_walls ? Kind::kOffWalls : Kind::kAway;
  if (of_walls) return Kind::kNone;
  if (SaysAny(tokens, "near_it")) return denied ? Kind::kAway : Kind::kNear;
  if (SaysAny(tokens, "facing_it")) return denied ? Kind::kNotFacing : Kind::kFacing;
  return Kind::kNone;
}

bool OffTheWalls(Kind kind) { return kind == Kind::kCentral || kind == Kind::kOffWalls; }
bool AtTheWalls(Kind kind) { return kind == Kind::kAtWall || kind == Kind::kInCorner; }

}  // namespace

std::vector<std::string> SplitStatements(const std::string& text) {
  Parts parts = SplitOpenings(text);
  if (!parts) parts = SplitClauses(text);
  if (!parts || parts->first.size() < 3 || parts->second.size() < 3) return {text};
  std::vector<std::string> statements = SplitStatements(parts->first);
  for (std::string& more : SplitStatements(parts->second)) statements.push_back(std::move(more));
  return statements;
}

Stance StanceOf(const v1::Sentence& sentence) {
  // Distances of words without a number, as the optimizer takes them.
  constexpr double kNearFeatureM = 0.5, kNearObjectM = 3, kAwayM = 2;
  const std::vector<Token> tokens = TokensOf(sentence.text());
  const std::string feature = FeatureOf(tokens);
  Stance stance;
  stance.kind = KindOf(tokens, feature);
  if (sentence.subject_ids_size() == 0 || stance.kind == Kind::kNone) return Stance();
  const bool pair = sentence.subject_ids_size() > 1;
  stance.subject = sentence.subject_ids(0);
  stance.partner = pair ? sentence.subject_ids(1) : feature;
  for (const char* side : {"left", "right"}) {
    if (stance.kind == Kind::kAtWall && Phrase(side).Occurs(tokens)) stance.side = side;
  }
  if (stance.kind == Kind::kNear) stance.distance_m = FirstNumber(tokens, pair ? kNearObjectM : kNearFeatureM);
  if (stance.kind == Kind::kAway) stance.distance_m = FirstNumber(tokens, kAwayM);
  return stance;
}

bool Contradict(const Stance& a, const Stance& b) {
  if (a.kind == Kind::kNone || b.kind == Kind::kNone || a.subject != b.subject) return false;
  if ((AtTheWalls(a.kind) && OffTheWalls(b.kind)) || (AtTheWalls(b.kind) && OffTheWalls(a.kind))) return true;
  const bool named = a.partner != "wall" && b.partner != "wall";
  if (a.kind == Kind::kAtWall && b.kind == Kind::kAtWall) return named && a.partner != b.partner && a.side == b.side;
  if (a.partner != b.partner || a.partner.empty()) return false;
  const auto either = [&](Kind first, Kind second) {
    return (a.kind == first && b.kind == second) || (a.kind == second && b.kind == first);
  };
  if (either(Kind::kFacing, Kind::kNotFacing)) return true;
  if (!either(Kind::kNear, Kind::kAway)) return false;
  const double most_m = a.kind == Kind::kNear ? a.distance_m : b.distance_m;
  const double least_m = a.kind == Kind::kAway ? a.distance_m : b.distance_m;
  return least_m > most_m;
}

}  // namespace flair::language
