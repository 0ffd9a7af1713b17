// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench render: measures pictures and scenes of stored layouts.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/bench/render_measure.h"
#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/files.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr size_t kMostRooms = 10000;

struct BenchRenderArguments : Options {
  using Options::Options;
  std::string& folder = Required("DIR", "Folder of designs, at any depth");
  int& repeats = Whole("--repeat N", 1, 100, RenderBench().repeat_count,
                       "Times that each is drawn, 1 to 100 (3); the quickest counts");
  int& size_px = Whole("--size PX", 256, 4096, RenderBench().view_size_px,
                       "Longer side of the bird's-eye view in pixels, 256 to 4096 (1024)");
  int& samples =
      Whole("--samples N", 1, 4096, RenderBench().sample_count, "Its paths of light per pixel, 1 to 4096 (16)");
  int& threads = Whole("--threads N", 1, 256, RenderBench().thread_count, "Its threads, 1 to 256 (2)");
  bool& no_views = Flag("--no-views", "Leave the views out");
  bool& list = Flag("--list", "Every room, a line each");
  std::string& json = Text("--json FILE", "Write all figures there");
};

absl::Status BenchRender(const BenchRenderArguments& arguments) {
  RenderBench bench;
  bench.repeat_count = arguments.repeats;
  bench.view_size_px = arguments.size_px;
  bench.sample_count = arguments.samples;
  bench.thread_count = arguments.threads;
  bench.views = !arguments.no_views;
  ASSIGN_OR_RETURN(const std::vector<std::filesystem::path> folders,
                   FindFoldersWith(arguments.folder, "layout.pb", kMostRooms));
  RETURN_IF_ERROR(CheckOutputFile(arguments.json));
  const std::unique_ptr<renderer::ImageWriter> writer = renderer::MakeImageWriter();
  std::vector<RenderMeasure> measures;
  for (const std::filesystem::path& folder : folders) {
    ASSIGN_OR_RETURN(const LayoutFile layout, ReadLayoutFile(folder / "layout.pb"));
    const v1::SolvedLayout& solved = layout.artifact.solved_layout();
    const std::string room = folder.lexically_relative(arguments.folder).string();
    // The first picture loads what all of them need.
    if (measures.empty()) {
      RenderBench once = bench;
      once.repeat_count = 1;
      RETURN_IF_ERROR(MeasureRenders(room, solved, once, *writer).status());
    }
    absl::StatusOr<RenderMeasure> measure = MeasureRenders(room, solved, bench, *writer);
    if (!measure.ok()) {
      return absl::Status(measure.status().code(),
                          fmt::format("{}: {}", folder.string(), std::string(measure.status().message())));
    }
    if (arguments.list) {
      fmt::print("{:<34}{:>4} objects", room, measure->object_count);
      for (int kind = 0; kind < kRenderKindCount; ++kind) {
        if (measure->cpu_s[kind] >= 0) fmt::print("{:>9.1f} ms", 1e3 * measure->cpu_s[kind]);
      }
      fmt::print("\n");
    }
    measures.push_back(*std::move(measure));
  }
  fmt::print("{}, {}, views of {} px with {} per pixel on {}\n{}", Counted(std::ssize(measures), "room"),
             Counted(bench.repeat_count, "repeat"), bench.view_size_px, Counted(bench.sample_count, "path"),
             Counted(bench.thread_count, "thread"), RenderTable(measures));
  if (arguments.json.empty()) return absl::OkStatus();
  return WriteOutputFile(arguments.json, RenderJson(measures, bench));
}

}  // namespace

void AddBenchRender(const Commands& bench) {
  bench.Add("render", "Draw the layouts of a folder: CPU of plans, bird's-eye views and scenes.", BenchRender);
}

}  // namespace flair::cli
