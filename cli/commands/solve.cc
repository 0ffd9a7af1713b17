// SPDX-License-Identifier: GPL-3.0-or-later
// flair solve and flair resolve: a layout from a graph, and a layout after edits, with as little moved as they ask for.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/artifact_shelf.h"
#include "cli/input/job_options.h"
#include "cli/input/message_text.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/progress/progress.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct SolveArguments : Options {
  using Options::Options;
  std::string& graph = Required(
      "GRAPH", "A graph: graph.pb or graph.json of a design, digits of its id, or JOB/translation; may be edited");
  SourceFlags source{command()};
  std::string& out = Text("-o,--out FILE", "Where the layout (.pb) goes; variants beside it, as FILE-2, FILE-3");
  bool& stats = Flag("--stats", "Print stages, terms, violated constraints and measures");
  SolveFlags flags{command()};
  std::string& optimizer = Text("--optimizer HOST:PORT", "Use this server instead of the built-in one");
};

// A layout as an artifact that was made from another one, with these options.
v1::Artifact MadeFrom(const v1::Artifact& source, const google::protobuf::Message& options,
                      const v1::Producer& producer, const v1::SolvedLayout& layout) {
  v1::Artifact artifact;
  artifact.add_made_from_ids(source.id());
  *artifact.mutable_producer() = producer;
  artifact.set_options_digest(runtime::Sha256Hex(runtime::CanonicalBytes(options)));
  *artifact.mutable_solved_layout() = layout;
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  return artifact;
}

absl::Status Solve(const SolveArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact graph, OpenArtifact(arguments.graph, arguments.source));
  if (!graph.has_layout_graph()) {
    return InvalidArgument("{}: not a graph; give the graph.pb of a design or of flair-dev import flairgpt",
                           arguments.graph);
  }
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  ASSIGN_OR_RETURN(v1::SolveOptions options, ReadSolveFlags(arguments.flags));
  v1::SolveRequest request;
  request.set_request_id("flair-solve");
  *request.mutable_layout_graph() = graph.layout_graph();
  *request.mutable_options() = std::move(options);
  ASSIGN_OR_RETURN(const v1::SolveResponse response, CallSolve(request, arguments.optimizer));

  // The number of threads changes no result, so it is none of what the layout was made with.
  v1::SolveOptions made_with = request.options();
  made_with.clear_thread_count();
  std::vector<std::string> files;
  const std::vector<v1::SolvedLayout> layouts = VariantLayouts(response.solved_layout(), request.options());
  for (size_t i = 0; i < layouts.size(); ++i) {
    const v1::Artifact artifact = MadeFrom(graph, made_with, response.producer(), layouts[i]);
    if (i == 0) {
      fmt::print(stderr, "{}{}\n", arguments.out.empty() ? "" : arguments.out + ": ",
                 orchestrator::Summarize(artifact));
    }
    if (arguments.out.empty()) continue;
    const std::string path = VariantPath(arguments.out, static_cast<int>(i) + 1);
    RETURN_IF_ERROR(WriteOutputFile(path, ArtifactBytes(artifact)));
    files.push_back(std::filesystem::path(path).filename().string());
  }
  fmt::print(stderr, "{}", LayoutRemarks(layouts.front()));
  if (arguments.stats) fmt::print("{}", SolveStats(response));
  if (request.options().variant_count() > 1) {
    fmt::print("{}{}", arguments.stats ? "\n" : "", VariantsTable(response.solved_layout(), files));
  }
  if (static_cast<int>(layouts.size()) < request.options().variant_count()) {
    fmt::print(stderr, "{:<11}{}\n", "variants", FewerVariants(layouts.size(), request.options().variant_count()));
  }
  if (arguments.out.empty()) {
    fmt::print(stderr, "{:<11}--out FILE saves the layout\n", "next");
  } else {
    fmt::print(stderr, "{:<11}flair render {} --out plan.png\n", "next", arguments.out);
  }
  return absl::OkStatus();
}

struct ResolveArguments : Options {
  using Options::Options;
  std::string& layout =
      Required("LAYOUT", "A layout: layout.pb or layout.json of a design, digits of its id, or JOB/solve");
  SourceFlags source{command()};
  std::string& out = Required("-o,--out FILE", "Where the layout (.pb) goes");
  std::vector<std::string>& edits = List("--edit TEXT", "A change, see below; may be repeated");
  std::string& edits_file = Text("--edits FILE", "Changes as protobuf text: edits { ... }; applied after all --edit");
  int64_t& seed = SeedNumber("Seed; another seed gives another layout (0)");
  bool& leave_out = Flag("--leave-out", "Leave out what does not fit");
  std::string& optimizer = Text("--optimizer HOST:PORT", "Use this server instead of the built-in one");
};

