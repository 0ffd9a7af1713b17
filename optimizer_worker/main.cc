// SPDX-License-Identifier: GPL-3.0-or-later
// flair-optimizer, or how the library of its constraints is called: serves flair.v1.OptimizerService.
#include "flair/config/v1/optimizer_worker_config.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/service/make_optimizer_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"

int main(int argc, char** argv) {
  using namespace flair;  // Their names in one call.
  return runtime::RunService<config::v1::OptimizerWorkerConfig, v1::OptimizerService>(
      argc, argv,
      {optimizer::Library().program, "Serves flair.v1.OptimizerService: places objects.", runtime::BuildName()},
      optimizer::MakeOptimizerService, [](const auto&, auto&) {});
}
