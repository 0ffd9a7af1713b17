// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: costs and measures of placements that somebody else chose.
#include <cmath>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::contract {
namespace {

v1::EvaluateRequest HalfOut() {
  v1::EvaluateRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  v1::Placement& bed = *request.add_placements();
  bed.set_object_id("bed");
  bed.set_x_m(2);
  bed.set_y_m(0.5);
  return request;
}

Finding MeasuresWhatIsOutside(Target& target) {
  // 1.6 m x 0.5 m of the bed is south of the room of 20 m2.
  constexpr double kPercent = 100 * 1.6 * 0.5 / 20;
  const std::string sent = "Evaluate of a bed of 1.6 m x 2 m at (2, 0.5), half a metre of it outside the room";
  return Given<v1::EvaluateResponse>(target, sent, HalfOut(), [&](const v1::EvaluateResponse& answer) {
    if (!answer.has_metrics()) return Skipped("Evaluate gives no metrics");
    if (std::abs(answer.metrics().oob_percent() - kPercent) < 1e-6) return Kept();
    return Broken(sent, fmt::format("metrics.oob_percent {}", answer.metrics().oob_percent()),
                  fmt::format("{}: the bed stands on (2, 0.5) and its width is along x", kPercent));
  });
}

Finding DropsWhatIsNotPlaced(Target& target) {
  v1::EvaluateRequest request = HalfOut();
  *request.mutable_layout_graph()->add_edges() = EdgeOn("surely_no_such_type", "object", "nightstand");
  const std::string sent = "Evaluate with an edge of type \"surely_no_such_type\"";
  return Given<v1::EvaluateResponse>(target, sent, request, [&](const v1::EvaluateResponse& answer) {
    if (answer.edge_outcomes_size() == 1 && answer.edge_outcomes(0).status() == v1::OUTCOME_STATUS_DROPPED &&
        !answer.edge_outcomes(0).reason().empty()) {
      return Kept();
    }
    return Broken(sent,
                  fmt::format("{} outcomes {}", answer.edge_outcomes_size(),
                              answer.edge_outcomes_size() > 0 ? answer.edge_outcomes(0).ShortDebugString() : ""),
                  "one outcome, OUTCOME_STATUS_DROPPED with a reason");
  });
}

}  // namespace

void AddEvaluateChecks(Checks& checks) {
  checks.push_back(
      {"Evaluate measures what is outside the room", Promise::kUnits, MeasuresWhatIsOutside, v1::CAPABILITY_EVALUATE});
  checks.push_back({"Evaluate drops edges of no known type with a reason", Promise::kMessages, DropsWhatIsNotPlaced,
                    v1::CAPABILITY_EVALUATE});
  using Request = v1::EvaluateRequest;
  AddRefusals<v1::EvaluateResponse, Request>(
      HalfOut(),
      {{"a problem with a bad width", "objects[0].width_m",
        [](Request& request) {
          request.mutable_layout_graph()->mutable_object_list()->mutable_objects(0)->set_width_m(-1);
        }},
       {"a placement of an object that is not there", "placements[0].object_id",
        [](Request& request) { request.mutable_placements(0)->set_object_id("ghost"); }},
       {"an object that is placed twice", "placements[1].object_id",
        [](Request& request) { *request.add_placements() = request.placements(0); }},
       {"a placement that is no number", "placements[0].y_m",
        [](Request& request) { request.mutable_placements(0)->set_y_m(kNaN); }},
       {"a heading that is no number", "placements[0].theta_rad",
        [](Request& request) { request.mutable_placements(0)->set_theta_rad(kNaN); }}},
      checks, v1::CAPABILITY_EVALUATE);
}

}  // namespace flair::contract
