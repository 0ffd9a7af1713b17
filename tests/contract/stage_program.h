// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cli/contract/check.h"
#include "cli/contract/target.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {

// Flair's own program of a stage on a free port; of the orchestrator all five. Workers have one thread each: they
// answer only when they have let go of what came before.
class StageProgram {
 public:
  explicit StageProgram(const contract::Stage& stage);
  const std::string& address() const { return address_; }

 private:
  TestFolder folder_;
  std::unique_ptr<ServerProgram> worker_;
  std::unique_ptr<AllPrograms> all_;
  std::string address_;
};

// A connection to the server at the address; fails the test when there is none.
std::unique_ptr<contract::Target> ConnectTo(const contract::Stage& stage, const std::string& address,
                                            absl::Duration patience = absl::Seconds(60));

// What came back and what would be right, for messages of tests.
std::string FindingText(const contract::Finding& finding);

}  // namespace flair::testing
