// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {

absl::StatusOr<TracedView> TraceView(const Scene& scene, const SceneCamera& camera, const TraceOptions& options) {
  return absl::UnimplementedError("views are not traced yet");
}

Pixels ToneMapped(const TracedView& view) {
  Pixels pixels{view.width_px, view.height_px, {}};
  pixels.rgb.resize(3 * view.colour.size());
  return pixels;
}

}  // namespace flair::renderer
