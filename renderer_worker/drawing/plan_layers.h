// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"

namespace flair::renderer {

// What is drawn beside walls and openings; as it is when nothing is asked for.
struct PlanLayers {
  bool floor_pieces = true;
  bool tertiary = true;
  bool zones = true;
  bool dimensions = true;
  bool constraints = false;
  bool circulation = false;
};

// The layers of the options; INVALID_ARGUMENT for one that does not exist.
absl::StatusOr<PlanLayers> LayersOf(const v1::RenderOptions& options);

}  // namespace flair::renderer