constexpr char kEditsExample[] = "changes, such as: edits { pin_object_id: \"bed\" }";

absl::StatusOr<v1::ResolveRequest> MakeRequest(const ResolveArguments& arguments, const v1::Artifact& layout) {
  v1::ResolveRequest request;
  request.set_request_id("flair-resolve");
  *request.mutable_solved_layout() = layout.solved_layout();
  for (const std::string& line : arguments.edits) {
    ASSIGN_OR_RETURN(v1::LayoutEdit edit, optimizer::EditFromText(line, layout.solved_layout()));
    *request.add_edits() = std::move(edit);
  }
  if (!arguments.edits_file.empty()) {
    v1::ResolveRequest read;
    RETURN_IF_ERROR(ReadTextMessage("--edits", arguments.edits_file, kEditsExample, read));
    request.mutable_edits()->MergeFrom(read.edits());
  }
  if (request.edits().empty())
    return absl::InvalidArgumentError("no edits; give --edit \"move desk 0.3 1.5 270\" or --edits FILE");
  request.mutable_options()->set_seed(arguments.seed);
  if (arguments.leave_out) request.mutable_options()->set_misfit_policy(v1::MISFIT_POLICY_LEAVE_OUT);
  return request;
}

// "floor_1 (chair), floor_2 (armchair)": people know things by their names.
std::string Moved(const v1::ResolveResponse& response) {
  std::vector<std::string> texts;
  for (const std::string& id : response.moved_object_ids()) {
    std::string& text = texts.emplace_back(id);
    for (const v1::Object& object : response.solved_layout().graph().object_list().objects()) {
      if (object.id() == id && object.name() != id) text += " (" + object.name() + ")";
    }
  }
  return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, ", "));
}

absl::Status Resolve(const ResolveArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact before, OpenArtifact(arguments.layout, arguments.source));
  if (!before.has_solved_layout()) {
    return InvalidArgument("{}: not a layout; give a layout.pb of flair solve or flair design", arguments.layout);
  }
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  ASSIGN_OR_RETURN(const v1::ResolveRequest request, MakeRequest(arguments, before));
  ASSIGN_OR_RETURN(const v1::ResolveResponse response, CallResolve(request, arguments.optimizer));

  const v1::Artifact layout = MadeFrom(before, request.options(), response.producer(), response.solved_layout());
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, ArtifactBytes(layout)));
  fmt::print(stderr, "{}: {}\n", arguments.out, orchestrator::Summarize(layout));
  fmt::print(stderr, "{:<11}{}\n", "moved", Moved(response));
  fmt::print(stderr, "{}", LayoutRemarks(response.solved_layout()));
  fmt::print(stderr, "{:<11}flair render {} --out plan.png\n", "next", arguments.out);
  return absl::OkStatus();
}

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

void AddSolve(const Commands& program) { program.Add("solve", "Place the objects of a graph again.", Solve); }

void AddResolve(const Commands& program) {
  program.Add(
      "resolve", "Change a layout and solve again what the change affects.", Resolve,
      "Changes:\n"
      "  move desk 0.3 1.5 270       pin bed        unpin bed       remove plant_1\n"
      "  resize wardrobe 1.5x0.6x2.1                add lamp 0.4x0.4x1.5 near sofa\n"
      "  weight e17 3                drop e17\n"
      "  edge against_wall object=desk side=back\n"
      "Metres and degrees, counter-clockwise: 0 faces north, 90 west. Moved objects are pinned. flair inspect LAYOUT "
      "lists the ids of objects and constraints. See docs/resolve.md.");
}

void AddRender(const Commands& program) {
  program.Add("render", "Draw a layout: a plan to scale, or a ray-traced view.", Render,
              "Files are written completely or not at all; the same layout and options give the same bytes. "
              "Examples:\n"
              "  flair render out/layout.pb --out plan.pdf --paper a4 --scale 1:50 --layers all\n"
              "  flair render out/layout.pb --view birdseye --out room.png --samples 64\n"
              "  flair render out/layout.pb --view perspective --out room.exr --size 512");
}

}  // namespace flair::cli
