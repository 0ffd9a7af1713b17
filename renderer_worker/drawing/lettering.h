// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pango/pangocairo.h>

#include <memory>

#include "renderer_worker/drawing/surface.h"

namespace flair::renderer {

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
