// SPDX-License-Identifier: GPL-3.0-or-later
// flair studio: rooms in a browser.
#include <poll.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/embedded/embedded_services.h"
#include "cli/explain/layout_note.h"
#include "cli/input/artifact_file.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/output/report_text.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "flair/v1/studio_service.grpc.pb.h"
#include "fmt/format.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "session/documents.h"
#include "studio/gateway/gateway.h"
#include "studio/service/make_studio_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/grpc/in_process_server.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct StudioArguments : Options {
  using Options::Options;
  int& port = Whole("--port N", 0, 65535, 0, "Port of 127.0.0.1 to serve on; 0 takes a free one (0)");
  StageFlags stages{command()};
  LlmFlags llm{command()};
};

// What a page may ask of the orchestrator, beside documents.
const std::vector<std::string>& JobMethods() {
  static const std::vector<std::string>& methods = *new std::vector<std::string>{
      "ListJobs",    "GetJob",      "CancelJob",  "ListBatches", "GetBatch",   "PauseBatch",
      "ResumeBatch", "CancelBatch", "RetryBatch", "GetCluster",  "GetArtifact"};
  return methods;
}

v1::ObjectKind KindOf(language::hb::FurnitureKind kind) {
  switch (kind) {
    case language::hb::FURNITURE_KIND_WALL:
      return v1::OBJECT_KIND_WALL;
    case language::hb::FURNITURE_KIND_CEILING:
      return v1::OBJECT_KIND_CEILING;
    case language::hb::FURNITURE_KIND_SURFACE:
      return v1::OBJECT_KIND_SURFACE;
    default:
      return v1::OBJECT_KIND_FLOOR;
  }
}

// The handbook's classes, in their usual sizes.
absl::StatusOr<std::vector<v1::FurnitureOffer>> Offers(const StageChoice& stages) {
  const std::vector<std::filesystem::path> overlays(stages.handbooks.begin(), stages.handbooks.end());
  ASSIGN_OR_RETURN(const auto handbook, language::LoadHandbook(language::DefaultHandbookFolder(), overlays));
  std::vector<v1::FurnitureOffer> offers;
  for (const language::hb::Furniture& furniture : handbook->contents().furniture()) {
    v1::FurnitureOffer& offer = offers.emplace_back();
    offer.set_group(furniture.category());
    v1::Object& object = *offer.mutable_object();
    object.set_name(furniture.name());
    object.set_category(furniture.category());
    object.set_kind(KindOf(furniture.kind()));
    object.set_role(object.kind() == v1::OBJECT_KIND_FLOOR && !furniture.walk_over() ? v1::OBJECT_ROLE_SECONDARY
                                                                                     : v1::OBJECT_ROLE_TERTIARY);
    object.set_width_m(furniture.width_m().typical());
    object.set_depth_m(furniture.depth_m().typical());
    object.set_height_m(furniture.height_m().typical());
    object.set_elevation_m(furniture.elevation_m());
    object.set_walk_over(furniture.walk_over());
    object.set_round(furniture.round());
  }
  return offers;
}

absl::StatusOr<v1::Artifact> ReadUpload(const std::string& bytes) {
  // Its ending is not known: the bytes say what it is.
  ASSIGN_OR_RETURN(ArtifactFile file, ParseArtifactFile("file", bytes));
  RETURN_IF_ERROR(file.whole);
  RETURN_IF_ERROR(file.good);
  return std::move(file.artifact);
}

absl::StatusOr<session::DocumentParts> Parts(const StageChoice& stages) {
  session::DocumentParts parts;
  ASSIGN_OR_RETURN(parts.furniture, Offers(stages));
  parts.read_file = ReadUpload;
  parts.not_as_asked = NotAsAsked;
  parts.note_json = [](const v1::SolvedLayout& layout,
                       const v1::ConstraintCatalog& catalog) -> absl::StatusOr<std::string> {
    ASSIGN_OR_RETURN(const Note note, MakeLayoutNote(layout, catalog));
    return NoteJson(note);
  };
  parts.note_text = [](const v1::SolvedLayout& layout,
                       const v1::ConstraintCatalog& catalog) -> absl::StatusOr<std::string> {
    ASSIGN_OR_RETURN(const Note note, MakeLayoutNote(layout, catalog));
    return NoteText(note, {.all = true});
  };
  return parts;
}

int stop_pipe[2] = {-1, -1};
void OnStop(int) {
  const ssize_t ignored = ::write(stop_pipe[1], "s", 1);
  (void)ignored;
}

// Until ^C or SIGTERM, or until whoever started it has closed standard input's other end, as a test does.
void WaitForStop() {
  pollfd waited = {.fd = stop_pipe[0], .events = POLLIN, .revents = 0};
  while (::poll(&waited, 1, -1) < 0) continue;
}

absl::Status Studio(const StudioArguments& arguments) {
  RETURN_IF_ERROR(CheckStageFlags(arguments.stages, "", arguments.llm));
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadLlmFlags(arguments.llm));
  if (::pipe(stop_pipe) != 0) return absl::InternalError("no pipe for signals");
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, OnStop);
  const std::string store = DefaultStorePath();
  ASSIGN_OR_RETURN(const auto services, EmbeddedServices::Start(store, llm, arguments.stages));
  const orchestrator::StageChannels& stages = services->stages();
  ASSIGN_OR_RETURN(session::DocumentParts parts, Parts(arguments.stages));
  ASSIGN_OR_RETURN(const auto documents, session::Documents::Open(store + "/documents",
                                                                  {.orchestrator = services->orchestrator(),
                                                                   .translator = stages.translator.channel,
                                                                   .optimizer = stages.optimizer.channel,
                                                                   .renderer = stages.renderer.channel},
                                                                  std::move(parts)));
  config::v1::RuntimeConfig runtime;
  runtime.set_log_level("error");
  const auto make = [&](runtime::WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
    context.build = runtime::BuildName();
    return studio::MakeStudioService(*documents, context);
  };
  ASSIGN_OR_RETURN(const auto service, runtime::InProcessServer::Start("flair-studio", runtime,
                                                                       v1::StudioService::service_full_name(), make));
  studio::GatewayOptions options;
  options.listen_address = fmt::format("127.0.0.1:{}", arguments.port);
  options.page_folder = runtime::InstalledFolder("studio", FLAIR_STUDIO_PAGE);
  options.services = {{.full_name = v1::StudioService::service_full_name(),
                       .channel = service->channel(),
                       .methods = {},
                       .upload_methods = {"CreateDocument"}},
                      {.full_name = v1::OrchestratorService::service_full_name(),
                       .channel = services->orchestrator(),
                       .methods = JobMethods(),
                       .upload_methods = {}}};
  ASSIGN_OR_RETURN(const auto gateway, studio::Gateway::Start(options));
  fmt::print(stderr, "The studio is open at\n\n  {}\n\n", gateway->url());
  fmt::print(stderr,
             "Keep the address to yourself: who has it may use your studio. ^C closes it; documents are kept in "
             "{}.\n",
             store + "/documents");
  WaitForStop();
  gateway->Stop();
  return absl::OkStatus();
}

}  // namespace

void AddStudio(const Commands& program) {
  program.Add("studio", "Design, move and explain furniture in a browser.", Studio,
              "Serves the studio on this machine only, and prints its address, which holds a key. Documents survive "
              "the browser and this program: start it again and go on.");
}

}  // namespace flair::cli
