// SPDX-License-Identifier: GPL-3.0-or-later
// flair render: draws a stored layout.
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/job_options.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/progress/progress.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct RenderArguments : Options {
  using Options::Options;
  std::string& layout = Required("LAYOUT", "A layout: layout.pb or layout.json of a design");
  std::string& out = Required(
      "-o,--out FILE",
      "Where the picture goes; the extension chooses the format: png jpg tif, plans also svg pdf, views also exr");
  RenderFlags flags{command()};
  std::string& annotations =
      Text("--annotations FILE",
           "Views: write camera, ids, boxes and poses there as JSON; with .exr, FILE.json when left out");
  bool& no_annotations = Flag("--no-annotations", "Write no annotations beside an .exr", {"--annotations"});
  RendererFlags renderer{command()};
};

// Where the JSON goes; empty: nowhere.
absl::StatusOr<std::string> AnnotationsPath(const RenderArguments& arguments, const v1::RenderOptions& options) {
  if (options.view() == v1::PREVIEW_VIEW_PLAN) {
    if (arguments.annotations.empty()) return "";
    return absl::InvalidArgumentError("--annotations: is for ray-traced views; leave it out for a plan");
  }
  if (!arguments.annotations.empty()) return arguments.annotations;
  if (options.format() != v1::PREVIEW_FORMAT_EXR || arguments.no_annotations) return "";
  return arguments.out + ".json";
}

std::string WhatTakesLong(const v1::RenderOptions& options) {
  if (options.view() == v1::PREVIEW_VIEW_PLAN) return "drawing";
  return fmt::format("tracing {} paths of light per pixel", options.has_sample_count() ? options.sample_count() : 16);
}

absl::Status Render(const RenderArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::RenderOptions options, ReadRenderFlags(arguments.flags, arguments.out));
  ASSIGN_OR_RETURN(const std::string annotations, AnnotationsPath(arguments, options));
  ASSIGN_OR_RETURN(const LayoutFile layout, ReadLayoutFile(arguments.layout));
  for (const std::string& path : {arguments.out, annotations}) RETURN_IF_ERROR(CheckOutputFile(path));
  v1::RenderRequest request;
  request.set_request_id("flair-render");
  SetOrigin(layout, request);
  *request.mutable_options() = options;
  ASSIGN_OR_RETURN(std::unique_ptr<RendererClient> renderer, RendererClient::Open(arguments.renderer));
  ASSIGN_OR_RETURN(const v1::RenderResponse response, [&] {
    const SlowNote note(WhatTakesLong(options));
    return renderer->Render(request);
  }());
  const v1::Preview& preview = response.preview();
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, preview.image()));
  if (!annotations.empty()) RETURN_IF_ERROR(WriteOutputFile(annotations, ToJson(preview.annotations())));
  for (const v1::Diagnostic& diagnostic : response.diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}\n", arguments.out,
             preview.width_px() > 0 ? fmt::format("{} x {} px", preview.width_px(), preview.height_px())
                                    : fmt::format("{} KiB", (preview.image().size() + 1023) / 1024));
  if (!annotations.empty()) fmt::print(stderr, "{}: camera and objects\n", annotations);
  return absl::OkStatus();
}

}  // namespace

void AddRender(const Commands& program) {
  program.Add("render", "Draw a layout: a plan to scale, or a ray-traced view.", Render,
              "Files are written completely or not at all; the same layout and options give the same bytes. "
              "Examples:\n"
              "  flair render out/layout.pb --out plan.pdf --paper a4 --scale 1:50 --layers all\n"
              "  flair render out/layout.pb --view birdseye --out room.png --samples 64\n"
              "  flair render out/layout.pb --view perspective --out room.exr --size 512");
}

}  // namespace flair::cli
