// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/lettering.h"

namespace flair::renderer {

Lettering::Lettering()
    : surface_(cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr)),
      cairo_(cairo_create(surface_.get())),
      context_(pango_cairo_create_context(cairo_.get())) {
  // No hinting and no rounding to pixels.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context_.get(), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(context_.get(), FALSE);
}

}  // namespace flair::renderer
