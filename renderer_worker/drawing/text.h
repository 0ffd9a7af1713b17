// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>
#include <pango/pangocairo.h>

#include <memory>
#include <string>

#include "absl/status/status.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/box.h"

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

enum class Align { kLeft, kCentre, kRight };

// Only DejaVu is relied on. `condense` scales horizontally: 0.9 is what DejaVu Condensed is.
struct TextStyle {
  double size_mm = 3.4;  // em, not cap height
  Rgb colour = Hex(0x2B2926);
  bool bold = false;
  bool serif = false;
  double tracking = 0;  // extra space between letters, em
  double condense = 0.9;
  double line_spacing = 1.0;
};

// A paragraph that never leaves its width: wraps at words up to `max_lines`, then ends in an ellipsis.
struct TextBlock {
  std::string text;
  TextStyle style;
  double max_width_mm = 0;  // 0: one line of any width
  int max_lines = 1;
  Align align = Align::kLeft;
};

// FAILED_PRECONDITION when there is no font at all to write with; any other will do for a missing DejaVu.
absl::Status CheckFonts();

// The text with what is not UTF-8 replaced.
std::string ValidUtf8(const std::string& text);

// The size on paper; independent of the surface up to rounding of the font backend.
Size Measure(const Canvas& canvas, const TextBlock& block);

// Draws with the upper left corner at `top_left_mm` (with max_width_mm set, alignment is within that width).
void DrawText(Canvas& canvas, const TextBlock& block, Point top_left_mm);

// Draws in the middle of `centre_mm`, turned counter-clockwise by `angle_rad`, over a halo of `halo` when not null.
void DrawTextAt(Canvas& canvas, const TextBlock& block, Point centre_mm, double angle_rad = 0,
                const Rgb* halo = nullptr);

}  // namespace flair::renderer
