// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contract/stage_program.h"

#include <gtest/gtest.h>

#include "fmt/format.h"

namespace flair::testing {

StageProgram::StageProgram(const contract::Stage& stage) {
  const std::string name = stage.name;
  if (name == "orchestrator") {
    all_ = std::make_unique<AllPrograms>(folder_.path());
    address_ = all_->orchestrator();
    return;
  }
  worker_ = std::make_unique<ServerProgram>(
      "flair-" + name, "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" worker_thread_count: 1 }",
      folder_.path());
  address_ = worker_->address();
}

std::unique_ptr<contract::Target> ConnectTo(const contract::Stage& stage, const std::string& address,
                                            absl::Duration patience) {
  auto target = contract::Target::Connect({.address = address, .service = stage.service, .patience = patience});
  EXPECT_TRUE(target.ok()) << target.status();
  return target.ok() ? *std::move(target) : nullptr;
}

std::string FindingText(const contract::Finding& finding) {
  return fmt::format("sent {}\n got {}\n right is {}\n reason {}", finding.sent, finding.got, finding.right,
                     finding.reason);
}

}  // namespace flair::testing
