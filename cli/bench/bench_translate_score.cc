// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_translate_score.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "cli/bench/bench_translate_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// Labels give centimetres; readers of feet come within this.
constexpr double kSameLength_m = 1e-6;

const v1::ArgumentValue* Find(const v1::ConstraintEdge& edge, const std::string& name) {
  for (const v1::Argument& argument : edge.arguments()) {
    if (argument.name() == name) return &argument.value();
  }
  return nullptr;
}

std::set<std::string> SetOf(const v1::ArgumentValue& value) {
  return {value.texts().items().begin(), value.texts().items().end()};
}

bool SameValue(const v1::ArgumentValue& made, const v1::ArgumentValue& wanted) {
  if (made.value_case() != wanted.value_case()) return false;
  switch (wanted.value_case()) {
    case v1::ArgumentValue::kText:
      return made.text() == wanted.text();
    case v1::ArgumentValue::kNumber:
      return std::abs(made.number() - wanted.number()) < kSameLength_m;
    case v1::ArgumentValue::kFlag:
      return made.flag() == wanted.flag();
    case v1::ArgumentValue::kTexts:
      return SetOf(made) == SetOf(wanted);
    default:
      return false;
  }
}

bool SameArguments(const v1::ConstraintEdge& made, const v1::ConstraintEdge& gold) {
  return std::all_of(gold.arguments().begin(), gold.arguments().end(), [&](const v1::Argument& wanted) {
    const v1::ArgumentValue* value = Find(made, wanted.name());
    if (value != nullptr) return SameValue(*value, wanted.value());
    const bool front_only = wanted.name() == "sides" && SetOf(wanted.value()) == std::set<std::string>{"front"};
    const bool denied = wanted.value().value_case() == v1::ArgumentValue::kFlag && !wanted.value().flag();
    return front_only || denied;
  });
}

v1::ConstraintEdge Swapped(v1::ConstraintEdge edge, const std::vector<std::pair<std::string, std::string>>& pairs) {
  for (v1::Argument& argument : *edge.mutable_arguments()) {
    for (const auto& [a, b] : pairs) {
      if (argument.name() == a || argument.name() == b) {
        argument.set_name(argument.name() == a ? b : a);
        break;
      }
    }
  }
  return edge;
}

bool MeansTheSameBothWays(const v1::ConstraintEdge& gold) {
  static const std::set<std::string> types = {"near", "away_from", "parallel", "perpendicular", "next_to"};
  const v1::ArgumentValue* both = Find(gold, "both");
  return types.count(gold.type()) != 0 || (gold.type() == "facing" && both != nullptr && both->flag());
}

using Alternatives = std::vector<std::vector<v1::ConstraintEdge>>;

bool IsMade(const v1::ConstraintEdge& gold, const std::vector<v1::ConstraintEdge>& made) {
  return std::any_of(made.begin(), made.end(), [&](const v1::ConstraintEdge& edge) { return MeetsGold(edge, gold); });
}

bool IsMet(const Alternatives& alternatives, const std::vector<v1::ConstraintEdge>& made) {
  return alternatives.empty() || std::any_of(alternatives.begin(), alternatives.end(), [&](const auto& calls) {
           return std::all_of(calls.begin(), calls.end(), [&](const auto& gold) { return IsMade(gold, made); });
         });
}

bool IsNamed(const v1::ConstraintEdge& edge, const LabelledBullet& bullet) {
  for (const TranslateLabel& label : bullet.labels) {
    for (const auto& calls : label.alternatives) {
      for (const v1::ConstraintEdge& gold : calls) {
        if (MeetsGold(edge, gold)) return true;
      }
    }
  }
  return false;
}

