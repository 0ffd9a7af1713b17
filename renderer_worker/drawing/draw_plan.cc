// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/draw_plan.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/sheet.h"
#include "renderer_worker/drawing/text.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

void DrawPaper(Canvas& canvas, const Sheet& sheet) {
  canvas.Rectangle({0, 0, sheet.size_mm.width, sheet.size_mm.height});
  canvas.Fill(kWhite);
  canvas.Rectangle(Box{0, 0, sheet.size_mm.width, sheet.size_mm.height}.Grown(-6));
  canvas.Draw({Hex(0x8A8379), 0.25});
}

namespace {

constexpr double kMmPerInch = 25.4;

absl::StatusOr<SurfacePtr> MakeImage(int width, int height) {
  SurfacePtr surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return ResourceExhausted("no memory for a picture of {} x {} pixels", width, height);
  }
  return surface;
}

// Scale and place of a room on a tile of `size_mm`, walls and outward doors included.
Sheet TileSheet(const Plan& plan, Size size_mm) {
  constexpr double kMarginMm = 2;
  Sheet sheet;
  sheet.size_mm = size_mm;
  sheet.plan_mm = Box{0, 0, size_mm.width, size_mm.height}.Grown(-kMarginMm);
  // A scale need not be round here; two rounds, because walls and doors take paper beside the room.
  double room_mm = 8;
  for (int round = 0; round < 2; ++round) {
    const double across = std::max(plan.bounds_m.width() / (sheet.plan_mm.width() - room_mm),
                                   plan.bounds_m.height() / (sheet.plan_mm.height() - room_mm));
    sheet.scale = std::max(1, static_cast<int>(std::ceil(1000 * across)));
    double beside = WallThicknessMm(sheet) + 1;
    for (size_t wall = 0; wall < plan.walls.size(); ++wall)
      beside = std::max(beside, OutwardReachMm(plan, sheet, static_cast<int>(wall)) + 1);
    room_mm = std::min(2 * beside, 0.5 * std::min(sheet.plan_mm.width(), sheet.plan_mm.height()));
  }
  const Point middle = plan.bounds_m.centre(), target = sheet.plan_mm.centre();
  sheet.origin_mm = {target.x - middle.x * sheet.mm_per_m(), target.y + middle.y * sheet.mm_per_m()};
  return sheet;
}

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

absl::StatusOr<PlanSheet> MakePlanSheet(const v1::SolvedLayout& layout, const v1::RenderOptions& options) {
  ASSIGN_OR_RETURN(const PlanLayers layers, LayersOf(options));
  ASSIGN_OR_RETURN(Plan plan, ReadPlan(layout, layers));
  ASSIGN_OR_RETURN(const Sheet sheet, ChooseSheet(plan, options));
  RETURN_IF_ERROR(CheckFonts());
  return PlanSheet{std::move(plan), sheet};
}

void DrawRoom(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  DrawFloor(canvas, plan, sheet);
  if (plan.layers.zones) DrawZones(canvas, plan, sheet);
  DrawRugs(canvas, plan, sheet);
  if (plan.layers.circulation) DrawRoutes(canvas, plan, sheet);
  DrawFurniture(canvas, plan, sheet);
  DrawWalls(canvas, plan, sheet);
  DrawOpenings(canvas, plan, sheet);
  DrawSockets(canvas, plan, sheet);
  DrawMounted(canvas, plan, sheet);
}

std::vector<PlacedLabel> DrawSheet(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  DrawPaper(canvas, sheet);
  canvas.Rectangle(sheet.plan_mm.Grown(4));
  canvas.Clip();
  DrawRoom(canvas, plan, sheet);
  DrawBlocked(canvas, plan, sheet);
  if (plan.layers.constraints) DrawConstraints(canvas, plan, sheet);
  DrawDimensions(canvas, plan, sheet);
  Plan numbered = plan;
  std::vector<PlacedLabel> labels = DrawLabels(canvas, sheet, numbered);
  canvas.Unclip();
  DrawSidePanel(canvas, numbered, sheet);
  return labels;
}

absl::Status StatusOf(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return absl::OkStatus();
  const std::string message = fmt::format("drawing failed: {}", cairo_status_to_string(status));
  return status == CAIRO_STATUS_NO_MEMORY ? absl::ResourceExhaustedError(message) : absl::InternalError(message);
}

