// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: edits of a layout, and several layouts of one problem.
#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/optimizer_service.pb.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& object_id) {
  const auto found = std::ranges::find(layout.placements(), object_id, &v1::Placement::object_id);
  return found == layout.placements().end() ? nullptr : &*found;
}

bool Contains(const google::protobuf::RepeatedPtrField<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// What is wrong with the answer after the bed was moved to (2, 2); empty when nothing is.
std::string MoveFault(const v1::SolvedLayout& before, const v1::ResolveResponse& answer) {
  const v1::SolvedLayout& after = answer.solved_layout();
  if (const absl::Status status = Validate(after); !status.ok()) return std::string(status.message());
  const v1::Placement* const bed = PlacementOf(after, "bed");
  if (bed == nullptr || bed->x_m() != 2 || bed->y_m() != 2) return "the bed is not at (2, 2)";
  if (after.graph().pinned_placements_size() != 1) {
    return fmt::format("{} pinned_placements in its graph", after.graph().pinned_placements_size());
  }
  if (!Contains(answer.moved_object_ids(), "bed")) return "moved_object_ids without the bed";
  const v1::Placement* const old = PlacementOf(before, "nightstand");
  const v1::Placement* const now = PlacementOf(after, "nightstand");
  if (old == nullptr || now == nullptr) return "no placement of the nightstand";
  const bool moved = old->SerializeAsString() != now->SerializeAsString();
  if (moved != Contains(answer.moved_object_ids(), "nightstand")) {
    return fmt::format("a nightstand that was {}moved, and moved_object_ids that say otherwise", moved ? "" : "not ");
  }
  return "";
}

Finding MovesWhatItSays(Target& target) {
  const std::string sent = "Resolve with the bed moved to (2, 2)";
  return Given<v1::SolveResponse>(target, kBedroomSolve, BedroomSolve(), [&](const v1::SolveResponse& solved) {
    v1::ResolveRequest request;
    request.set_request_id(target.NewRequestId());
    *request.mutable_solved_layout() = solved.solved_layout();
    v1::Placement& bed = *request.add_edits()->mutable_move_object();
    bed.set_object_id("bed");
    bed.set_x_m(2);
    bed.set_y_m(2);
    return Given<v1::ResolveResponse>(target, sent, request, [&](const v1::ResolveResponse& answer) {
      const std::string fault = MoveFault(solved.solved_layout(), answer);
      if (fault.empty()) return Kept();
      return Broken(sent, fault, "a valid layout with the bed at (2, 2) and pinned, and the ids of all that moved");
    });
  });
}

Finding RefusesEditsOfGhosts(Target& target) {
  return Given<v1::SolveResponse>(target, kBedroomSolve, BedroomSolve(), [&](const v1::SolveResponse& solved) {
    v1::ResolveRequest request;
    *request.mutable_solved_layout() = solved.solved_layout();
    request.add_edits()->set_pin_object_id("ghost");
    return Refused<v1::ResolveResponse>(target, "a pin of an object that is not there", "edits[0]", request);
  });
}

Finding VariantsAreComplete(Target& target) {
  constexpr int kWanted = 3;
  v1::SolveRequest request = BedroomSolve();
  request.mutable_options()->set_variant_count(kWanted);
  const std::string sent = fmt::format("Solve of a small bedroom with options.variant_count {}", kWanted);
  const std::string right =
      fmt::format("a layout with at most {} runner_ups, each with a placement of every object", kWanted - 1);
  return Given<v1::SolveResponse>(target, sent, request, [&](const v1::SolveResponse& answer) {
    const v1::SolvedLayout& layout = answer.solved_layout();
    if (const absl::Status status = Validate(layout); !status.ok()) {
      return Broken(sent, std::string(status.message()), right);
    }
    if (layout.runner_ups_size() > kWanted - 1) {
      return Broken(sent, fmt::format("{} runner_ups", layout.runner_ups_size()), right);
    }
    for (const v1::RunnerUp& runner_up : layout.runner_ups()) {
      if (runner_up.placements_size() == layout.placements_size()) continue;
      return Broken(sent, fmt::format("a runner-up with {} placements", runner_up.placements_size()), right);
    }
    // A room may have but one good layout; this one has many.
    return layout.runner_ups_size() > 0 ? Kept() : Broken(sent, "no runner_ups", right);
  });
}

}  // namespace

void AddResolveChecks(Checks& checks) {
  checks.push_back({"Resolve puts a moved object where it is wanted and says what else moved", Promise::kMessages,
                    MovesWhatItSays, v1::CAPABILITY_RESOLVE});
  checks.push_back({"Resolve refuses an edit of an object that is not there", Promise::kErrors, RefusesEditsOfGhosts,
                    v1::CAPABILITY_RESOLVE});
  checks.push_back({"Variants are complete layouts, and no more than were asked for", Promise::kMessages,
                    VariantsAreComplete, v1::CAPABILITY_VARIANTS});
}

}  // namespace flair::contract
