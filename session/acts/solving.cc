// SPDX-License-Identifier: GPL-3.0-or-later
// What every act on a layout ends in: it is evaluated, solved again, or left unsolved.
#include <algorithm>
#include <map>
#include <utility>

#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/edits.h"
#include "session/layouts/placing.h"
#include "session/sentences/names.h"
#include "session/sentences/sentences.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

v1::Point2 MiddleOf(const v1::Polygon& floor) {
  v1::Point2 middle;
  if (floor.vertices().empty()) return middle;
  const auto [west, east] = std::ranges::minmax_element(floor.vertices(), {}, &v1::Point2::x_m);
  const auto [south, north] = std::ranges::minmax_element(floor.vertices(), {}, &v1::Point2::y_m);
  middle.set_x_m((west->x_m() + east->x_m()) / 2);
  middle.set_y_m((south->y_m() + north->y_m()) / 2);
  return middle;
}

// Tells that a piece had to move although it was placed by hand, and forgets that it was; nothing when it has not
// moved.
void TellFreed(const v1::SolvedLayout& before, const std::string& id, const std::string& reason, Acted& acted) {
  const v1::Placement *was = PlaceOf(before, id), *is = PlaceOf(acted.layout, id);
  if (was != nullptr && is != nullptr && StandSame(*was, *is)) return;
  std::erase(acted.by_hand, id);
  *acted.layout.add_diagnostics() =
      Remark(v1::SEVERITY_WARNING, "hand_placed_moved", id,
             fmt::format("the {} could not stay where it was put by hand: {}", NameOf(acted.layout, id), reason));
}

}  // namespace

v1::Producer ByHand(const char* method) {
  v1::Producer producer;
  producer.set_program("flair");
  producer.set_method(method);
  producer.set_version("1");
  return producer;
}

bool ChangesNothing(const v1::SolvedLayout& before, const Acted& acted) {
  return acted.moved_ids.empty() && before.placements_size() == acted.layout.placements_size() &&
         runtime::CanonicalBytes(before.graph()) == runtime::CanonicalBytes(acted.layout.graph());
}

absl::StatusOr<v1::SolvedLayout> LayoutActs::Evaluated(v1::SolvedLayout layout, CallContext& call) const {
  v1::EvaluateResponse response;
  // An empty room is no problem for an optimizer, and all of it is in reach.
  if (layout.graph().object_list().objects().empty()) {
    response.mutable_metrics()->set_reachable_floor_share(1);
    response.mutable_metrics()->set_reachable_front_share(1);
  } else {
    v1::EvaluateRequest request;
    *request.mutable_layout_graph() = layout.graph();
    *request.mutable_placements() = layout.placements();
    ASSIGN_OR_RETURN(response, stages_.Evaluate(std::move(request), call));
  }
  layout.mutable_edge_outcomes()->Swap(response.mutable_edge_outcomes());
  layout.mutable_term_outcomes()->Swap(response.mutable_term_outcomes());
  layout.mutable_metrics()->Swap(response.mutable_metrics());
  layout.clear_stage_outcomes();
  layout.clear_runner_ups();
  // What has no place still has none, for the same reason.
  EraseIf(*layout.mutable_diagnostics(), [&](const v1::Diagnostic& diagnostic) {
    return diagnostic.subject_id().empty() || PlaceOf(layout, diagnostic.subject_id()) != nullptr;
  });
  double total = 0;
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) total += edge.weighted_cost();
  for (const v1::TermOutcome& term : layout.term_outcomes()) total += term.cost() * term.factor();
  layout.set_total_cost(total);
  return layout;
}

