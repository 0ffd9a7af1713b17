// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/stage_calls.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "absl/time/clock.h"
#include "cli/embedded/embedded_services.h"
#include "cli/input/artifact_file.h"
#include "cli/input/job_options.h"
#include "cli/output/artifact_text.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "orchestrator/store/artifact_id.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/in_process_server.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kWithin = absl::Hours(12);
// An EXR of 3,800 x 3,800 px.
constexpr int kMessageMib = 500;

absl::StatusOr<std::unique_ptr<runtime::InProcessServer>> StartRenderer(const RendererChoice& choice) {
  config::v1::RendererWorkerConfig config;
  // What of a user's models cannot be used is told as they are read.
  config.mutable_runtime()->set_log_level(choice.asset_folder.empty() ? "error" : "warning");
  config.mutable_runtime()->set_max_message_mib(kMessageMib);
  config.set_asset_folder_path(choice.asset_folder);
  if (choice.thread_count > 0) config.set_tracing_thread_count(choice.thread_count);
  return runtime::InProcessServer::Start("flair-renderer", config.runtime(), v1::RendererService::service_full_name(),
                                         [&](runtime::WorkerContext& context) {
                                           context.build = runtime::BuildName();
                                           return renderer::MakeRendererService(config, context, UsedModels().renderer);
                                         });
}

}  // namespace

RendererFlags::RendererFlags(CLI::App& command) : Options(command) {
  Bind("--renderer HOST:PORT", address, "Use this server instead of the built-in one");
  Bind("--assets DIR", asset_folder,
       "Folder of 3D models with a manifest (docs/assets.md), for furniture that one of them fits", {"--renderer"});
}

struct RendererClient::Server {
  const std::string address;
  std::unique_ptr<runtime::InProcessServer> own = nullptr;
  std::unique_ptr<v1::RendererService::StubInterface> stub = nullptr;

  absl::Status Explain(const absl::Status& status) const {
    return address.empty() ? status : InWords(kRendererStage, address, status);
  }

  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (v1::RendererService::StubInterface::*method)(grpc::ClientContext*,
                                                                                          const Request&, Response*),
                               const Request& request) const {
    runtime::CallContext call;
    absl::StatusOr<Response> response = runtime::UnaryRequest(*stub, method, request, call, absl::Now() + kWithin);
    if (!response.ok()) return Explain(response.status());
    return response;
  }
};

RendererClient::RendererClient(std::unique_ptr<Server> server) : server_(std::move(server)) {}
RendererClient::~RendererClient() = default;

absl::StatusOr<std::unique_ptr<RendererClient>> RendererClient::Open(const RendererChoice& choice) {
  std::unique_ptr<Server> server(new Server{.address = choice.address});
  std::shared_ptr<grpc::Channel> channel;
  if (choice.address.empty()) {
    ASSIGN_OR_RETURN(server->own, StartRenderer(choice));
    channel = server->own->channel();
  } else {
    ASSIGN_OR_RETURN(channel, ConnectToStage(kRendererStage, choice.address, kMessageMib));
  }
  server->stub = v1::RendererService::NewStub(channel);
  return std::unique_ptr<RendererClient>(new RendererClient(std::move(server)));
}

absl::StatusOr<v1::RenderResponse> RendererClient::Render(const v1::RenderRequest& request) {
  return server_->Ask(&v1::RendererService::StubInterface::Render, request);
}

absl::StatusOr<v1::ExportSceneResponse> RendererClient::ExportScene(const v1::ExportSceneRequest& request) {
  return server_->Ask(&v1::RendererService::StubInterface::ExportScene, request);
}

absl::StatusOr<v1::ComposeContactSheetResponse> RendererClient::ComposeContactSheet(
    const v1::ContactSheetOptions& options, const std::function<v1::ContactSheetTile(int)>& tile_of) {
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + kWithin));
  v1::ComposeContactSheetResponse response;
  const auto writer = server_->stub->ComposeContactSheet(&context, &response);
  v1::ComposeContactSheetRequest request;
  *request.mutable_options() = options;
  bool is_wanted = writer->Write(request);
  for (int i = 0; is_wanted && i < options.tile_count(); ++i) {
    *request.mutable_tile() = tile_of(i);
    is_wanted = writer->Write(request);
  }
  writer->WritesDone();
  const grpc::Status status = writer->Finish();
  if (!status.ok()) return server_->Explain(runtime::FromGrpcStatus(status));
  return response;
}

