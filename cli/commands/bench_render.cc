// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench render: measures pictures and scenes of stored layouts.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/bench/render_measure.h"
#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/command_line.h"
#include "cli/input/files.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr size_t kMostRooms = 10000;

struct BenchRenderArguments {
  std::string folder;
  std::string json;
  RenderBench bench;
  bool no_views = false;
  bool list = false;
};

absl::Status BenchRender(BenchRenderArguments arguments) {
  arguments.bench.views = !arguments.no_views;
  const absl::StatusOr<std::vector<std::filesystem::path>> folders =
      FindFoldersWith(arguments.folder, "layout.pb", kMostRooms);
  if (!folders.ok()) return folders.status();
  if (absl::Status status = CheckOutputFile(arguments.json); !status.ok()) return status;
  const std::unique_ptr<renderer::ImageWriter> writer = renderer::MakeImageWriter();
  std::vector<RenderMeasure> measures;
  bool loaded = false;
  for (const std::filesystem::path& folder : *folders) {
    const absl::StatusOr<LayoutFile> layout = ReadLayoutFile(folder / "layout.pb");
    if (!layout.ok()) return layout.status();
    const v1::SolvedLayout& solved = layout->artifact.solved_layout();
    const std::string room = folder.lexically_relative(arguments.folder).string();
    if (!loaded) {
      RenderBench once = arguments.bench;
      once.repeat_count = 1;
      if (const auto first = MeasureRenders(room, solved, once, *writer); !first.ok()) return first.status();
      loaded = true;
    }
    absl::StatusOr<RenderMeasure> measure = MeasureRenders(room, solved, arguments.bench, *writer);
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
             Counted(arguments.bench.repeat_count, "repeat"), arguments.bench.view_size_px,
             Counted(arguments.bench.sample_count, "path"), Counted(arguments.bench.thread_count, "thread"),
             RenderTable(measures));
  std::fflush(stdout);
  if (arguments.json.empty()) return absl::OkStatus();
  return WriteOutputFile(arguments.json, RenderJson(measures, arguments.bench));
}

}  // namespace

void AddBenchRender(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BenchRenderArguments>();
  CLI::App* command = program.get_subcommand("bench")->add_subcommand(
      "render", "Draw the layouts of a folder: CPU of plans, bird's-eye views and scenes.");
  command->add_option("DIR", arguments->folder, "Folder of designs, at any depth")->required();
  command
      ->add_option("--repeat", arguments->bench.repeat_count,
                   "Times that each is drawn, 1 to 100 (3); the quickest counts")
      ->type_name("N")
      ->check(WholeNumber(1, 100));
  command
      ->add_option("--size", arguments->bench.view_size_px,
                   "Longer side of the bird's-eye view in pixels, 256 to 4096 (1024)")
      ->type_name("PX")
      ->check(WholeNumber(256, 4096));
  command->add_option("--samples", arguments->bench.sample_count, "Its paths of light per pixel, 1 to 4096 (16)")
      ->type_name("N")
      ->check(WholeNumber(1, 4096));
  command->add_option("--threads", arguments->bench.thread_count, "Its threads, 1 to 256 (2)")
      ->type_name("N")
      ->check(WholeNumber(1, 256));
  command->add_flag("--no-views", arguments->no_views, "Leave the views out");
  command->add_flag("--list", arguments->list, "Every room, a line each");
  command->add_option("--json", arguments->json, "Write all figures there")->type_name("FILE");
  command->callback([arguments, &result] { result = BenchRender(*arguments); });
}

}  // namespace flair::cli
