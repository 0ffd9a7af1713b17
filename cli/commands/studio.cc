// SPDX-License-Identifier: GPL-3.0-or-later
// flair studio: rooms in a browser.
#include <poll.h>

#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/input/options.h"
#include "cli/session/open_documents.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "flair/v1/studio_service.grpc.pb.h"
#include "fmt/format.h"
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
  int& port = Whole("--port N", 0, 65535, 0, "Port of 127.0.0.1 to serve on, 1 to 65535; 0 takes a free one (0)");
  std::string& listen =
      Text("--listen IP", "Serve other machines too, on this address (0.0.0.0: all); needs --certificate");
  std::string& certificate = Text("--certificate FILE", "Certificate chain for them, PEM; needs --key");
  std::string& key = Text("--key FILE", "Its key, PEM");
  std::string& host_name = Text("--host-name NAME", "What they call this machine, as the certificate does");
  DocumentFlags documents{command()};
};

// What a page may ask of the orchestrator, beside documents.
const std::vector<std::string>& JobMethods() {
  static const std::vector<std::string>& methods = *new std::vector<std::string>{
      "ListJobs",    "GetJob",      "CancelJob",  "ListBatches", "GetBatch",   "PauseBatch",
      "ResumeBatch", "CancelBatch", "RetryBatch", "GetCluster",  "GetArtifact"};
  return methods;
}

// Until ^C or SIGTERM.
void WaitForStop(int stop) {
  pollfd waited = {.fd = stop, .events = POLLIN, .revents = 0};
  while (::poll(&waited, 1, -1) < 0) continue;
}

absl::Status Studio(const StudioArguments& arguments) {
  ASSIGN_OR_RETURN(const int stop, StopDescriptor());
  ASSIGN_OR_RETURN(const auto opened, OpenDocuments::Open(arguments.documents));
  config::v1::RuntimeConfig runtime;
  runtime.set_log_level("error");
  const auto make = [&](runtime::WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
    context.build = runtime::BuildName();
    return studio::MakeStudioService(opened->documents(), context);
  };
  ASSIGN_OR_RETURN(const auto service, runtime::InProcessServer::Start("flair-studio", runtime,
                                                                       v1::StudioService::service_full_name(), make));
  studio::GatewayOptions options;
  const std::string ip = arguments.listen.empty() ? "127.0.0.1" : arguments.listen;
  options.listen_address =
      (ip.find(':') == std::string::npos ? ip : "[" + ip + "]") + fmt::format(":{}", arguments.port);
  if (!arguments.certificate.empty()) {
    options.tls.emplace();
    options.tls->set_certificate_path(arguments.certificate);
    options.tls->set_key_path(arguments.key);
  }
  if (!arguments.host_name.empty()) options.host_names = {arguments.host_name};
  options.page_folder = runtime::InstalledFolder("studio", FLAIR_STUDIO_PAGE);
  options.services = {{.full_name = v1::StudioService::service_full_name(),
                       .channel = service->channel(),
                       .methods = {},
                       .upload_methods = {"CreateDocument"}},
                      {.full_name = v1::OrchestratorService::service_full_name(),
                       .channel = opened->orchestrator(),
                       .methods = JobMethods(),
                       .upload_methods = {}}};
  ASSIGN_OR_RETURN(const auto gateway, studio::Gateway::Start(options));
  fmt::print(stderr, "The studio is open at\n\n  {}\n\n", gateway->url());
  fmt::print(stderr,
             "Keep the address to yourself: who has it may use your studio. ^C closes it; documents are kept in "
             "{}.\n",
             opened->folder());
  WaitForStop(stop);
  gateway->Stop();
  return absl::OkStatus();
}

}  // namespace

void AddStudio(const Commands& program) {
  program.Add("studio", "Design, move and explain furniture in a browser.", Studio,
              "Serves the studio on this machine only, unless --listen says otherwise, and prints its address, which "
              "holds a key. Documents survive the browser and this program: start it again and go on.");
}

}  // namespace flair::cli
