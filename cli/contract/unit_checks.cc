// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: metres, radians and directions, told from where things stand in rooms that leave no choice.
#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "evaluation/metrics/layout_metrics.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::contract {
namespace {

Finding StandsOnTheFloor(Target& target) {
  return Given<v1::SolveResponse>(target, kBedroomSolve, BedroomSolve(), [](const v1::SolveResponse& answer) {
    for (const v1::Placement& placement : answer.solved_layout().placements()) {
      if (placement.z_m() == 0) continue;
      return Broken(kBedroomSolve, fmt::format("\"{}\" at z_m {}", placement.object_id(), placement.z_m()),
                    "0 for what stands on the floor: z_m is the height of the underside");
    }
    return Kept();
  });
}

bool NamesObject(const v1::SolvedLayout& layout, const std::string& object_id) {
  return std::ranges::any_of(layout.diagnostics(), [&](const v1::Diagnostic& diagnostic) {
    return diagnostic.subject_id() == object_id || diagnostic.message().find(object_id) != std::string::npos;
  });
}

// Share of the room's area, percent, that the layout's objects cover outside of it.
absl::StatusOr<double> OutsidePercent(const v1::LayoutGraph& graph, v1::SolvedLayout layout) {
  *layout.mutable_graph() = graph;
  const absl::StatusOr<v1::LayoutMetrics> metrics = evaluation::MeasureLayout(layout);
  if (!metrics.ok()) return metrics.status();
  return metrics->oob_percent();
}

// A bench that fits a corridor in one direction only. A server that measures otherwise puts it through the walls.
Finding FitsACorridor(Target& target, const char* room, const std::string& sent, const std::string& right) {
  constexpr double kOutsidePercent = 1;
  v1::SolveRequest request;
  *request.mutable_layout_graph() =
      GraphFromText(fmt::format("{}; zone hall; bench 2.4x0.5 at 1,1,0 primary zone hall height 0.5", room));
  return Given<v1::SolveResponse>(target, sent, request, [&](const v1::SolveResponse& answer) {
    const absl::StatusOr<double> outside = OutsidePercent(request.layout_graph(), answer.solved_layout());
    if (!outside.ok()) return Broken(sent, std::string(outside.status().message()), right);
    if (*outside <= kOutsidePercent) return Kept();
    if (NamesObject(answer.solved_layout(), "bench"))
      return Skipped("a diagnostic says that the bench has no good place");
    const std::string placement = answer.solved_layout().placements_size() == 0
                                      ? "no placement"
                                      : answer.solved_layout().placements(0).ShortDebugString();
    return Broken(sent, fmt::format("{{ {} }}, which is outside the room by {:.1f} % of its area", placement, *outside),
                  right);
  });
}

Finding FitsAStraightCorridor(Target& target) {
  return FitsACorridor(target, "1.2x4 room",
                       "Solve of a corridor of 1.2 m (x) by 4 m (y) with a bench 2.4 m wide and 0.5 m deep",
                       "theta_rad near pi/2 or 3 pi/2: at 0 an object faces north, with its width along x");
}

Finding FitsASlantingCorridor(Target& target) {
  return FitsACorridor(
      target, "room 0.6,0 4.0641,2 3.4641,3.0392 0,1.0392",
      "Solve of a corridor 1.2 m wide that runs 30 degrees counter-clockwise from the x axis, with a bench 2.4 m wide",
      "theta_rad near pi/6 or 7 pi/6 (headings turn counter-clockwise), or a diagnostic that names the bench");
}

}  // namespace

void AddUnitChecks(Checks& checks) {
  checks.push_back({"What stands on the floor has its underside at 0 m", Promise::kUnits, StandsOnTheFloor});
  checks.push_back({"Headings are radians and 0 faces north: a bench fits a straight corridor", Promise::kUnits,
                    FitsAStraightCorridor});
  checks.push_back(
      {"Headings turn counter-clockwise: a bench fits a slanting corridor", Promise::kUnits, FitsASlantingCorridor});
}

}  // namespace flair::contract