absl::StatusOr<Acted> LayoutActs::SolvedHolding(const Standing& standing, const EditList& edits, const ObjectIds& held,
                                                CallContext& call) const {
  Acted acted;
  if (standing.settled == nullptr) {
    ASSIGN_OR_RETURN(const EditList all, WithHolds(standing.shown, standing.shown, edits, standing.by_hand, held));
    v1::SolveRequest request;
    *request.mutable_layout_graph() = standing.shown.graph();
    if (!all.empty()) {
      ASSIGN_OR_RETURN(optimizer::EditedProblem problem, optimizer::ApplyEdits(standing.shown, all));
      request.mutable_layout_graph()->Swap(&problem.graph);
    }
    ASSIGN_OR_RETURN(v1::SolveResponse response, stages_.Solve(std::move(request), call));
    acted.layout.Swap(response.mutable_solved_layout());
    acted.producer = response.producer();
    KeepOnlyWantedPins(standing.shown.graph(), edits, *acted.layout.mutable_graph());
  } else {
    EditList changes = standing.pending;
    changes.MergeFrom(edits);
    v1::ResolveRequest request;
    *request.mutable_solved_layout() = *standing.settled;
    request.mutable_solved_layout()->clear_runner_ups();
    LendSentences(standing.shown.graph(), *request.mutable_solved_layout()->mutable_graph());
    ASSIGN_OR_RETURN(*request.mutable_edits(),
                     WithHolds(request.solved_layout(), standing.shown, changes, standing.by_hand, held));
    ASSIGN_OR_RETURN(v1::ResolveResponse response, stages_.Resolve(std::move(request), call));
    acted.layout.Swap(response.mutable_solved_layout());
    acted.producer = response.producer();
    KeepOnlyWantedPins(standing.settled->graph(), changes, *acted.layout.mutable_graph());
    ReturnSubjects(standing.shown.graph(), *acted.layout.mutable_graph());
    KeepForgotten(standing.shown.graph(), *acted.layout.mutable_graph());
  }
  acted.layout.clear_runner_ups();
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Solved(const Standing& standing, const EditList& edits, CallContext& call) const {
  constexpr int kMostTries = 6;
  const ObjectIds by_hand = ByHandAfter(standing.by_hand, edits);
  std::map<std::string, std::string> why;
  ObjectIds held = by_hand;
  absl::StatusOr<Acted> acted = SolvedHolding(standing, edits, held, call);
  for (int i = 0; i < kMostTries && !held.empty(); ++i) {
    std::map<std::string, std::string> in_the_way;
    if (acted.ok()) {
      in_the_way = WhatCannotBeHeld(acted->layout, held);
    } else if (absl::IsInvalidArgument(acted.status()) || absl::IsFailedPrecondition(acted.status())) {
      in_the_way.emplace(held.front(), acted.status().message());
    }
    if (in_the_way.empty()) break;
    std::erase_if(held, [&](const std::string& id) { return in_the_way.contains(id); });
    absl::StatusOr<Acted> freed = SolvedHolding(standing, edits, held, call);
    // What is wrong with the edits themselves no freeing mends.
    if (!acted.ok() && !freed.ok() && held.empty()) break;
    acted = std::move(freed);
    why.merge(in_the_way);
  }
  RETURN_IF_ERROR(acted.status());
  acted->by_hand = by_hand;
  for (const auto& [id, reason] : why) TellFreed(standing.shown, id, reason, *acted);
  acted->moved_ids = MovedIds(standing.shown, acted->layout);
  acted->diagnostics.assign(acted->layout.diagnostics().begin(), acted->layout.diagnostics().end());
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Unsolved(const Standing& standing, const EditList& edits, CallContext& call) const {
  ASSIGN_OR_RETURN(optimizer::EditedProblem problem, optimizer::ApplyEdits(standing.shown, edits));
  Acted acted;
  acted.layout = standing.shown;
  KeepOnlyWantedPins(standing.shown.graph(), edits, problem.graph);
  acted.layout.mutable_graph()->Swap(&problem.graph);
  acted.layout.mutable_placements()->Assign(problem.placements.begin(), problem.placements.end());
  const Placements placed = PlacementsOf(acted.layout);
  const v1::Point2 middle = MiddleOf(acted.layout.graph().room().floor());
  acted.pending = standing.pending;
  acted.pending.MergeFrom(edits);
  for (const v1::Object& object : acted.layout.graph().object_list().objects()) {
    if (placed.contains(object.id()) || !problem.touched.contains(object.id())) continue;
    v1::Placement& at = *acted.layout.add_placements();
    at.set_object_id(object.id());
    at.set_x_m(middle.x_m());
    at.set_y_m(middle.y_m());
    at.set_z_m(object.elevation_m());
    FaceIntoRoom(acted.layout.graph().room(), object, false, at);
  }
  ASSIGN_OR_RETURN(acted.layout, Evaluated(std::move(acted.layout), call));
  acted.producer = ByHand();
  acted.moved_ids = MovedIds(standing.shown, acted.layout);
  acted.diagnostics = std::move(problem.diagnostics);
  acted.by_hand = ByHandAfter(standing.by_hand, edits);
  acted.settled = false;
  return acted;
}

}  // namespace flair::session
