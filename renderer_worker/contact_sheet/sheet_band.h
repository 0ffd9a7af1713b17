// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>

#include <memory>

#include "absl/status/status.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/draw_plan.h"

namespace flair::renderer {

// A strip of white pixels to draw on, one unit a pixel, origin at its upper left corner.
class SheetBand {
 public:
  SheetBand(int width_px, int height_px);

  // RESOURCE_EXHAUSTED when something of it could not be had.
  absl::Status status() const;
  Canvas& canvas() { return *canvas_; }
  // With the upper left corner there.
  void Put(const Pixels& picture, int left_px, int top_px);
  // Below what `pixels` holds already; it must have the room.
  void AppendTo(Pixels& pixels) const;

 private:
  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> cairo_;
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace flair::renderer
