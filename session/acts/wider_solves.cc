// SPDX-License-Identifier: GPL-3.0-or-later
// Acts on what is asked are tried with more and more freedom: a resolve alone moves only what an edit names.
#include <algorithm>
#include <iterator>
#include <utility>

#include "fmt/format.h"
#include "optimizer_worker/stages/infeasible.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/comparing.h"
#include "session/layouts/edits.h"
#include "session/layouts/placing.h"
#include "session/sentences/names.h"
#include "session/sentences/sentences.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// Above all that a page lets weigh, to learn what gives way.
constexpr double kAboveAll = 100;

// The edits, and as many more that change nothing but let these objects move and count what speaks of them alone.
EditList Freeing(const EditList& edits, const v1::LayoutGraph& graph, const IdSet& free) {
  EditList all = edits;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const IdSet named = ObjectsOf(edge, graph);
    if (named.empty() || !std::ranges::includes(free, named)) continue;
    v1::SetEdgeWeight& same = *all.Add()->mutable_set_edge_weight();
    same.set_edge_id(edge.id());
    same.set_weight(edge.weight());
  }
  for (const std::string& id : free) all.Add()->mutable_resize_object()->set_object_id(id);
  return all;
}

v1::SolvedLayout Without(v1::SolvedLayout layout, const IdSet& ids) {
  EraseIf(*layout.mutable_placements(), [&](const v1::Placement& at) { return ids.contains(at.object_id()); });
  return layout;
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::SolvedAround(const v1::SolvedLayout& from, const IdSet& free,
                                               CallContext& call) const {
  v1::SolveRequest request;
  *request.mutable_layout_graph() = from.graph();
  // What has no place gets none by being in the way of nobody.
  optimizer::IdSet absent;
  for (const v1::Object& object : from.graph().object_list().objects()) {
    if (PlaceOf(from, object.id()) == nullptr) absent.insert(object.id());
  }
  if (!absent.empty()) optimizer::RemoveObjects(absent, *request.mutable_layout_graph());
  request.mutable_layout_graph()->clear_pinned_placements();
  for (const v1::Placement& at : from.placements()) {
    if (!free.contains(at.object_id())) *request.mutable_layout_graph()->add_pinned_placements() = at;
  }
  ASSIGN_OR_RETURN(v1::SolveResponse response, stages_.Solve(std::move(request), call));
  Acted acted;
  acted.layout = from;
  acted.layout.mutable_placements()->Swap(response.mutable_solved_layout()->mutable_placements());
  ASSIGN_OR_RETURN(acted.layout, Evaluated(std::move(acted.layout), call));
  acted.producer = response.producer();
  return acted;
}

absl::Status LayoutActs::PutBack(const v1::SolvedLayout& before, const Aim& aim, Acted& acted,
                                 CallContext& call) const {
  constexpr int kMost = 12;
  const v1::SolvedLayout measure = aim.mends_all ? Flawless() : before;
  int tries = 0;
  for (const std::string& id : MovedIds(before, acted.layout)) {
    const v1::Placement* const from = PlaceOf(before, id);
    if (from == nullptr || aim.object_ids.contains(id) || ++tries > kMost) continue;
    v1::SolvedLayout back = acted.layout;
    google::protobuf::RepeatedPtrField<v1::Placement> place;
    *place.Add() = *from;
    RETURN_IF_ERROR(Place(back, place, "placements"));
    ASSIGN_OR_RETURN(back, Evaluated(std::move(back), call));
    const auto better = aim.mends_all ? HoldsMore : IsBetter;
    if (!better(acted.layout, back, measure)) acted.layout = std::move(back);
  }
  return absl::OkStatus();
}

absl::StatusOr<Acted> LayoutActs::Tried(const Standing& standing, const EditList& edits, const Aim& aim,
                                        CallContext& call) const {
  // Who asks something of a piece that was moved by hand wants it to move.
  EditList pending;
  for (const v1::LayoutEdit& edit : standing.pending) {
    if (!edit.has_move_object() || !aim.object_ids.contains(edit.move_object().object_id())) *pending.Add() = edit;
  }
  const Standing now{standing.shown, standing.settled, pending, standing.by_hand};
  ASSIGN_OR_RETURN(Acted best, Solved(now, edits, call));
  return Widened(std::move(best), now, edits, aim, call);
}

absl::StatusOr<Acted> LayoutActs::Widened(Acted best, const Standing& now, const EditList& edits, const Aim& aim,
                                          CallContext& call) const {
  const v1::SolvedLayout measure = aim.mends_all ? Flawless() : now.shown;
  const auto holds = [&] {
    return WhyUnmet(best.layout, aim.sentence_ids).empty() && !IsWorseOff(best.layout, measure);
  };
  const auto keep = [&](absl::StatusOr<Acted> other) {
    if (!other.ok()) return;
    const auto better = aim.mends_all ? HoldsMore : IsBetter;
    if (better(other->layout, best.layout, measure)) best = *std::move(other);
  };
  if (!holds()) {
    const v1::SolvedLayout first = best.layout;
    IdSet about = aim.object_ids, free = ObjectsOf(aim.sentence_ids, first.graph());
    free.insert(about.begin(), about.end());
    free = InReach(first, free);
    for (IdSet* const ids : {&about, &free}) {
      std::erase_if(*ids, [&](const std::string& id) { return PlaceOf(first, id) == nullptr; });
    }
    IdSet held = IdsOf(first.graph().pinned_placements());
    held.insert(best.by_hand.begin(), best.by_hand.end());
    for (const EditList* moves : {&now.pending, &edits}) {
      for (const v1::LayoutEdit& edit : *moves) held.insert(edit.move_object().object_id());
    }
    for (IdSet* const ids : {&about, &free}) {
      for (const std::string& id : held) ids->erase(id);
    }
    const auto around = [&](const IdSet& ids) {
      absl::StatusOr<Acted> solved = SolvedAround(first, ids, call);
      if (solved.ok()) solved->by_hand = best.by_hand;
      return solved;
    };
    keep(around(about));
    const bool enough = !aim.others_may_move && !HasMoreFaults(best.layout, now.shown) &&
                        WhyUnmet(best.layout, OfRoom(aim.sentence_ids, best.layout.graph())).empty();
    if (!holds() && !enough && now.settled != nullptr) {
      const EditList freeing = Freeing(edits, first.graph(), free);
      keep(Solved(now, freeing, call));
      if (!holds()) {
        const v1::SolvedLayout without = Without(*now.settled, about);
        EditList placing = edits;
        for (const std::string& id : about) placing.Add()->mutable_resize_object()->set_object_id(id);
        keep(Solved({now.shown, &without, now.pending, now.by_hand}, placing, call));
      }
    }
    if (!holds() && !enough) keep(around(free));
    RETURN_IF_ERROR(PutBack(now.shown, aim, best, call));
    best.moved_ids = MovedIds(now.shown, best.layout);
  }
  return best;
}

absl::StatusOr<std::string> LayoutActs::WhyNot(const v1::SolvedLayout& layout, const Aim& aim,
                                               CallContext& call) const {
  v1::SolvedLayout wished = layout;
  for (v1::ConstraintEdge& edge : *wished.mutable_graph()->mutable_edges()) {
    if (aim.sentence_ids.contains(edge.sentence_id())) edge.set_weight(kAboveAll);
  }
  IdSet about = ObjectsOf(aim.sentence_ids, layout.graph());
  about.insert(aim.object_ids.begin(), aim.object_ids.end());
  ASSIGN_OR_RETURN(const Acted then, SolvedAround(wished, InReach(layout, about), call));
  if (!WhyUnmet(then.layout, aim.sentence_ids).empty()) return "no place was found where it holds, whatever gives way";
  const std::vector<std::string> moved = MovedIds(layout, then.layout);
  std::string locked;
  for (const v1::Placement& pin : layout.graph().pinned_placements()) {
    if (std::ranges::find(moved, pin.object_id()) == moved.end()) continue;
    locked += fmt::format("{}the {} is locked", locked.empty() ? "" : ", ", NameOf(layout, pin.object_id()));
  }
  if (!locked.empty()) return locked;
  IdSet broken;
  const IdSet before = UnmetSentences(layout);
  std::ranges::set_difference(UnmetSentences(then.layout), before, std::inserter(broken, broken.end()));
  const std::string texts = QuotedTexts(layout.graph(), broken);
  if (!texts.empty()) return fmt::format("{} {} against it", texts, broken.size() == 1 ? "stands" : "stand");
  return "the ways through the room would suffer";
}

}  // namespace flair::session
