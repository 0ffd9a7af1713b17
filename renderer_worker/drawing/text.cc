// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/text.h"

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

namespace {

constexpr double kUnitsPerMm = Lettering::kUnitsPerMm;

void SetTracking(PangoLayout* layout, const TextStyle& style) {
  if (style.tracking == 0) return;
  PangoAttrList* attributes = pango_attr_list_new();
  pango_attr_list_insert(attributes, pango_attr_letter_spacing_new(
                                         static_cast<int>(style.tracking * style.size_mm * kUnitsPerMm * PANGO_SCALE)));
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
}

LayoutPtr MakeLayout(const Canvas& canvas, const TextBlock& block) {
  // Pango mismeasures under a matrix that condenses: that comes later, to the outlines.
  LayoutPtr layout = canvas.lettering().MakeLayout();
  PangoFontDescription* font = pango_font_description_new();
  pango_font_description_set_family_static(font, block.style.serif ? "DejaVu Serif" : "DejaVu Sans");
  pango_font_description_set_weight(font, block.style.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
  pango_font_description_set_absolute_size(font, block.style.size_mm * kUnitsPerMm * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), font);
  pango_font_description_free(font);
  SetTracking(layout.get(), block.style);
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  // Lines start at the left whatever the script; words of a script from right to left still run that way.
  pango_layout_set_auto_dir(layout.get(), FALSE);
  if (block.style.line_spacing != 1.0) pango_layout_set_line_spacing(layout.get(), block.style.line_spacing);
  if (block.max_width_mm > 0) {
    pango_layout_set_width(layout.get(),
                           static_cast<int>(block.max_width_mm * kUnitsPerMm / block.style.condense * PANGO_SCALE));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    pango_layout_set_height(layout.get(), -block.max_lines);
    pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
  }
  pango_layout_set_alignment(layout.get(), block.align == Align::kLeft     ? PANGO_ALIGN_LEFT
                                           : block.align == Align::kCentre ? PANGO_ALIGN_CENTER
                                                                           : PANGO_ALIGN_RIGHT);
  pango_layout_set_text(layout.get(), ValidUtf8(block.text).c_str(), -1);
  return layout;
}

Size SizeOf(PangoLayout* layout, const TextStyle& style) {
  PangoRectangle logical;
  pango_layout_get_extents(layout, nullptr, &logical);
  return {static_cast<double>(logical.width) / PANGO_SCALE / kUnitsPerMm * style.condense,
          static_cast<double>(logical.height) / PANGO_SCALE / kUnitsPerMm};
}

// Makes the letters' outlines the current path, `anchor` (in layout units) at `at_mm`. Outlines rather than glyphs: the
// image backend would round every glyph to whole pixels.
void TraceOutlines(Canvas& canvas, PangoLayout* layout, const TextStyle& style, Point at_mm, double angle_rad,
                   Point anchor) {
  cairo_t* letters = canvas.lettering().cairo();
  cairo_new_path(letters);
  cairo_move_to(letters, 0, 0);
  pango_cairo_layout_path(letters, layout);
  cairo_path_t* outlines = cairo_copy_path(letters);
  cairo_t* cairo = canvas.cairo();
  cairo_new_path(cairo);
  cairo_save(cairo);
  cairo_translate(cairo, at_mm.x, at_mm.y);
  cairo_rotate(cairo, -angle_rad);
  cairo_scale(cairo, style.condense / kUnitsPerMm, 1 / kUnitsPerMm);
  cairo_translate(cairo, -anchor.x, -anchor.y);
  cairo_append_path(cairo, outlines);
  cairo_restore(cairo);
  cairo_path_destroy(outlines);
}

}  // namespace

absl::Status CheckFonts() {
  PangoFontMap* fonts = pango_cairo_font_map_get_default();
  const std::unique_ptr<PangoContext, UnrefObject> context(pango_font_map_create_context(fonts));
  PangoFontDescription* any = pango_font_description_from_string("DejaVu Sans 10");
  const std::unique_ptr<PangoFont, UnrefObject> font(pango_font_map_load_font(fonts, context.get(), any));
  pango_font_description_free(any);
  if (font != nullptr) return absl::OkStatus();
  return absl::FailedPreconditionError("no font is installed to write with; DejaVu is what drawings are made for");
}

std::string ValidUtf8(const std::string& text) {
  gchar* valid = g_utf8_make_valid(text.data(), static_cast<gssize>(text.size()));
  std::string result = valid;
  g_free(valid);
  return result;
}

Size Measure(const Canvas& canvas, const TextBlock& block) {
  return SizeOf(MakeLayout(canvas, block).get(), block.style);
}

void DrawText(Canvas& canvas, const TextBlock& block, Point top_left_mm) {
  const LayoutPtr layout = MakeLayout(canvas, block);
  TraceOutlines(canvas, layout.get(), block.style, top_left_mm, 0, {0, 0});
  canvas.Fill(block.style.colour);
}

void DrawTextAt(Canvas& canvas, const TextBlock& block, Point centre_mm, double angle_rad, const Rgb* halo) {
  const LayoutPtr layout = MakeLayout(canvas, block);
  PangoRectangle logical;
  pango_layout_get_extents(layout.get(), nullptr, &logical);
  const Point middle{(logical.x + logical.width / 2.0) / PANGO_SCALE, (logical.y + logical.height / 2.0) / PANGO_SCALE};
  TraceOutlines(canvas, layout.get(), block.style, centre_mm, angle_rad, middle);
  if (halo != nullptr) canvas.Draw({*halo, 0.32 * block.style.size_mm, 0.85, Dash::kSolid, true}, true);
  canvas.Fill(block.style.colour);
}

}  // namespace flair::renderer
