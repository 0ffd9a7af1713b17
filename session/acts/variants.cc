// SPDX-License-Identifier: GPL-3.0-or-later
// Other layouts of what is shown.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fmt/format.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/edits.h"
#include "session/sentences/names.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// To the eye.
bool SamePlace(const v1::Placement& a, const v1::Placement& b) {
  constexpr double kSeen_m = 0.01, kSeen_rad = 0.02;
  return a.object_id() == b.object_id() && std::hypot(a.x_m() - b.x_m(), a.y_m() - b.y_m()) < kSeen_m &&
         std::abs(std::remainder(a.theta_rad() - b.theta_rad(), 2 * M_PI)) < kSeen_rad;
}

}  // namespace

absl::StatusOr<v1::SolvedLayout> LayoutActs::WithAlternatives(const v1::SolvedLayout& shown, int count, int64_t seed,
                                                              CallContext& call) const {
  constexpr int kMost = 16;
  if (count < 1 || count > kMost) return InvalidArgument("count: {}; must be in [1, {}]", count, kMost);
  if (shown.graph().object_list().objects().empty()) {
    return absl::FailedPreconditionError("the room is empty: there is nothing to place otherwise");
  }
  v1::SolveRequest request;
  *request.mutable_layout_graph() = shown.graph();
  request.mutable_options()->set_seed(seed);
  // One of them may be what is shown.
  request.mutable_options()->set_variant_count(count + 1);
  ASSIGN_OR_RETURN(v1::SolveResponse response, stages_.Solve(std::move(request), call));
  v1::SolvedLayout& best = *response.mutable_solved_layout();
  v1::SolvedLayout all = shown;
  all.clear_runner_ups();
  const auto add = [&](v1::RunnerUp other) {
    const bool same = std::ranges::equal(other.placements(), shown.placements(), SamePlace);
    if (!same && !other.edge_outcomes().empty() && all.runner_ups_size() < count)
      *all.add_runner_ups() = std::move(other);
  };
  v1::RunnerUp first;
  first.set_cost(best.total_cost());
  *first.mutable_placements() = best.placements();
  *first.mutable_edge_outcomes() = best.edge_outcomes();
  *first.mutable_zone_regions() = best.zone_regions();
  *first.mutable_metrics() = best.metrics();
  *first.mutable_diagnostics() = best.diagnostics();
  add(std::move(first));
  for (v1::RunnerUp& other : *best.mutable_runner_ups()) add(std::move(other));
  return all;
}

absl::StatusOr<Acted> LayoutActs::Taken(const v1::SolvedLayout& shown, v1::SolvedLayout variant,
                                        CallContext& call) const {
  EditList edits;
  Acted taken;
  // Of these it left out what it has no place for.
  const IdSet known = IdsOf(variant.graph().object_list().objects());
  *variant.mutable_graph() = shown.graph();
  auto& places = *variant.mutable_placements();
  // What was taken away since is gone, and what was added since stays where it is.
  const IdSet there = IdsOf(shown.graph().object_list().objects());
  EraseIf(places, [&](const v1::Placement& at) { return !there.contains(at.object_id()); });
  for (const v1::Placement& at : shown.placements()) {
    if (!known.contains(at.object_id())) *places.Add() = at;
  }
  for (const v1::Placement& pin : shown.graph().pinned_placements()) {
    const auto at = std::ranges::find(places, pin.object_id(), &v1::Placement::object_id);
    if (at == places.end()) continue;
    if (SamePlace(*at, pin)) {
      *at = pin;
      continue;
    }
    // Moving holds it there during the solve, locking afterwards.
    *edits.Add()->mutable_move_object() = pin;
    edits.Add()->set_pin_object_id(pin.object_id());
    taken.diagnostics.push_back(
        Remark(v1::SEVERITY_NOTE, "lock_kept", pin.object_id(),
               fmt::format("the {} is locked and stays: the rest of this variant was solved around it",
                           NameOf(shown, pin.object_id()))));
  }
  // Until then it is where the variant has it.
  EraseIf(*variant.mutable_graph()->mutable_pinned_placements(), [&](const v1::Placement& pin) {
    return std::ranges::any_of(edits, [&](const auto& edit) { return edit.pin_object_id() == pin.object_id(); });
  });
  ASSIGN_OR_RETURN(taken.layout, Evaluated(std::move(variant), call));
  if (!edits.empty()) {
    ASSIGN_OR_RETURN(Acted around, Solved({taken.layout, &taken.layout, {}, {}}, edits, call));
    around.diagnostics.insert(around.diagnostics.begin(), taken.diagnostics.begin(), taken.diagnostics.end());
    taken = std::move(around);
  }
  taken.moved_ids = MovedIds(shown, taken.layout);
  return taken;
}

}  // namespace flair::session
