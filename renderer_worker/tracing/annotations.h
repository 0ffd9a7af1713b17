// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {

// Camera and instances of a view whose planes are filled in.
v1::ViewAnnotations AnnotationsOf(const Scene& scene, const World& world, const PinholeCamera& camera,
                                  const TracedView& view);

}  // namespace flair::renderer
