// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/layout_metrics.h"

#include "evaluation/metrics/overlap.h"
#include "evaluation/metrics/pathway.h"
#include "evaluation/metrics/routes.h"
#include "room/conversion/conversion.h"

namespace flair::evaluation {

v1::LayoutMetrics MeasureLayout(const LayoutView& view) {
  const Reach reach = MeasureReach(view);
  v1::LayoutMetrics metrics;
  metrics.set_oob_percent(OobPercent(view));
  metrics.set_oor_percent(OorPercent(view));
  metrics.set_reachable_floor_share(reach.floor_share);
  metrics.set_reachable_front_share(reach.front_share);
  metrics.set_pathway_cost_m3(PathwayCost_m3(view));
  metrics.set_deepest_overlap_m(DeepestOverlap_m(view));
  return metrics;
}

absl::StatusOr<v1::LayoutMetrics> MeasureLayout(const v1::SolvedLayout& layout) {
  const absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  if (!scene.ok()) return scene.status();
  const absl::StatusOr<PartialLayout> partial = PosesFromPlacements(*scene, layout.placements());
  if (!partial.ok()) return partial.status();
  return MeasureLayout({*scene, partial->layout, partial->placed});
}

}  // namespace flair::evaluation
