// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acts/layout_acts.h"

#include <algorithm>
#include <utility>

#include "fmt/format.h"
#include "room/validation/validate.h"
#include "session/layouts/comparing.h"
#include "session/layouts/edits.h"
#include "session/layouts/placing.h"
#include "session/sentences/answers.h"
#include "session/sentences/names.h"
#include "session/sentences/said.h"
#include "session/sentences/sentences.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// Whether an edge speaks of one of these.
bool Names(const v1::ConstraintEdge& edge, const IdSet& ids) {
  return std::ranges::any_of(TextsOf(edge), [&](const std::string& text) { return ids.contains(text); });
}

// What is to be mended beside what was solved: what does not hold and, if known, did `before`, and faults.
Aim Mending(const Acted& acted, const v1::SolvedLayout* before) {
  Aim aim;
  aim.mends_all = true;
  IdSet stays = IdsOf(acted.layout.graph().pinned_placements()), faulty;
  stays.insert(acted.by_hand.begin(), acted.by_hand.end());
  const auto gives_way = [&](const std::string& id) { return !id.empty() && !stays.contains(id); };
  const IdSet known = before == nullptr ? IdSet() : UnmetSentences(*before);
  for (const std::string& sentence : UnmetSentences(acted.layout)) {
    const IdSet about = ObjectsOf({sentence}, acted.layout.graph());
    if (!known.contains(sentence) && std::ranges::any_of(about, gives_way)) aim.sentence_ids.insert(sentence);
  }
  for (const v1::Finding& finding : acted.layout.metrics().findings()) {
    if (!finding.sentence_id().empty()) continue;
    for (const std::string& id : {finding.object_id(), finding.partner_id()}) {
      if (gives_way(id) && PlaceOf(acted.layout, id) != nullptr) aim.object_ids.insert(id);
    }
  }
  return aim;
}

