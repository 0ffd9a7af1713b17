// SPDX-License-Identifier: GPL-3.0-or-later
// Single stages called alone, in this process or at an address: the renderer, the optimizer.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/options.h"
#include "cli/output/output_folder.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

// Which renderer draws: the one at `address`, or one in this process.
struct RendererChoice {
  std::string address;
  std::string asset_folder;  // of the one in this process; empty: none
  int thread_count = 0;      // of the one in this process, for a ray-traced view; 0: all cores
};

struct RendererFlags : Options, RendererChoice {
  explicit RendererFlags(CLI::App& command);
};

// A renderer to call. Waits for hours: a view of many samples takes its time.
class RendererClient {
 public:
  static absl::StatusOr<std::unique_ptr<RendererClient>> Open(const RendererChoice& choice);
  ~RendererClient();

  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest& request);
  absl::StatusOr<v1::ExportSceneResponse> ExportScene(const v1::ExportSceneRequest& request);
  // A contact sheet of the tiles that `tile_of` makes, from 0 to options.tile_count(), each when it is to be sent; none
  // more once the renderer wants none.
  absl::StatusOr<v1::ComposeContactSheetResponse> ComposeContactSheet(
      const v1::ContactSheetOptions& options, const std::function<v1::ContactSheetTile(int)>& tile_of);

 private:
  struct Server;
  explicit RendererClient(std::unique_ptr<Server> server);
  const std::unique_ptr<Server> server_;
};

// Single stages, each run from its input artifact: in this process, or at an address.

// `address` empty: a worker in this process.
absl::StatusOr<v1::SolveResponse> CallSolve(const v1::SolveRequest& request, const std::string& address);
// The catalogue of that worker; of ours without asking.
absl::StatusOr<v1::ConstraintCatalog> CallListConstraintTypes(const std::string& address);
absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address);

// Pictures that commands draw of layouts.

struct PlanBeside {
  v1::SolvedLayout layout;
  std::string caption;
  std::string remark;
  // What became of the first plan's objects; none for the first itself.
  std::vector<v1::ObjectChange> changes;
};

struct PlansBeside {
  std::string picture;  // its ending says the format
  std::optional<int> size_px;
  RendererChoice renderer;
  std::vector<PlanBeside> plans = {};  // at least 2, at most 8
};

// Whether the picture can be drawn to that file; for before the work. INVALID_ARGUMENT for an ending that says no
// format of plans, or sizes of a format without pixels.
absl::Status CheckPicture(const PlansBeside& plans);

// Draws and writes it. Errors as RendererClient and WriteOutputFile.
absl::Status DrawPlansBeside(const PlansBeside& plans);

// Ray-traced pictures that a design gets beside its plan.

// INVALID_ARGUMENT for a name that is none of plan, birdseye and perspective.
absl::Status CheckViews(const std::vector<std::string>& names);

// "birdseye.png" and so on: the same bytes as `flair render` makes of the layout with this renderer. The plan is left
// out, which every design has.
absl::StatusOr<std::vector<OutputFile>> DrawViews(const std::vector<std::string>& names, const RendererChoice& choice,
                                                  const v1::Artifact& layout, const v1::Brief& brief, bool quiet);

// Layouts of one room that differ visibly: the best one and its complete runner-ups.

// The layout first, then its complete runner-ups, best first, each with the whole-room terms that runner-ups lack.
std::vector<v1::SolvedLayout> VariantLayouts(const v1::SolvedLayout& layout, const v1::SolveOptions& options);

// Where variant `number` (from 1 on) goes: "layout.pb" is followed by "layout-2.pb", "layout-3.pb".
std::string VariantPath(const std::string& out, int number);

// "3 of 6 layouts: no more were found that differ visibly; ...".
std::string FewerVariants(size_t found, int wanted);

// The files that a design of several variants has beside its others: layout-2.pb and so on, and variants.png, which
// shows them all.
absl::StatusOr<std::vector<OutputFile>> MakeVariantFiles(const v1::Artifact& layout, const v1::SolveOptions& options,
                                                         const RendererChoice& renderer);

}  // namespace flair::cli
