// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rule_book.h"

#include <algorithm>

namespace flair::translator {

const RuleBook& RuleBook::Get() {
  static const RuleBook* const book = new RuleBook;
  return *book;
}

RuleBook::RuleBook() {
  for (const auto family : {&PathRules, &WalkwayRules, &HangingRules, &SurfaceRules, &GroupRules, &RoomRules,
                            &WallRules, &FeatureRules, &AngleRules, &InFrontRules, &FrontRules, &AccessRules,
                            &SpaceRules, &PullOutRules, &FeatureNearRules, &NearRules, &DistanceRules}) {
    for (const Rule& rule : family()) {
      rules_.push_back(rule);
      patterns_.emplace_back(rule.pattern);
      std::vector<Lemmas>& required = required_.emplace_back();
      for (const std::vector<std::string>& choice : patterns_.back().RequiredWords()) {
        Lemmas bits;
        for (const std::string& lemma : choice) bits.set(bits_.try_emplace(lemma, bits_.size()).first->second);
        required.push_back(bits);
      }
    }
  }
}

RuleBook::Lemmas RuleBook::Among(std::span<const Term> terms) const {
  Lemmas lemmas;
  for (const Term& term : terms) {
    const auto bit = bits_.find(term.lemma);
    if (bit != bits_.end()) lemmas.set(bit->second);
  }
  return lemmas;
}

RuleBook::Hit RuleBook::Find(std::span<const Term> terms) const {
  Hit best;
  const Lemmas present = Among(terms);
  for (size_t i = 0; i < rules_.size(); ++i) {
    const bool possible = std::all_of(required_[i].begin(), required_[i].end(),
                                      [&](const Lemmas& choice) { return (choice & present).any(); });
    if (!possible) continue;
    const Match match = patterns_[i].At(terms);
    if (match.length > best.match.length) best = {&rules_[i], match};
  }
  return best;
}

}  // namespace flair::translator
