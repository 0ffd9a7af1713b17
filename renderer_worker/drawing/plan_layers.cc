// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/plan_layers.h"

#include <fmt/format.h>

namespace flair::renderer {

absl::StatusOr<PlanLayers> LayersOf(const v1::RenderOptions& options) {
  if (options.layers().empty()) return PlanLayers{};
  PlanLayers layers{false, false, false, false, false, false};
  for (int i = 0; i < options.layers_size(); ++i) {
    switch (options.layers(i)) {
      case v1::PLAN_LAYER_FLOOR_PIECES:
        layers.floor_pieces = true;
        break;
      case v1::PLAN_LAYER_TERTIARY:
        layers.tertiary = true;
        break;
      case v1::PLAN_LAYER_ZONES:
        layers.zones = true;
        break;
      case v1::PLAN_LAYER_DIMENSIONS:
        layers.dimensions = true;
        break;
      case v1::PLAN_LAYER_CONSTRAINTS:
        layers.constraints = true;
        break;
      case v1::PLAN_LAYER_CIRCULATION:
        layers.circulation = true;
        break;
      default:
        return absl::InvalidArgumentError(
            fmt::format("options.layers[{}]: {} is no layer", i, static_cast<int>(options.layers(i))));
    }
  }
  return layers;
}

}  // namespace flair::renderer