namespace {

constexpr absl::Duration kStageWithin = absl::Minutes(10);

template <typename Service, typename Request, typename Response>
absl::StatusOr<Response> Call(const Request& request, const StageName& name, const std::string& address,
                              orchestrator::StageChannel orchestrator::StageChannels::*stage,
                              grpc::Status (Service::StubInterface::*method)(grpc::ClientContext*, const Request&,
                                                                             Response*)) {
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (address.empty()) {
    ASSIGN_OR_RETURN(services, EmbeddedServices::StartStages());
    channel = (services->stages().*stage).channel;
  } else {
    ASSIGN_OR_RETURN(channel, ConnectToStage(name, address));
  }
  const std::unique_ptr<typename Service::Stub> stub = Service::NewStub(channel);
  runtime::CallContext call;
  absl::StatusOr<Response> response = runtime::UnaryRequest(*stub, method, request, call, absl::Now() + kStageWithin);
  if (response.ok() || address.empty()) return response;
  return InWords(name, address, response.status());
}

}  // namespace

absl::StatusOr<v1::SolveResponse> CallSolve(const v1::SolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, kOptimizerStage, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Solve);
}

absl::StatusOr<v1::ConstraintCatalog> CallListConstraintTypes(const std::string& address) {
  if (address.empty()) return optimizer::MakeCatalog();
  ASSIGN_OR_RETURN(v1::ListConstraintTypesResponse response,
                   Call<v1::OptimizerService>(v1::ListConstraintTypesRequest(), kOptimizerStage, address,
                                              &orchestrator::StageChannels::optimizer,
                                              &v1::OptimizerService::StubInterface::ListConstraintTypes));
  return std::move(*response.mutable_catalog());
}

absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, kOptimizerStage, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Resolve);
}

namespace {

constexpr int kDefaultSizePx = 2400;
constexpr size_t kMostLetters = 190;

bool IsDocument(v1::PreviewFormat format) {
  return format == v1::PREVIEW_FORMAT_SVG || format == v1::PREVIEW_FORMAT_PDF;
}

// What the contract takes for a caption: the end of a long path says more than its beginning.
std::string EndOf(const std::string& text) {
  if (text.size() <= kMostLetters) return text;
  size_t from = text.size() - kMostLetters;
  while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xC0) == 0x80) ++from;
  return "..." + text.substr(from);
}

}  // namespace

absl::Status CheckPicture(const PlansBeside& plans) {
  const absl::StatusOr<v1::PreviewFormat> format = FormatOfFile(plans.picture);
  if (!format.ok() || *format == v1::PREVIEW_FORMAT_EXR) {
    return InvalidArgument("--picture: {}: its extension chooses the format: png, jpg, jpeg, tif, tiff, svg, pdf",
                           plans.picture);
  }
  if (IsDocument(*format) && plans.size_px.has_value()) {
    return InvalidArgument("--size: {}: not with --picture {}, which has no pixels", *plans.size_px, plans.picture);
  }
  return CheckOutputFile(plans.picture);
}

absl::Status DrawPlansBeside(const PlansBeside& plans) {
  RETURN_IF_ERROR(CheckPicture(plans));
  v1::RenderRequest request;
  request.set_request_id("flair-beside");
  const PlanBeside& first = plans.plans.front();
  *request.mutable_solved_layout() = first.layout;
  request.set_caption(EndOf(first.caption));
  request.set_remark(EndOf(first.remark));
  for (size_t i = 1; i < plans.plans.size(); ++i) {
    const PlanBeside& plan = plans.plans[i];
    v1::ComparedLayout& beside = *request.add_beside();
    *beside.mutable_solved_layout() = plan.layout;
    beside.set_caption(EndOf(plan.caption));
    beside.set_remark(EndOf(plan.remark));
    beside.mutable_changes()->Add(plan.changes.begin(), plan.changes.end());
  }
  request.mutable_options()->set_format(*FormatOfFile(plans.picture));
  if (!IsDocument(request.options().format())) {
    request.mutable_options()->set_size_px(plans.size_px.value_or(kDefaultSizePx));
  }
  ASSIGN_OR_RETURN(std::unique_ptr<RendererClient> renderer, RendererClient::Open(plans.renderer));
  ASSIGN_OR_RETURN(const v1::RenderResponse response, [&] {
    const SlowNote note("drawing");
    return renderer->Render(request);
  }());
  RETURN_IF_ERROR(WriteOutputFile(plans.picture, response.preview().image()));
  for (const v1::Diagnostic& diagnostic : response.diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}\n", plans.picture, Counted(std::ssize(plans.plans), "plan"));
  return absl::OkStatus();
}

absl::Status CheckViews(const std::vector<std::string>& names) {
  for (const std::string& name : names) RETURN_IF_ERROR(ViewOfName(name).status());
  return absl::OkStatus();
}

