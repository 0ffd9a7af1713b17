// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/look.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {

// Everything that a picture is composed of.
struct Exposed {
  const World& world;
  const Lights& lights;
  const Radiosity& radiosity;
  const Surroundings& surroundings;
  const PinholeCamera& camera;
  std::span<const Seen> seen;
  std::span<const Lit> lit;
};

// Light times surfaces, edges looked at several times, exposed by how much light falls on what is seen.
absl::Status ComposeColour(const Exposed& exposed, const Workers& workers, std::vector<Vec3>& colour);

}  // namespace flair::renderer
