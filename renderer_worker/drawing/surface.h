// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>

#include <memory>

#include "absl/status/status.h"

namespace flair::renderer {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyCairo {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
using SurfacePtr = std::unique_ptr<cairo_surface_t, DestroySurface>;
using CairoPtr = std::unique_ptr<cairo_t, DestroyCairo>;

// OK, or what went wrong while drawing: RESOURCE_EXHAUSTED for memory, INTERNAL otherwise.
absl::Status StatusOf(cairo_status_t status);

}  // namespace flair::renderer
