// SPDX-License-Identifier: GPL-3.0-or-later
// Another weight of a sentence, or none.
#include <algorithm>

#include "fmt/format.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/comparing.h"
#include "session/sentences/names.h"
#include "session/sentences/sentences.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// What does not hold of all that is said of these or of what is in their reach, but for `sentence_id`.
IdSet WaitingFor(const v1::SolvedLayout& layout, const IdSet& ids, const std::string& sentence_id) {
  const IdSet reach = InReach(layout, ids);
  IdSet waiting;
  for (const std::string& one : UnmetSentences(layout)) {
    const IdSet named = ObjectsOf({one}, layout.graph());
    const bool near = std::ranges::any_of(named, [&](const std::string& id) { return reach.contains(id); });
    if (near && one != sentence_id) waiting.insert(one);
  }
  return waiting;
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::Weigh(const Standing& standing, const v1::WeighSentence& weigh,
                                        CallContext& call) const {
  if (!(weigh.weight() >= 0 && weigh.weight() <= 100)) {
    return InvalidArgument("weigh.weight: {}; must be in [0, 100], 0 drops the sentence", weigh.weight());
  }
  EditList edits;
  double before = 0;
  for (const v1::ConstraintEdge& edge : standing.shown.graph().edges()) {
    if (edge.sentence_id() != weigh.sentence_id()) continue;
    before = std::max(before, edge.weight());
    if (weigh.weight() == 0) {
      edits.Add()->set_remove_edge_id(edge.id());
    } else {
      v1::SetEdgeWeight& set = *edits.Add()->mutable_set_edge_weight();
      set.set_edge_id(edge.id());
      set.set_weight(weigh.weight());
    }
  }
  if (edits.empty()) {
    return InvalidArgument("weigh.sentence_id: no constraint comes from a sentence \"{}\"",
                           weigh.sentence_id().substr(0, 80));
  }
  const v1::SolvedLayout& shown = standing.shown;
  const IdSet it = {weigh.sentence_id()};
  const bool held = WhyUnmet(shown, it).empty();
  Aim aim{it, ObjectsOf(it, shown.graph())};
  // What is dropped or counts no more than before makes room for others.
  const bool more = weigh.weight() > before && !held;
  if (!more) aim.sentence_ids = WaitingFor(shown, aim.object_ids, weigh.sentence_id());
  ASSIGN_OR_RETURN(Acted acted, Tried(standing, edits, aim, call));
  if (!more && !acted.moved_ids.empty()) {
    // Nothing moves for nothing.
    ASSIGN_OR_RETURN(Acted still, Unsolved(standing, edits, call));
    if (!HoldsMore(acted.layout, still.layout, shown)) {
      still.settled = standing.settled != nullptr && standing.pending.empty();
      if (still.settled) still.pending.Clear();
      acted = std::move(still);
    }
  }
  acted.label = WeighLabel(shown, weigh) + AlsoMoved(shown, acted.layout, acted.moved_ids);
  const std::string subject = aim.object_ids.empty() ? "" : *aim.object_ids.begin();
  const std::string unmet = WhyUnmet(acted.layout, aim.sentence_ids);
  const std::string of_it = QuotedTexts(shown.graph(), it);
  if (aim.sentence_ids.empty()) {
    if (!acted.moved_ids.empty()) return acted;
    const bool raised = weigh.weight() > before;
    acted.diagnostics.push_back(
        Remark(v1::SEVERITY_NOTE, "nothing_waits", subject,
               raised ? fmt::format("Nothing moves: {} holds already", of_it)
                      : fmt::format("Nothing moves: all else that is wished around here holds already")));
  } else if (!unmet.empty() && (more || acted.moved_ids.empty())) {
    ASSIGN_OR_RETURN(const std::string why, WhyNot(acted.layout, aim, call));
    acted.diagnostics.push_back(Remark(
        v1::SEVERITY_WARNING, "weighed_in_vain", subject,
        fmt::format("{} still does not hold: {}; {}", QuotedTexts(shown.graph(), aim.sentence_ids), unmet, why)));
  }
  return acted;
}

}  // namespace flair::session
