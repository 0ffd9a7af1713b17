// SPDX-License-Identifier: GPL-3.0-or-later
// flair render: draws a stored layout.
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands/commands.h"
#include "cli/input/files.h"
#include "cli/output/output_folder.h"
#include "cli/session/stage_call.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

struct RenderArguments {
  std::string layout;
  std::string out;
  std::string renderer;
  std::optional<int> size_px;
};

absl::Status Render(const RenderArguments& arguments) {
  const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(arguments.layout);
  if (!artifact.ok()) return artifact.status();
  if (!artifact->has_solved_layout()) {
    return absl::InvalidArgumentError(
        fmt::format("{}: not a layout; give the layout.pb of a design", arguments.layout));
  }
  if (absl::Status status = CheckArtifactId(*artifact, arguments.layout); !status.ok()) return status;
  v1::RenderRequest request;
  request.set_request_id("flair-render");
  *request.mutable_solved_layout() = artifact->solved_layout();
  if (arguments.size_px) request.mutable_options()->set_size_px(*arguments.size_px);
  request.set_job_id(artifact->id());
  const absl::StatusOr<v1::RenderResponse> response = CallRender(request, arguments.renderer);
  if (!response.ok()) return response.status();
  if (absl::Status status = WriteOutputFile(arguments.out, response->preview().image()); !status.ok()) return status;
  fmt::print(stderr, "{}: {} x {} px\n", arguments.out, response->preview().width_px(),
             response->preview().height_px());
  return absl::OkStatus();
}

}  // namespace

void AddRender(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = program.add_subcommand("render", "Draw a layout again.");
  command->add_option("LAYOUT", arguments->layout, "layout.pb or layout.json of a design")->required();
  command->add_option("-o,--out", arguments->out, "Where the PNG goes")->required()->type_name("FILE");
  command->add_option("--size", arguments->size_px, "Longer side in pixels, 256 to 8192 (1600)")
      ->type_name("PX")
      ->check(CLI::Range(256, 8192));
  command->add_option("--renderer", arguments->renderer, "Use this one instead of an own one")->type_name("HOST:PORT");
  command->callback([arguments, &result] { result = Render(*arguments); });
}

}  // namespace flair::cli
