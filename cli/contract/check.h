// SPDX-License-Identifier: GPL-3.0-or-later
// One promise of a stage's contract as a check, the stages, and how their checks are run.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/checks/v1/checks.pb.h"
#include "flair/v1/worker_service.pb.h"

namespace flair::contract {

class Target;

// What a check belongs to.
using checks::v1::Promise;

// One word for reports, such as "callers".
std::string PromiseName(Promise promise);

enum class Verdict { kKept, kBroken, kSkipped };

// How a check came out.
struct Finding {
  Finding() = default;
  // Broken with the status as what came back, unless it is OK: RETURN_IF_ERROR and ASSIGN_OR_RETURN work in checks.
  Finding(const absl::Status& status);  // NOLINT(google-explicit-constructor)

  Verdict verdict = Verdict::kKept;
  // Broken: what was sent, what came back and what would be right, for whoever writes the server. Where a check leaves
  // `sent` or `right` empty, those of its row in the table stand.
  std::string sent;
  std::string got;
  std::string right;
  // Skipped: why.
  std::string reason;
};

inline Finding Kept() { return {}; }
Finding Wrong(std::string got, std::string right = "", std::string sent = "");
// Kept when `fault` is empty, otherwise wrong with it as what came back.
Finding WrongIf(const std::string& fault);
Finding Skipped(std::string reason);

// "INVALID_ARGUMENT: the message", "OK".
std::string StatusText(const absl::Status& status);

struct Check {
  // What holds when it is kept, as a sentence without full stop: "A width that is no number is refused". Unique in its
  // stage.
  std::string name;
  Promise promise = checks::v1::PROMISE_MESSAGES;
  // What is sent and what would be right, for reports.
  std::string sent = {};
  std::string right = {};
  // Must not hang: every call goes through the target, which has a deadline for each. May be called again.
  std::function<Finding(Target&)> run = {};
  // Of servers that claim this only; UNSPECIFIED: of every server of the stage.
  v1::Capability capability = v1::CAPABILITY_UNSPECIFIED;
  // When it is broken, no further question makes sense.
  bool decisive = false;
};
using Checks = std::vector<Check>;

struct Stage {
  // As on the command line: "optimizer".
  std::string name;
  // Full name: "flair.v1.OptimizerService".
  std::string service;
};

// In the order of the pipeline.
std::span<const Stage> AllStages();
// Null when there is none of that name.
const Stage* FindStage(std::string_view name);

// All checks of the stage, decisive ones first. They hold state of one run at most: make them anew for another server.
Checks ChecksOf(const Stage& stage);

struct Result {
  std::string name;
  Promise promise = checks::v1::PROMISE_MESSAGES;
  Finding finding = {};
  absl::Duration duration = {};
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