absl::StatusOr<std::vector<OutputFile>> DrawViews(const std::vector<std::string>& names, const RendererChoice& choice,
                                                  const v1::Artifact& layout, const v1::Brief& brief, bool quiet) {
  std::vector<OutputFile> files;
  const LayoutFile from{.artifact = layout, .brief = brief};
  std::unique_ptr<RendererClient> renderer;
  for (const std::string& name : names) {
    ASSIGN_OR_RETURN(const v1::PreviewView view, ViewOfName(name));
    if (view == v1::PREVIEW_VIEW_PLAN) continue;
    if (renderer == nullptr) {
      ASSIGN_OR_RETURN(renderer, RendererClient::Open(choice));
    }
    v1::RenderRequest request;
    SetOrigin(from, request);
    request.mutable_options()->set_view(view);
    request.mutable_options()->set_format(v1::PREVIEW_FORMAT_PNG);
    std::optional<SlowNote> note;
    if (!quiet) note.emplace("drawing " + name);
    ASSIGN_OR_RETURN(v1::RenderResponse response, renderer->Render(request));
    files.push_back({name + ".png", std::move(*response.mutable_preview()->mutable_image())});
  }
  return files;
}

std::vector<v1::SolvedLayout> VariantLayouts(const v1::SolvedLayout& layout, const v1::SolveOptions& options) {
  std::vector<v1::SolvedLayout> layouts = {layout};
  const optimizer::NloptSolver solver;
  for (int i = 0; i < layout.runner_ups_size(); ++i) {
    if (!IsComplete(layout.runner_ups(i))) continue;
    v1::SolvedLayout& variant = layouts.emplace_back(VariantOf(layout, i));
    v1::EvaluateRequest evaluate;
    *evaluate.mutable_layout_graph() = variant.graph();
    *evaluate.mutable_placements() = variant.placements();
    *evaluate.mutable_options() = options;
    const absl::StatusOr<v1::EvaluateResponse> terms = optimizer::EvaluateLayout(evaluate, solver);
    // Another optimizer's library may be unknown here.
    if (!terms.ok()) continue;
    *variant.mutable_term_outcomes() = terms->term_outcomes();
    double total = 0;
    for (const v1::EdgeOutcome& edge : variant.edge_outcomes()) total += edge.weighted_cost();
    for (const v1::TermOutcome& term : variant.term_outcomes()) total += term.cost() * term.factor();
    variant.set_total_cost(total);
  }
  return layouts;
}

std::string VariantPath(const std::string& out, int number) {
  if (number == 1) return out;
  const std::filesystem::path path(out);
  return (path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string()))
      .string();
}

std::string FewerVariants(size_t found, int wanted) {
  return fmt::format("{} of {} layouts: no more were found that differ visibly; more --restarts may find some", found,
                     wanted);
}

absl::StatusOr<std::vector<OutputFile>> MakeVariantFiles(const v1::Artifact& layout, const v1::SolveOptions& options,
                                                         const RendererChoice& renderer) {
  const std::vector<v1::SolvedLayout> layouts = VariantLayouts(layout.solved_layout(), options);
  v1::ContactSheetOptions sheet;
  sheet.set_request_id("flair-variants");
  sheet.set_title(Shortened(layout.solved_layout().graph().room().title(), 200));
  sheet.set_tile_count(static_cast<int>(layouts.size()));
  sheet.set_format(v1::PREVIEW_FORMAT_PNG);
  ASSIGN_OR_RETURN(const std::unique_ptr<RendererClient> client, RendererClient::Open(renderer));
  const auto tile_of = [&layouts](int i) {
    const v1::SolvedLayout& shown = layouts[static_cast<size_t>(i)];
    v1::ContactSheetTile tile;
    tile.set_caption(VariantPath("layout.pb", i + 1));
    tile.set_remark(LayoutLine(shown));
    *tile.mutable_solved_layout() = shown;
    return tile;
  };
  ASSIGN_OR_RETURN(v1::ComposeContactSheetResponse response, client->ComposeContactSheet(sheet, tile_of));
  std::vector<OutputFile> files;
  for (size_t i = 1; i < layouts.size(); ++i) {
    v1::Artifact artifact = layout;
    *artifact.mutable_solved_layout() = layouts[i];
    artifact.set_id(orchestrator::ComputeArtifactId(artifact));
    files.push_back({VariantPath("layout.pb", static_cast<int>(i) + 1), ArtifactBytes(artifact)});
  }
  files.push_back({kVariantsPicture, std::move(*response.mutable_sheet()->mutable_image())});
  return files;
}

}  // namespace flair::cli