// What sentences call a room's parts.
IdSet PartsOf(const v1::Room& room) {
  IdSet parts = IdsOf(room.openings());
  parts.merge(IdsOf(room.sockets()));
  for (const v1::Wall& wall : room.walls()) parts.insert(wall.name());
  return parts;
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::Move(const Standing& standing, const v1::MoveObjects& move, CallContext& call) const {
  Acted acted;
  acted.layout = standing.shown;
  RETURN_IF_ERROR(Place(acted.layout, move.placements(), "move.placements"));
  const IdSet moved = IdsOf(move.placements());
  for (v1::Placement& pin : *acted.layout.mutable_graph()->mutable_pinned_placements()) {
    if (moved.contains(pin.object_id())) pin = *PlaceOf(acted.layout, pin.object_id());
  }
  ASSIGN_OR_RETURN(acted.layout, Evaluated(std::move(acted.layout), call));
  // The last place of each object is what counts.
  for (const v1::LayoutEdit& edit : standing.pending) {
    const bool again = edit.has_move_object() && moved.contains(edit.move_object().object_id());
    if (!again) *acted.pending.Add() = edit;
  }
  for (const v1::Placement& to : move.placements()) *acted.pending.Add()->mutable_move_object() = to;
  acted.producer = ByHand();
  acted.moved_ids = MovedIds(standing.shown, acted.layout);
  acted.settled = false;
  acted.by_hand = ByHandAfter(standing.by_hand, acted.pending);
  acted.label = MoveLabel(standing.shown, move);
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Clear(const Standing& standing, CallContext& call) const {
  Acted acted;
  *acted.layout.mutable_graph()->mutable_room() = standing.shown.graph().room();
  *acted.layout.mutable_graph()->mutable_zone_plan() = standing.shown.graph().zone_plan();
  ASSIGN_OR_RETURN(acted.layout, Evaluated(std::move(acted.layout), call));
  acted.producer = ByHand();
  acted.settled = false;
  acted.anew = true;
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Edit(const Standing& standing, const v1::EditLayout& edit, CallContext& call) const {
  if (edit.edits().empty()) return absl::InvalidArgumentError("edit.edits: is empty; say what to change");
  if (edit.edits_size() > 1000) return InvalidArgument("edit.edits: {}; at most 1000 at once", edit.edits_size());
  if (std::ranges::any_of(edit.edits(), &v1::LayoutEdit::has_add_object)) return Add(standing, edit, call);
  const EditList edits = Completed(standing.shown, edit.edits());
  ASSIGN_OR_RETURN(Acted acted, RemovesAll(standing.shown, edits) ? Clear(standing, call)
                                : edit.without_solving()          ? Unsolved(standing, edits, call)
                                                                  : Solved(standing, edits, call));
  acted.label = EditLabel(standing.shown, edits);
  for (v1::Diagnostic& left : LeftBehind(standing.shown, edits)) acted.diagnostics.push_back(std::move(left));
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Settle(const Standing& standing, CallContext& call) const {
  const v1::SolvedLayout& shown = standing.shown;
  if (standing.shown.graph().object_list().objects().empty()) {
    return absl::FailedPreconditionError("settle: nothing stands in the room");
  }
  const bool again = standing.settled != nullptr && standing.pending.empty();
  EditList edits;
  if (again) {
    edits = WhatStandsBadly(shown);
    if (edits.empty()) return absl::FailedPreconditionError("everything holds: there is nothing to settle");
  }
  ASSIGN_OR_RETURN(Acted acted, Solved(standing, edits, call));
  // What held when it was settled last is to hold again; without a change since then, all that can be mended is.
  const Aim aim = Mending(acted, again || standing.settled == nullptr ? nullptr : standing.settled);
  if (!aim.sentence_ids.empty() || !aim.object_ids.empty()) {
    ASSIGN_OR_RETURN(acted, Widened(std::move(acted), standing, edits, aim, call));
  }
  acted.label = "settle";
  // Nothing moves for nothing.
  if (!acted.moved_ids.empty() && !HoldsMore(acted.layout, shown, Flawless())) {
    acted.layout = shown;
    acted.moved_ids.clear();
    acted.by_hand = standing.by_hand;
    acted.diagnostics.clear();
  }
  if (ChangesNothing(shown, acted)) {
    acted.diagnostics.push_back(WhyNothingMoves(acted.layout, acted.by_hand));
    acted.answer = acted.diagnostics.back().message();
  } else if (!acted.moved_ids.empty()) {
    const std::string left = StandingBadly(acted.layout, acted.by_hand);
    acted.answer = fmt::format("Moved {}.{}", TheOnes(acted.layout, acted.moved_ids),
                               left.empty() ? "" : fmt::format(" Still {}.", left));
  }
  return acted;
}

absl::StatusOr<EditList> LayoutActs::Overtaken(const v1::SolvedLayout& shown, const v1::EditLayout& edit,
                                               CallContext& call) const {
  v1::SolvedLayout there = shown;
  google::protobuf::RepeatedPtrField<v1::Placement> moves;
  for (const v1::LayoutEdit& one : edit.edits()) {
    if (PlaceOf(shown, one.move_object().object_id()) != nullptr) *moves.Add() = one.move_object();
  }
  const IdSet moved = IdsOf(moves);
  if (!IsSaidOf(shown.graph(), moved)) return EditList();
  RETURN_IF_ERROR(Place(there, moves, "edit.edits"));
  ASSIGN_OR_RETURN(there, Evaluated(std::move(there), call));
  return SaidOtherwise(there, moved);
}

absl::StatusOr<Acted> LayoutActs::ChangeRoom(const Standing& standing, const v1::Room& room, CallContext& call) const {
  RETURN_IF_ERROR(Validate(room));
  Acted acted;
  acted.layout = standing.shown;
  v1::LayoutGraph& graph = *acted.layout.mutable_graph();
  // What a sentence said of a wall that is gone means nothing any more.
  const IdSet left = PartsOf(room);
  IdSet gone = PartsOf(graph.room());
  for (const std::string& part : left) gone.erase(part);
  EraseIf(*graph.mutable_edges(), [&](const v1::ConstraintEdge& edge) {
    if (!Names(edge, gone)) return false;
    acted.diagnostics.push_back(
        Remark(v1::SEVERITY_NOTE, "edge_dropped", edge.id(),
               fmt::format("{} is dropped: it speaks of a wall or opening that is gone", edge.id())));
    return true;
  });
  *graph.mutable_room() = room;
  acted.layout.clear_zone_regions();
  ASSIGN_OR_RETURN(acted.layout, Evaluated(std::move(acted.layout), call));
  acted.producer = ByHand();
  // Settling goes on from here: what stands well stays.
  acted.by_hand = standing.by_hand;
  acted.settled = !acted.layout.placements().empty();
  acted.anew = !acted.settled;
  if (acted.settled) acted.pending = WhatStandsBadly(acted.layout);
  acted.label = "change the room";
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Dispatch(const Standing& standing, const v1::ActRequest& request,
                                           CallContext& call) const {
  switch (request.act_case()) {
    case v1::ActRequest::kMove: {
      ASSIGN_OR_RETURN(Acted acted, Move(standing, request.move(), call));
      const EditList overtaken = SaidOtherwise(acted.layout, IdsOf(request.move().placements()));
      Drop(overtaken, acted.layout);
      acted.pending.MergeFrom(overtaken);
      return acted;
    }
    case v1::ActRequest::kEdit: {
      v1::EditLayout edit = request.edit();
      ASSIGN_OR_RETURN(const EditList overtaken, Overtaken(standing.shown, edit, call));
      edit.mutable_edits()->MergeFrom(overtaken);
      return Edit(standing, edit, call);
    }
    case v1::ActRequest::kSettle:
      return Settle(standing, call);
    case v1::ActRequest::kSay:
      return Say(standing, request.say(), call);
    case v1::ActRequest::kWeigh:
      return Weigh(standing, request.weigh(), call);
    case v1::ActRequest::kReplace:
      return Replace(standing, request.replace(), call);
    case v1::ActRequest::kRoom:
      return ChangeRoom(standing, request.room(), call);
    default:
      return absl::InvalidArgumentError("act: is not set; say what to do");
  }
}

absl::StatusOr<Acted> LayoutActs::Act(const Standing& standing, const v1::ActRequest& request,
                                      CallContext& call) const {
  ASSIGN_OR_RETURN(Acted acted, Dispatch(standing, request, call));
  ForgetWhatIsAnswered(standing.shown.graph(), acted.layout);
  const auto name = [&](v1::Diagnostic& remark) {
    // Pieces that have gone have names as well.
    for (const v1::SolvedLayout* layout : {&std::as_const(acted.layout), &standing.shown}) {
      remark.set_message(WithNames(remark.message(), *layout));
    }
  };
  std::ranges::for_each(acted.diagnostics, name);
  std::ranges::for_each(*acted.layout.mutable_diagnostics(), name);
  return acted;
}

absl::StatusOr<v1::JudgeResponse> LayoutActs::Judge(const v1::SolvedLayout& layout, const v1::JudgeRequest& request,
                                                    CallContext& call) const {
  v1::SolvedLayout moved;
  *moved.mutable_graph() = layout.graph();
  *moved.mutable_placements() = layout.placements();
  RETURN_IF_ERROR(Place(moved, request.placements(), "placements"));
  v1::EvaluateRequest evaluate;
  evaluate.mutable_layout_graph()->Swap(moved.mutable_graph());
  evaluate.mutable_placements()->Swap(moved.mutable_placements());
  ASSIGN_OR_RETURN(v1::EvaluateResponse judged, stages_.Evaluate(std::move(evaluate), call));
  const IdSet ids = IdsOf(request.placements());
  v1::JudgeResponse response;
  for (int i = 0; i < judged.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    if (Names(layout.graph().edges(i), ids))
      *response.add_edge_outcomes() = std::move(*judged.mutable_edge_outcomes(i));
  }
  for (v1::Finding& finding : *judged.mutable_metrics()->mutable_findings()) {
    if (ids.contains(finding.object_id()) || ids.contains(finding.partner_id())) {
      *response.add_findings() = std::move(finding);
    }
  }
  response.set_reachable_floor_share(judged.metrics().reachable_floor_share());
  return response;
}

}  // namespace flair::session
