// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/uses.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace flair::evaluation {
namespace {

bool IsUse(const v1::Sentence& sentence) { return sentence.use() || sentence.origin() == v1::SENTENCE_ORIGIN_IMPLIED; }

// The first call of a sentence that does not hold; null when all hold.
const v1::EdgeOutcome* Missed(const std::vector<const v1::EdgeOutcome*>& outcomes) {
  const auto missed = std::ranges::find_if(
      outcomes, [](const v1::EdgeOutcome* outcome) { return outcome->status() != v1::OUTCOME_STATUS_SATISFIED; });
  return missed == outcomes.end() ? nullptr : *missed;
}

v1::Finding NotMet(const v1::Sentence& sentence, const v1::EdgeOutcome* missed) {
  v1::Finding finding;
  finding.set_kind(v1::FINDING_KIND_USE_NOT_MET);
  if (sentence.subject_ids_size() > 0) finding.set_object_id(sentence.subject_ids(0));
  if (sentence.subject_ids_size() > 1) finding.set_partner_id(sentence.subject_ids(1));
  finding.set_sentence_id(sentence.id());
  const std::string why = missed == nullptr ? "no constraint could be made of it" : missed->reason();
  finding.set_message(why.empty() ? "\"" + sentence.text() + "\" does not hold" : why);
  if (missed != nullptr && missed->has_missed_by()) {
    finding.set_amount(missed->missed_by());
    finding.set_unit(missed->unit());
  }
  return finding;
}

}  // namespace

void AddUses(const v1::LayoutGraph& graph, const google::protobuf::RepeatedPtrField<v1::Placement>& placements,
             const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, v1::LayoutMetrics& metrics) {
  std::set<std::string_view> placed;
  for (const v1::Placement& placement : placements) placed.insert(placement.object_id());
  std::map<std::string_view, std::vector<const v1::EdgeOutcome*>> outcomes_of;
  for (int e = 0; e < std::min(graph.edges_size(), outcomes.size()); ++e) {
    outcomes_of[graph.edges(e).sentence_id()].push_back(&outcomes[e]);
  }
  int asked = 0, met = 0;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    const auto is_placed = [&](const std::string& id) { return placed.contains(id); };
    if (!IsUse(sentence) || !std::ranges::all_of(sentence.subject_ids(), is_placed)) continue;
    ++asked;
    const std::vector<const v1::EdgeOutcome*>& own = outcomes_of[sentence.id()];
    const v1::EdgeOutcome* const missed = Missed(own);
    if (!own.empty() && missed == nullptr) {
      ++met;
    } else {
      *metrics.add_findings() = NotMet(sentence, missed);
    }
  }
  metrics.set_use_count(asked);
  metrics.set_met_use_count(met);
}

}  // namespace flair::evaluation
