// SPDX-License-Identifier: GPL-3.0-or-later
// One promise of a stage's contract as a check, the stages, and how their checks are run.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
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
  // What holds when it is kept, as a sentence without full stop: "A width that is not a number is refused". Unique in
  // its stage.
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

// The account of a run for people, for programs and for the documentation.

// What is put to which test: service, address, program, claims. One line.
std::string HeadText(const Stage& stage, const Target& target);
// One line, and for what is broken three more.
std::string ResultText(const Result& result);
// One line: how many are kept, broken and skipped, and how long it took.
std::string SummaryText(std::span<const Result> results);
int BrokenCount(std::span<const Result> results);

std::string ResultsJson(const Stage& stage, const Target& target, std::span<const Result> results);

// What the stage promises, without a server: for people, as a section of docs/contract.md (below its head), as JSON.
std::string ListText(const Stage& stage, std::span<const Check> checks);
inline constexpr char kMarkdownHead[] =
    "<!-- Made by `flair contract --list --markdown`; do not edit. -->\n"
    "# What each stage promises\n\n"
    "`flair contract STAGE --target HOST:PORT` puts every line to a server, in any language, and says which it keeps;\n"
    "[replace-a-stage.md](replace-a-stage.md) tells how to put such a server in a stage's place.\n\n";
std::string ListMarkdown(const Stage& stage, std::span<const Check> checks);
std::string ListJson(std::span<const Stage> stages);

}  // namespace flair::contract
