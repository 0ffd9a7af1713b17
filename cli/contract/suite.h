// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of a stage: its checks, and how they are run.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/time/time.h"
#include "cli/contract/check.h"
#include "cli/contract/target.h"

namespace flair::contract {

struct Stage {
  // As on the command line: "optimizer".
  const char* name;
  // Full name: "flair.v1.OptimizerService".
  const char* service;
};

// In the order of the pipeline.
std::span<const Stage> AllStages();
// Null when there is none of that name.
const Stage* FindStage(std::string_view name);

// All checks of the stage, decisive ones first. They hold state of one run at most: make them anew for another server.
std::vector<Check> ChecksOf(const Stage& stage);

struct Result {
  std::string name;
  Promise promise = Promise::kMessages;
  Finding finding;
  absl::Duration duration;
};

// One check against one server; skipped when the server does not claim what it is about.
Finding RunCheck(const Check& check, Target& target);

// One after the other; `on_result` is told of each as it ends. When a decisive one is broken, or the server cannot be
// reached any more, the rest is skipped and says so.
std::vector<Result> RunChecks(std::span<const Check> checks, Target& target,
                              const std::function<void(const Result&)>& on_result);

// "CAPABILITY_SOLVE_RESTARTS" as people read it: "SOLVE_RESTARTS".
std::string CapabilityName(v1::Capability capability);

}  // namespace flair::contract