TranslateMiss MissOf(const LabelledRoom& room, const LabelledBullet& bullet,
                     const std::vector<v1::ConstraintEdge>& made, const v1::LayoutGraph& translated) {
  TranslateMiss miss{room.name, bullet.list, bullet.sentence.text(), {}, {}, {}};
  for (const TranslateLabel& label : bullet.labels) {
    std::vector<std::string> alternatives;
    for (const auto& calls : label.alternatives) {
      std::vector<std::string> texts;
      for (const v1::ConstraintEdge& gold : calls) texts.push_back(EdgeText(gold));
      alternatives.push_back(fmt::format("{}", fmt::join(texts, " and ")));
    }
    miss.wanted.push_back(alternatives.empty() ? "nothing" : fmt::format("{}", fmt::join(alternatives, " or ")));
  }
  for (const v1::ConstraintEdge& edge : made) miss.made.push_back(EdgeText(edge));
  for (const v1::Diagnostic& remark : translated.diagnostics()) {
    if (remark.subject_id() == bullet.sentence.id()) miss.remarks.push_back(remark.code() + ": " + remark.message());
  }
  return miss;
}

}  // namespace

bool MeetsGold(const v1::ConstraintEdge& made, const v1::ConstraintEdge& gold) {
  if (made.type() != gold.type()) return false;
  const bool at_wall = gold.type() == "against_wall" || gold.type() == "near_wall";
  if (at_wall && Find(gold, "side") == nullptr) {
    const v1::ArgumentValue* side = Find(made, "side");
    if (side != nullptr && side->text() != "back") return false;
  }
  if (SameArguments(made, gold)) return true;
  if (MeansTheSameBothWays(gold)) {
    return SameArguments(Swapped(made, {{"object", "target"}, {"object_side", "target_side"}}), gold);
  }
  return gold.type() == "between" && SameArguments(Swapped(made, {{"first", "second"}}), gold);
}

std::vector<TranslateOutcome> OutcomesOf(const LabelledBullet& bullet, const std::vector<v1::ConstraintEdge>& made) {
  std::vector<TranslateOutcome> outcomes;
  size_t blamed = bullet.labels.size() - 1;
  bool unmet = false;
  for (size_t i = 0; i < bullet.labels.size(); ++i) {
    const Alternatives& alternatives = bullet.labels[i].alternatives;
    outcomes.push_back(IsMet(alternatives, made) ? TranslateOutcome::kCorrect
                       : made.empty()            ? TranslateOutcome::kWronglyRefused
                                                 : TranslateOutcome::kMissed);
    if (outcomes.back() != TranslateOutcome::kCorrect && !unmet) {
      unmet = true;
      blamed = i;
    } else if (!unmet && alternatives.empty()) {
      blamed = i;
    }
  }
  const bool stray = std::any_of(made.begin(), made.end(), [&](const auto& edge) { return !IsNamed(edge, bullet); });
  if (stray) outcomes[blamed] = TranslateOutcome::kWrong;
  return outcomes;
}

void AddToScore(const LabelledRoom& room, const v1::LayoutGraph& translated, TranslateScore& score) {
  for (const LabelledBullet& bullet : room.bullets) {
    std::vector<v1::ConstraintEdge> made;
    for (const v1::ConstraintEdge& edge : translated.edges()) {
      if (edge.sentence_id() == bullet.sentence.id()) made.push_back(edge);
    }
    const bool remarked =
        std::any_of(translated.diagnostics().begin(), translated.diagnostics().end(),
                    [&](const v1::Diagnostic& remark) { return remark.subject_id() == bullet.sentence.id(); });
    score.silent += made.empty() && !remarked;
    const std::vector<TranslateOutcome> outcomes = OutcomesOf(bullet, made);
    bool right = true;
    for (size_t i = 0; i < outcomes.size(); ++i) {
      const auto outcome = static_cast<size_t>(outcomes[i]);
      right = right && outcomes[i] == TranslateOutcome::kCorrect;
      ++score.all.counts[outcome];
      ++score.by_function[bullet.labels[i].function].counts[outcome];
      ++score.by_list[bullet.list].counts[outcome];
      ++score.by_room[room.name].counts[outcome];
    }
    if (!right) score.misses.push_back(MissOf(room, bullet, made, translated));
  }
}

}  // namespace flair::cli
