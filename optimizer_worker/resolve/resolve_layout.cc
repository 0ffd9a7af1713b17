// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/resolve_layout.h"

#include <algorithm>
#include <map>

#include "fmt/format.h"
#include "optimizer_worker/resolve/warm_search.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/conversion/conversion.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

using PlacementList = google::protobuf::RepeatedPtrField<v1::Placement>;

// The placements of objects that the input knows.
absl::StatusOr<PartialLayout> StateOf(const SolveInput& input, const PlacementList& placements) {
  PlacementList known;
  for (const v1::Placement& placement : placements) {
    if (input.scene.IndexOf(placement.object_id()) >= 0) *known.Add() = placement;
  }
  PartialLayout state(input.scene);
  RETURN_IF_ERROR(ReadPlacements(input, known, state));
  return state;
}

Baseline MakeBaseline(const SolveInput& input, const v1::SolvedLayout& layout, const EditedProblem& problem,
                      const PartialLayout& before, const std::vector<int>& touched) {
  std::map<std::string_view, bool> satisfied;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    satisfied[outcome.edge_id()] = outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
  }
  Baseline baseline;
  for (const v1::ConstraintEdge& edge : input.graph.edges()) {
    const auto known = satisfied.find(edge.id());
    // A new or changed edge is to be tried for as well.
    const bool edited = problem.edited_edges.contains(edge.id());
    baseline.held.push_back(edited || (known != satisfied.end() && known->second));
  }
  PartialLayout untouched = before;
  for (int object : touched) untouched.placed[object] = 0;
  baseline.tolerated = PairsInTheWay(input, untouched);
  return baseline;
}

// What stood on something that is gone now, and what that was.
absl::StatusOr<std::map<int, Object>> LostCarriers(const SolveInput& input, const v1::SolvedLayout& layout) {
  ASSIGN_OR_RETURN(const Scene old, SceneFromProto(layout.graph()));
  PartialLayout state(old);
  for (const v1::Placement& placement : layout.placements()) {
    const int object = old.IndexOf(placement.object_id());
    if (object >= 0) state.Place(object, {placement.x_m(), placement.y_m(), placement.theta_rad()});
  }
  std::map<int, Object> lost;
  for (int i = 0; i < static_cast<int>(old.objects.size()); ++i) {
    if (old.objects[i].kind != ObjectKind::kSurface || !state.placed[i]) continue;
    const int carrier = CarrierOf(old, i, state), now = input.scene.IndexOf(old.objects[i].id);
    if (carrier < 0 || now < 0 || input.scene.IndexOf(old.objects[carrier].id) >= 0) continue;
    lost.emplace(now, old.objects[carrier]);
  }
  return lost;
}

std::vector<LeftOut> WithoutCarrier(const std::map<int, Object>& lost_carriers, const PartialLayout& state) {
  std::vector<LeftOut> left_out;
  for (const auto& [object, carrier] : lost_carriers) {
    if (state.placed[object]) continue;
    left_out.push_back(
        {object, fmt::format("it stood on \"{}\", which is gone, and nothing like it has a free place", carrier.id)});
  }
  return left_out;
}

// Everything anew, but for the pins.
absl::StatusOr<WarmResult> SolveAnew(const SolveInput& input) {
  ASSIGN_OR_RETURN(std::vector<Branch> branches, Driver(input, LocalRestartRunner()).Run());
  Branch& best = branches.front();
  return WarmResult{std::move(best.state), std::move(best.outcomes), std::move(best.durations)};
}

absl::StatusOr<WarmResult> Search(const SolveInput& input, const WarmStart& start) {
  absl::StatusOr<WarmResult> warm = SearchWarm(input, start);
  if (!warm.ok() || input.OutOfTime()) return warm;
  const double left_m = FindViolations(input, warm->state, start.baseline).depth_m;
  if (left_m <= kFits_m) return warm;
  absl::StatusOr<WarmResult> anew = SolveAnew(input);
  if (!anew.ok()) return anew.status();
  return FindViolations(input, anew->state, start.baseline).depth_m < left_m ? anew : warm;
}

std::vector<std::string> MovedIds(const SolveInput& input, const PartialLayout& before, const PartialLayout& after) {
  std::vector<std::string> ids;
  for (size_t i = 0; i < after.layout.size(); ++i) {
    if (!after.placed[i] || (before.placed[i] && before.layout[i] == after.layout[i])) continue;
    ids.push_back(input.scene.objects[i].id);
  }
  return ids;
}

}  // namespace

absl::StatusOr<ResolveResult> ResolveLayout(const v1::SolvedLayout& layout, const EditList& edits,
                                            const v1::SolveOptions& options, const Solver& solver,
                                            const CancelCheck& cancelled) {
  RETURN_IF_ERROR(Validate(layout));
  ASSIGN_OR_RETURN(const EditedProblem problem, ApplyEdits(layout, edits));
  v1::SolveOptions one = options;
  one.clear_variant_count();
  ASSIGN_OR_RETURN(const SolveInput input, MakeSolveInput(problem.graph, one, solver, cancelled));
  ASSIGN_OR_RETURN(const PartialLayout before, StateOf(input, layout.placements()));
  const absl::StatusOr<PartialLayout> now =
      StateOf(input, PlacementList(problem.placements.begin(), problem.placements.end()));
  if (!now.ok()) return now.status();

  WarmStart start{*now, before, {}, {}, {}};
  for (const Pin& pin : input.pins) start.state.Place(pin.object, pin.pose);
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (problem.touched.contains(input.scene.objects[i].id)) start.touched.push_back(i);
  }
  start.baseline = MakeBaseline(input, layout, problem, before, start.touched);
  ASSIGN_OR_RETURN(start.lost_carriers, LostCarriers(input, layout));
  ASSIGN_OR_RETURN(WarmResult found, Search(input, start));

  ResolveResult result;
  result.moved_ids = MovedIds(input, before, found.state);
  result.stage_durations = found.durations;
  Branch branch{std::move(found.state), 0, std::move(found.outcomes), std::move(found.durations)};
  branch.left_out = WithoutCarrier(start.lost_carriers, branch.state);
  if (input.settings.leave_out_misfits) LeaveOutOf(input, branch);
  result.layout = MakeSolvedLayout(input, {branch});
  for (const v1::Diagnostic& diagnostic : problem.diagnostics) *result.layout.add_diagnostics() = diagnostic;
  return result;
}

}  // namespace flair::optimizer
