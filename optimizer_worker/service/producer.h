// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/provenance.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/library.h"
#include "optimizer_worker/constraints/registry.h"
#include "worker_runtime/bootstrap/build_id.h"

namespace flair::optimizer {

// Who made a layout, without the build, which the runtime adds to every answer.
inline v1::Producer OptimizerProducer() {
  v1::Producer producer;
  producer.set_program(Library().program);
  producer.set_method("slsqp");
  producer.set_version(Library().version);
  return producer;
}

// What peers must have in common, or a layout would depend on who took part: "flair-optimizer slsqp 1, build
// 1a2b3c4d5e6f". Where nobody knows what the program was built from, the linker's id of the program stands for it.
inline std::string PeerIdentity(const std::string& build) {
  const v1::Producer producer = OptimizerProducer();
  const bool known = !build.empty() && build != "unknown";
  return fmt::format("{} {} {}, build {}", producer.program(), producer.method(), producer.version(),
                     known ? build : "unknown " + runtime::BuildId().substr(0, 12));
}

}  // namespace flair::optimizer
