// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/check.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/time/clock.h"
#include "cli/contract/script.h"
#include "cli/contract/target.h"
#include "fmt/format.h"

namespace flair::contract {

Finding::Finding(const absl::Status& status)
    : verdict(status.ok() ? Verdict::kKept : Verdict::kBroken), got(status.ok() ? "" : StatusText(status)) {}

Finding Wrong(std::string got, std::string right, std::string sent) {
  Finding finding;
  finding.verdict = Verdict::kBroken;
  finding.sent = std::move(sent);
  finding.got = std::move(got);
  finding.right = std::move(right);
  return finding;
}

Finding WrongIf(const std::string& fault) { return fault.empty() ? Kept() : Wrong(fault); }

Finding Skipped(std::string reason) {
  Finding finding;
  finding.verdict = Verdict::kSkipped;
  finding.reason = std::move(reason);
  return finding;
}

std::string StatusText(const absl::Status& status) {
  constexpr size_t kShown = 300;
  std::string message(status.message().substr(0, kShown));
  if (status.message().size() > kShown) message += "...";
  return fmt::format("{}{}{}", absl::StatusCodeToString(status.code()), message.empty() ? "" : ": ", message);
}

std::string PromiseName(Promise promise) {
  return absl::AsciiStrToLower(data::Promise_Name(promise).substr(std::string_view("PROMISE_").size()));
}

std::span<const Stage> AllStages() {
  static const auto& stages = *[] {
    auto* made = new std::vector<Stage>;
    for (const data::Stage& stage : AllChecks().stages()) made->push_back({stage.name(), stage.service()});
    return made;
  }();
  return stages;
}

const Stage* FindStage(std::string_view name) {
  const auto found = std::ranges::find(AllStages(), name, &Stage::name);
  return found == AllStages().end() ? nullptr : &*found;
}

Checks ChecksOf(const Stage& stage) {
  const data::Stage& found = AllChecks().stages(
      static_cast<int>(std::ranges::find(AllStages(), stage.name, &Stage::name) - AllStages().begin()));
  const Sample sample = SampleOf(found);
  Checks all = ServerChecks(sample);
  // Callers that give up come last: a server that works on for them would be slow for all others.
  for (const Checks& part : {StageChecks(found), CallerChecks(sample)}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::string CapabilityName(v1::Capability capability) {
  constexpr std::string_view kPrefix = "CAPABILITY_";
  const std::string& name = v1::Capability_Name(capability);
  return name.starts_with(kPrefix) ? name.substr(kPrefix.size()) : name;
}

Finding RunCheck(const Check& check, Target& target) {
  if (check.capability != v1::CAPABILITY_UNSPECIFIED && !target.Claims(check.capability)) {
    return Skipped(fmt::format("the server does not claim {}", CapabilityName(check.capability)));
  }
  Finding finding = check.run(target);
  if (finding.verdict == Verdict::kBroken && finding.sent.empty()) finding.sent = check.sent;
  if (finding.verdict == Verdict::kBroken && finding.right.empty()) finding.right = check.right;
  return finding;
}

std::vector<Result> RunChecks(std::span<const Check> checks, Target& target,
                              const std::function<void(const Result&)>& on_result) {
  std::vector<Result> results;
  std::string obstacle;
  for (const Check& check : checks) {
    Result& result = results.emplace_back(Result{.name = check.name, .promise = check.promise});
    const absl::Time start = absl::Now();
    result.finding = obstacle.empty() ? RunCheck(check, target) : Skipped(obstacle);
    if (result.finding.verdict == Verdict::kBroken) {
      if (!target.IsReachable()) {
        result.finding.got += "; since then the server cannot be reached";
        obstacle = fmt::format("the server cannot be reached since \"{}\"", check.name);
      } else if (check.decisive) {
        obstacle = fmt::format("\"{}\" is broken", check.name);
      }
    }
    result.duration = absl::Now() - start;
    on_result(result);
  }
  return results;
}

}  // namespace flair::contract
