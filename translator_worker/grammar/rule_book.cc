// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rule_book.h"

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
    }
  }
}

RuleBook::Hit RuleBook::Find(std::span<const Term> terms) const {
  Hit best;
  for (size_t i = 0; i < rules_.size(); ++i) {
    const Match match = patterns_[i].At(terms);
    if (match.length > best.match.length) best = {&rules_[i], match};
  }
  return best;
}

}  // namespace flair::translator
