// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/check.h"

#include <algorithm>
#include <map>

#include "absl/strings/ascii.h"
#include "absl/time/clock.h"
#include "cli/contract/script.h"
#include "cli/contract/target.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "nlohmann/json.hpp"

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

namespace {

using Json = nlohmann::ordered_json;

const char* VerdictName(Verdict verdict) {
  constexpr const char* kNames[] = {"kept", "broken", "skipped"};
  return kNames[static_cast<int>(verdict)];
}

std::vector<std::string> Claims(const v1::GetWorkerResponse& worker) {
  std::vector<std::string> names;
  for (const int capability : worker.capabilities()) {
    if (v1::Capability_IsValid(capability)) names.push_back(CapabilityName(static_cast<v1::Capability>(capability)));
  }
  return names;
}

// A server's words on one line of a terminal, and not more than can be read.
std::string OneLine(std::string text) {
  constexpr size_t kShown = 400;
  if (text.size() > kShown) text = text.substr(0, kShown) + "...";
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

int CountOf(std::span<const Result> results, Verdict verdict) {
  return static_cast<int>(
      std::ranges::count_if(results, [verdict](const Result& result) { return result.finding.verdict == verdict; }));
}

double SecondsOf(std::span<const Result> results) {
  absl::Duration sum;
  for (const Result& result : results) sum += result.duration;
  return absl::ToDoubleSeconds(sum);
}

std::string Dump(const Json& json) { return cli::JsonText(json, 2) + "\n"; }

}  // namespace

std::string HeadText(const Stage& stage, const Target& target) {
  const std::vector<std::string> claims = Claims(target.worker());
  const std::string program = target.worker().program().empty() ? "a server" : OneLine(target.worker().program());
  return fmt::format("{} of {} at {}, which claims {}\n", stage.service, program, target.options().address,
                     claims.empty() ? "nothing beyond the stage" : fmt::format("{}", fmt::join(claims, ", ")));
}

std::string ResultText(const Result& result) {
  const Finding& finding = result.finding;
  std::string text = fmt::format("  {:<8} {:<11} {:5.1f} s  {}\n", VerdictName(finding.verdict),
                                 PromiseName(result.promise), absl::ToDoubleSeconds(result.duration), result.name);
  constexpr int kIndent = 21;
  if (finding.verdict == Verdict::kSkipped) text += fmt::format("{:{}} because {}\n", "", kIndent, finding.reason);
  if (finding.verdict != Verdict::kBroken) return text;
  text += fmt::format("{:{}} sent     {}\n", "", kIndent, OneLine(finding.sent));
  text += fmt::format("{:{}} got      {}\n", "", kIndent, OneLine(finding.got));
  text += fmt::format("{:{}} right is {}\n", "", kIndent, OneLine(finding.right));
  return text;
}

std::string SummaryText(std::span<const Result> results) {
  return fmt::format("{} kept, {} broken, {} skipped in {:.1f} s\n", CountOf(results, Verdict::kKept),
                     CountOf(results, Verdict::kBroken), CountOf(results, Verdict::kSkipped), SecondsOf(results));
}

int BrokenCount(std::span<const Result> results) { return CountOf(results, Verdict::kBroken); }

std::string ResultsJson(const Stage& stage, const Target& target, std::span<const Result> results) {
  Json checks = Json::array();
  for (const Result& result : results) {
    const Finding& finding = result.finding;
    Json check = {{"name", result.name},
                  {"promise", PromiseName(result.promise)},
                  {"verdict", VerdictName(finding.verdict)},
                  {"seconds", absl::ToDoubleSeconds(result.duration)}};
    if (finding.verdict == Verdict::kSkipped) check["reason"] = finding.reason;
    if (finding.verdict == Verdict::kBroken) {
      check["sent"] = finding.sent;
      check["got"] = OneLine(finding.got);
      check["right"] = finding.right;
    }
    checks.push_back(std::move(check));
  }
  return Dump({{"service", stage.service},
               {"target", target.options().address},
               {"program", target.worker().program()},
               {"claims", Claims(target.worker())},
               {"kept", CountOf(results, Verdict::kKept)},
               {"broken", CountOf(results, Verdict::kBroken)},
               {"skipped", CountOf(results, Verdict::kSkipped)},
               {"seconds", SecondsOf(results)},
               {"checks", std::move(checks)}});
}

std::string ListText(const Stage& stage, std::span<const Check> checks) {
  std::string text = fmt::format("{}: {} promises\n", stage.service, checks.size());
  for (const Check& check : checks) {
    const std::string claim = check.capability == v1::CAPABILITY_UNSPECIFIED
                                  ? ""
                                  : fmt::format(" (who claims {})", CapabilityName(check.capability));
    text += fmt::format("  {:<11} {}{}\n", PromiseName(check.promise), check.name, claim);
  }
  return text;
}

std::string ListMarkdown(const Stage& stage, std::span<const Check> checks) {
  // By what must be claimed, what every server promises first.
  std::map<v1::Capability, std::vector<const Check*>> by_claim;
  for (const Check& check : checks) by_claim[check.capability].push_back(&check);
  std::string text = fmt::format("## {}: `{}`\n", stage.name, stage.service);
  for (auto& [capability, members] : by_claim) {
    std::ranges::stable_sort(members, {}, &Check::promise);
    text +=
        capability == v1::CAPABILITY_UNSPECIFIED
            ? "\nEvery server:\n\n| of | promise |\n| --- | --- |\n"
            : fmt::format("\nWho claims `{}`:\n\n| of | promise |\n| --- | --- |\n", v1::Capability_Name(capability));
    for (const Check* check : members) text += fmt::format("| {} | {} |\n", PromiseName(check->promise), check->name);
  }
  return text + "\n";
}

std::string ListJson(std::span<const Stage> stages) {
  Json lists = Json::array();
  for (const Stage& stage : stages) {
    Json checks = Json::array();
    for (const Check& check : ChecksOf(stage)) {
      checks.push_back({{"name", check.name}, {"promise", PromiseName(check.promise)}});
      if (check.capability != v1::CAPABILITY_UNSPECIFIED) checks.back()["claim"] = CapabilityName(check.capability);
    }
    lists.push_back({{"stage", stage.name}, {"service", stage.service}, {"checks", std::move(checks)}});
  }
  return Dump(lists);
}

}  // namespace flair::contract
