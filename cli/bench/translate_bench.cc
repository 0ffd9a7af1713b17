// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/translate_bench.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

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
  return std::ranges::all_of(gold.arguments(), [&](const v1::Argument& wanted) {
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
  return std::ranges::any_of(made, [&](const v1::ConstraintEdge& edge) { return MeetsGold(edge, gold); });
}

bool IsMet(const Alternatives& alternatives, const std::vector<v1::ConstraintEdge>& made) {
  return alternatives.empty() || std::ranges::any_of(alternatives, [&](const auto& calls) {
           return std::ranges::all_of(calls, [&](const auto& gold) { return IsMade(gold, made); });
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

std::string MissText(const LabelledRoom& room, const LabelledBullet& bullet,
                     const std::vector<v1::ConstraintEdge>& made, const v1::LayoutGraph& translated) {
  std::string text = fmt::format("{} {}: {}\n", room.name, bullet.list, bullet.sentence.text());
  for (const TranslateLabel& label : bullet.labels) {
    std::string wanted;
    for (const auto& calls : label.alternatives) {
      std::vector<std::string> texts;
      for (const v1::ConstraintEdge& gold : calls) texts.push_back(CallText(gold.type(), gold.arguments()));
      wanted += fmt::format("{}{}", wanted.empty() ? "" : " or ", fmt::join(texts, " and "));
    }
    text += fmt::format("  wanted   {}\n", wanted.empty() ? "nothing" : wanted);
  }
  for (const v1::ConstraintEdge& edge : made) {
    text += fmt::format("  made     {}\n", CallText(edge.type(), edge.arguments()));
  }
  for (const v1::Diagnostic& remark : translated.diagnostics()) {
    if (remark.subject_id() != bullet.sentence.id()) continue;
    text += fmt::format("  remarked {}: {}\n", remark.code(), remark.message());
  }
  return text;
}

using Tallies = std::map<std::string, TranslateTally>;

std::vector<std::string> Cells(const std::string& name, const TranslateTally& tally) {
  std::vector<std::string> cells = {name, fmt::format("{}", tally.Total())};
  for (const int count : tally.counts) cells.push_back(fmt::format("{}", count));
  cells.push_back(fmt::format("{:.1f}", 100 * tally.CorrectShare()));
  return cells;
}

TextTable Table(const std::string& title, const Tallies& tallies) {
  size_t width = 12;
  for (const auto& [name, tally] : tallies) width = std::max(width, name.size());
  std::vector<std::string> titles = {title, "labels"};
  titles.insert(titles.end(), kTranslateOutcomes.begin(), kTranslateOutcomes.end());
  titles.emplace_back("correct %");
  return TextTable(titles, width);
}

std::string TableText(const std::string& title, const Tallies& tallies) {
  const TextTable table = Table(title, tallies);
  std::string text = table.Header();
  for (const auto& [name, tally] : tallies) text += table.Row(Cells(name, tally));
  return text + "\n";
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
  const bool stray = std::ranges::any_of(made, [&](const auto& edge) { return !IsNamed(edge, bullet); });
  if (stray) outcomes[blamed] = TranslateOutcome::kWrong;
  return outcomes;
}

void AddToScore(const LabelledRoom& room, const v1::LayoutGraph& translated, TranslateScore& score) {
  for (const LabelledBullet& bullet : room.bullets) {
    std::vector<v1::ConstraintEdge> made;
    for (const v1::ConstraintEdge& edge : translated.edges()) {
      if (edge.sentence_id() == bullet.sentence.id()) made.push_back(edge);
    }
    const bool remarked = std::ranges::any_of(translated.diagnostics(), [&](const v1::Diagnostic& remark) {
      return remark.subject_id() == bullet.sentence.id();
    });
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
    if (!right) score.misses += MissText(room, bullet, made, translated);
  }
}

v1::ConstraintCatalog TypesOfTheReference(const v1::ConstraintCatalog& catalog) {
  v1::ConstraintCatalog known = catalog;
  known.clear_types();
  for (const v1::ConstraintType& type : catalog.types()) {
    const auto known_there = [](const std::string& name) {
      return evaluation::FindFlairGptFunction(evaluation::CanonicalFlairGptName(name)) != nullptr;
    };
    const bool named = known_there(type.name()) || std::ranges::any_of(type.aliases(), known_there);
    if (named || type.built_in()) *known.add_types() = type;
  }
  return known;
}

absl::StatusOr<TranslateScore> MeasureTranslation(const std::vector<LabelledRoom>& rooms,
                                                  const v1::ConstraintCatalog& catalog,
                                                  const TranslateCall& translate) {
  TranslateScore score;
  for (const LabelledRoom& room : rooms) {
    v1::TranslateRequest request = room.request;
    request.set_request_id("bench-" + room.name);
    *request.mutable_catalog() = catalog;
    const absl::StatusOr<v1::TranslateResponse> response = translate(request);
    if (!response.ok()) return About(room.name, response.status());
    AddToScore(room, response->layout_graph(), score);
  }
  return score;
}

std::string TranslateScoreText(const TranslateScore& score, double cpu_ms) {
  std::string text = TableText("function", score.by_function) + TableText("room", score.by_room);
  const TextTable lists = Table("list", score.by_list);
  text += lists.Header();
  for (const auto& [name, tally] : score.by_list) text += lists.Row(Cells(name, tally));
  text += lists.Row(Cells("all", score.all));
  if (score.silent > 0) text += Counted(score.silent, "sentence") + " gave neither a call nor a remark\n";
  return text + fmt::format("{:.1f} % of {} labels correct, {:.3f} ms of CPU a label\n", 100 * score.all.CorrectShare(),
                            score.all.Total(), cpu_ms / std::max(1, score.all.Total()));
}

}  // namespace flair::cli
