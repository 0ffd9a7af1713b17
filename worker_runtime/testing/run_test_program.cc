// SPDX-License-Identifier: GPL-3.0-or-later
// A program like any worker's, for run_test.cc: serves no service but what every program has.
#include "flair/config/v1/optimizer_worker_config.pb.h"
#include "worker_runtime/bootstrap/run.h"

int main(int argc, char** argv) {
  using namespace flair;
  return runtime::Run<config::v1::OptimizerWorkerConfig>(
      argc, argv, {"flair-test", "Serves nothing."},
      [](const config::v1::OptimizerWorkerConfig&, runtime::Worker&) { return absl::OkStatus(); });
}
