// SPDX-License-Identifier: GPL-3.0-or-later
// Other layouts of what is shown.
#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "session/act_words.h"
#include "session/layout_acts.h"
#include "session/placing.h"
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

bool IsLocked(const v1::LayoutGraph& graph, const std::string& id) {
  return std::ranges::any_of(graph.pinned_placements(), [&](const auto& pin) { return pin.object_id() == id; });
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
  request.set_request_id("flair-session");
  *request.mutable_layout_graph() = shown.graph();
  request.mutable_options()->set_seed(seed);
  // One of them may be what is shown.
  request.mutable_options()->set_variant_count(count + 1);
  ASSIGN_OR_RETURN(v1::SolveResponse response, stages_.Solve(request, call));
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
  const Placements places = PlacementsOf(variant);
  EditList edits;
  Acted taken;
  for (const v1::Placement& pin : shown.graph().pinned_placements()) {
    const auto at = places.find(pin.object_id());
    // It may have been added since.
    if (at == places.end()) continue;
    if (SamePlace(*at->second, pin)) {
      *at->second = pin;
      if (!IsLocked(variant.graph(), pin.object_id())) *variant.mutable_graph()->add_pinned_placements() = pin;
      continue;
    }
    // Moving holds it there during the solve, locking afterwards.
    *edits.Add()->mutable_move_object() = pin;
    edits.Add()->set_pin_object_id(pin.object_id());
    v1::Diagnostic& held = taken.diagnostics.emplace_back();
    held.set_severity(v1::SEVERITY_NOTE);
    held.set_code("lock_kept");
    held.set_subject_id(pin.object_id());
    held.set_message(fmt::format("the {} is locked and stays: the rest of this variant was solved around it",
                                 NameOf(shown, pin.object_id())));
  }
  // What was unlocked since is free.
  auto& pins = *variant.mutable_graph()->mutable_pinned_placements();
  for (int i = pins.size() - 1; i >= 0; --i) {
    if (!IsLocked(shown.graph(), pins[i].object_id())) pins.DeleteSubrange(i, 1);
  }
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
