// SPDX-License-Identifier: GPL-3.0-or-later
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/lettering.h"
#include "renderer_worker/drawing/plan_sheet.h"
#include "renderer_worker/drawing/text.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr double kArcToleranceMm = 0.004;  // of curves that stand for arcs: as fine as SVG's coordinates

cairo_status_t Append(void* closure, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

// What a document says of itself, in the places that both formats have.
struct About {
  std::string title, description, software, keywords;
};

About AboutOf(const std::string& title, const Sheet& sheet, const DrawingMetadata& metadata) {
  About about;
  DrawingMetadata others;
  const std::string scale = fmt::format("1:{} at {}", sheet.scale, sheet.paper);
  bool has_scale = false;
  for (const auto& [name, value] : metadata) {
    if (name == "Title") {
      about.title = value;
    } else if (name == "Description") {
      about.description = value;
    } else if (name == "Software") {
      about.software = value;
    } else {
      has_scale = has_scale || name == "flair:scale";
      others.emplace_back(name == "Keywords" ? "" : name, value);
    }
  }
  if (about.title.empty()) about.title = title;
  if (about.description.empty()) about.description = fmt::format("Furniture plan, scale {}", scale);
  if (about.software.empty()) about.software = "flair";
  if (!has_scale) others.emplace_back("flair:scale", scale);
  for (const auto& [name, value] : others) {
    about.keywords += (about.keywords.empty() ? "" : "; ") + (name.empty() ? value : name + ": " + value);
  }
  return about;
}

// Text for XML: what must be escaped is, and bytes that XML forbids become spaces.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

// cairo writes no metadata into SVG: it goes right behind the opening tag.
std::string WithMetadata(std::string svg, const About& about) {
  const size_t tag = svg.find("<svg"), end = tag == std::string::npos ? tag : svg.find('>', tag);
  if (end == std::string::npos) return svg;
  svg.insert(end + 1, fmt::format("\n<title>{}</title>\n<desc>{}</desc>\n<metadata>\n"
                                  "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
                                  "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<rdf:Description rdf:about=\"\">\n"
                                  "<dc:title>{}</dc:title>\n<dc:description>{}</dc:description>\n"
                                  "<dc:subject>{}</dc:subject>\n<dc:creator>{}</dc:creator>\n"
                                  "</rdf:Description>\n</rdf:RDF>\n</metadata>",
                                  Escaped(about.title), Escaped(about.description), Escaped(about.title),
                                  Escaped(about.description), Escaped(about.keywords), Escaped(about.software)));
  // cairo names the group after how many surfaces the process has made: no two files would be equal.
  const size_t group = svg.find("<g id=\"surface"), close = group == std::string::npos ? group : svg.find('>', group);
  if (close != std::string::npos) svg.replace(group, close - group, "<g id=\"plan\"");
  return svg;
}

SurfacePtr MakeSvg(const Sheet& sheet, std::string& file) {
  SurfacePtr surface(cairo_svg_surface_create_for_stream(Append, &file, sheet.size_mm.width, sheet.size_mm.height));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
  cairo_svg_surface_restrict_to_version(surface.get(), CAIRO_SVG_VERSION_1_1);
  return surface;
}

SurfacePtr MakePdf(const Sheet& sheet, const About& about, std::string& file) {
  SurfacePtr surface(cairo_pdf_surface_create_for_stream(Append, &file, sheet.size_mm.width * kPointsPerMm,
                                                         sheet.size_mm.height * kPointsPerMm));
  const auto set = [&surface](cairo_pdf_metadata_t what, const std::string& value) {
    cairo_pdf_surface_set_metadata(surface.get(), what, value.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, about.title);
  set(CAIRO_PDF_METADATA_SUBJECT, about.description);
  set(CAIRO_PDF_METADATA_KEYWORDS, about.keywords);
  set(CAIRO_PDF_METADATA_CREATOR, about.software);
  // Otherwise cairo writes the time of drawing, and no two files would be equal.
  set(CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
  return surface;
}

About ValidText(About about) {
  for (std::string* text : {&about.title, &about.description, &about.software, &about.keywords})
    *text = ValidUtf8(*text);
  return about;
}

}  // namespace

absl::StatusOr<std::string> DrawInDocument(const Sheet& sheet, const std::string& title,
                                           const v1::RenderOptions& options, const DrawingMetadata& metadata,
                                           const Drawing& draw) {
  const bool svg = options.format() == v1::PREVIEW_FORMAT_SVG;
  if (!svg && options.format() != v1::PREVIEW_FORMAT_PDF)
    return absl::InvalidArgumentError("options.format: a document is SVG or PDF");
  if (options.has_size_px()) return absl::InvalidArgumentError("options.size_px: not with SVG or PDF");
  if (options.has_dpi()) return absl::InvalidArgumentError("options.dpi: not with SVG or PDF");
  const About about = ValidText(AboutOf(title, sheet, metadata));
  std::string file;
  const SurfacePtr surface = svg ? MakeSvg(sheet, file) : MakePdf(sheet, about, file);
  {
    const CairoPtr cairo(cairo_create(surface.get()));
    const double units_per_mm = svg ? 1 : kPointsPerMm;
    cairo_scale(cairo.get(), units_per_mm, units_per_mm);
    cairo_set_tolerance(cairo.get(), kArcToleranceMm * units_per_mm);
    Canvas canvas(cairo.get());
    draw(canvas);
    cairo_show_page(cairo.get());
    RETURN_IF_ERROR(StatusOf(cairo_status(cairo.get())));
  }
  cairo_surface_finish(surface.get());
  RETURN_IF_ERROR(StatusOf(cairo_surface_status(surface.get())));
  return svg ? WithMetadata(std::move(file), about) : file;
}

absl::StatusOr<std::string> DrawPlanDocument(const v1::SolvedLayout& layout, const v1::RenderOptions& options,
                                             const DrawingMetadata& metadata) {
  ASSIGN_OR_RETURN(const PlanSheet made, MakePlanSheet(layout, options));
  return DrawInDocument(made.sheet, made.plan.title, options, metadata,
                        [&](Canvas& canvas) { DrawSheet(canvas, made.plan, made.sheet); });
}

}  // namespace flair::renderer
