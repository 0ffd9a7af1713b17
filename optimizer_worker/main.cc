// SPDX-License-Identifier: GPL-3.0-or-later
// flair-optimizer, or how the library of its constraints is called: serves flair.v1.OptimizerService.
#include "flair/config/v1/optimizer_worker_config.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/service/make_optimizer_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
namespace {

absl::Status Assemble(const config::v1::OptimizerWorkerConfig& config, runtime::Worker& worker) {
  ASSIGN_OR_RETURN(std::unique_ptr<grpc::Service> service, optimizer::MakeOptimizerService(config, worker.context()));
  worker.Serve(v1::OptimizerService::service_full_name(), std::move(service));
  return absl::OkStatus();
}

}  // namespace
}  // namespace flair

int main(int argc, char** argv) {
  return flair::runtime::Run<flair::config::v1::OptimizerWorkerConfig>(
      argc, argv,
      {flair::optimizer::Library().program, "Serves flair.v1.OptimizerService: places objects.",
       flair::runtime::BuildName()},
      flair::Assemble);
}