absl::StatusOr<double> PixelsPerMm(const Sheet& sheet, const v1::RenderOptions& options) {
  if (!options.has_dpi()) {
    const int size_px = options.has_size_px() ? options.size_px() : kDefaultSizePx;
    if (size_px < 256 || size_px > 8192) return InvalidArgument("options.size_px: {}; must be in [256, 8192]", size_px);
    return size_px / std::max(sheet.size_mm.width, sheet.size_mm.height);
  }
  if (options.has_size_px()) return absl::InvalidArgumentError("options.dpi: not together with size_px");
  if (options.dpi() < 36 || options.dpi() > 1200) {
    return InvalidArgument("options.dpi: {}; must be in [36, 1200]", options.dpi());
  }
  const double most = std::floor(kMmPerInch * std::sqrt(kMostPixels / (sheet.size_mm.width * sheet.size_mm.height)));
  if (options.dpi() > most) {
    return InvalidArgument("options.dpi: {} is more than a picture of {} can have; at most {:.0f}", options.dpi(),
                           sheet.paper, most);
  }
  return options.dpi() / kMmPerInch;
}

void AppendPixels(cairo_surface_t* surface, Pixels& pixels) {
  cairo_surface_flush(surface);
  const int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
  pixels.width_px = width;
  pixels.height_px += height;
  const size_t before = pixels.rgb.size();
  pixels.rgb.resize(static_cast<size_t>(width) * pixels.height_px * 3);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  uint8_t* to = pixels.rgb.data() + before;
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<ptrdiff_t>(y) * stride);
    for (int x = 0; x < width; ++x, to += 3) {
      to[0] = static_cast<uint8_t>(row[x] >> 16);
      to[1] = static_cast<uint8_t>(row[x] >> 8);
      to[2] = static_cast<uint8_t>(row[x]);
    }
  }
}

absl::StatusOr<Pixels> DrawOnPixels(int width_px, int height_px, double px_per_mm, const Drawing& draw) {
  ASSIGN_OR_RETURN(const SurfacePtr surface, MakeImage(width_px, height_px));
  const CairoPtr cairo(cairo_create(surface.get()));
  cairo_scale(cairo.get(), px_per_mm, px_per_mm);
  Canvas canvas(cairo.get());
  draw(canvas);
  RETURN_IF_ERROR(StatusOf(cairo_status(cairo.get())));
  Pixels pixels;
  AppendPixels(surface.get(), pixels);
  return pixels;
}

absl::StatusOr<Pixels> DrawOnPixels(const Sheet& sheet, double px_per_mm, const Drawing& draw) {
  return DrawOnPixels(static_cast<int>(std::lround(sheet.size_mm.width * px_per_mm)),
                      static_cast<int>(std::lround(sheet.size_mm.height * px_per_mm)), px_per_mm, draw);
}

absl::StatusOr<DrawnPlan> DrawPlan(const v1::SolvedLayout& layout, const v1::RenderOptions& options,
                                   const std::string& remark) {
  ASSIGN_OR_RETURN(PlanSheet made, MakePlanSheet(layout, options));
  made.plan.remark = remark;
  const Sheet& sheet = made.sheet;
  ASSIGN_OR_RETURN(const double px_per_mm, PixelsPerMm(sheet, options));
  DrawnPlan drawn;
  ASSIGN_OR_RETURN(Pixels pixels, DrawOnPixels(sheet, px_per_mm, [&](Canvas& canvas) {
                     drawn.labels = DrawSheet(canvas, made.plan, sheet);
                   }));
  drawn.pixels = std::move(pixels);
  drawn.title = made.plan.title;
  drawn.scale = sheet.scale;
  drawn.paper = sheet.paper;
  return drawn;
}

absl::StatusOr<Pixels> DrawPlanTile(const v1::SolvedLayout& layout, int width_px, int height_px) {
  if (std::min(width_px, height_px) < 16 || std::max(width_px, height_px) > 4096) {
    return InvalidArgument("tile: {} x {} px; sides must be in [16, 4096]", width_px, height_px);
  }
  ASSIGN_OR_RETURN(const Plan plan, ReadPlan(layout, {.dimensions = false}));
  // As if printed 110 mm wide: line weights are millimetres.
  const double px_per_mm = std::max(width_px, height_px) / 110.0;
  const Sheet sheet = TileSheet(plan, {width_px / px_per_mm, height_px / px_per_mm});
  return DrawOnPixels(width_px, height_px, px_per_mm, [&](Canvas& canvas) {
    canvas.Rectangle({0, 0, sheet.size_mm.width, sheet.size_mm.height});
    canvas.Fill(kWhite);
    DrawRoom(canvas, plan, sheet);
  });
}

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
                                             const DrawingMetadata& metadata, const std::string& remark) {
  ASSIGN_OR_RETURN(PlanSheet made, MakePlanSheet(layout, options));
  made.plan.remark = remark;
  return DrawInDocument(made.sheet, made.plan.title, options, metadata,
                        [&](Canvas& canvas) { DrawSheet(canvas, made.plan, made.sheet); });
}

}  // namespace flair::renderer
