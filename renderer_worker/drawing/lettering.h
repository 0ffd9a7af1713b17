// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>
#include <pango/pangocairo.h>

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

struct UnrefObject {
  void operator()(void* object) const { g_object_unref(object); }
};
using LayoutPtr = std::unique_ptr<PangoLayout, UnrefObject>;

// Where the letters of a drawing are measured and outlined: a surface without edges or pixels, so that the same words
// take the same paper whatever the drawing becomes. Units are kUnitsPerMm to the millimetre of paper: fonts are
// measured in whole units somewhere below.
class Lettering {
 public:
  static constexpr double kUnitsPerMm = 64;

  Lettering();
  // An empty layout.
  LayoutPtr MakeLayout() const { return LayoutPtr(pango_layout_new(context_.get())); }
  cairo_t* cairo() const { return cairo_.get(); }

 private:
  SurfacePtr surface_;
  CairoPtr cairo_;
  std::unique_ptr<PangoContext, UnrefObject> context_;
};

}  // namespace flair::renderer
