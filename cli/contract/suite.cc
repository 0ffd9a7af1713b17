// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/suite.h"

#include <algorithm>
#include <array>

#include "absl/time/clock.h"
#include "cli/contract/checks.h"
#include "fmt/format.h"

namespace flair::contract {
namespace {

constexpr std::array<Stage, 5> kStages = {{{"language", "flair.v1.LanguageService"},
                                           {"translator", "flair.v1.TranslatorService"},
                                           {"optimizer", "flair.v1.OptimizerService"},
                                           {"renderer", "flair.v1.RendererService"},
                                           {"orchestrator", "flair.v1.OrchestratorService"}}};

// Callers that give up come last: a server that works on for them would be slow for all others.
Checks Assemble(const Sample& sample, const std::vector<void (*)(Checks&)>& parts) {
  Checks checks;
  AddServerChecks(sample, checks);
  for (const auto part : parts) part(checks);
  AddCallerChecks(sample, checks);
  return checks;
}

}  // namespace

const char* PromiseName(Promise promise) {
  switch (promise) {
    case Promise::kProtocol:
      return "protocol";
    case Promise::kMessages:
      return "messages";
    case Promise::kUnits:
      return "units";
    case Promise::kErrors:
      return "errors";
    case Promise::kCatalogue:
      return "catalogue";
    case Promise::kRepetition:
      return "repetition";
    case Promise::kCallers:
      return "callers";
    case Promise::kSize:
      return "size";
  }
  return "";
}

std::span<const Stage> AllStages() { return kStages; }

const Stage* FindStage(std::string_view name) {
  const auto found = std::ranges::find(kStages, name, &Stage::name);
  return found == kStages.end() ? nullptr : &*found;
}

std::vector<Check> ChecksOf(const Stage& stage) {
  const std::string_view name = stage.name;
  if (name == "language") return Assemble(LanguageSample(), {AddLanguageChecks});
  if (name == "translator") return Assemble(TranslateSample(), {AddTranslatorChecks});
  if (name == "optimizer") {
    return Assemble(SolveSample(), {AddSolveChecks, AddUnitChecks, AddSolveRefusals, AddCatalogueChecks,
                                    AddEvaluateChecks, AddResolveChecks, AddRestartChecks});
  }
  if (name == "renderer") return Assemble(RenderSample(), {AddRenderChecks, AddViewChecks, AddContactSheetChecks});
  return Assemble(OrchestratorSample(), {AddOrchestratorChecks});
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
  return check.run(target);
}

std::vector<Result> RunChecks(std::span<const Check> checks, Target& target,
                              const std::function<void(const Result&)>& on_result) {
  std::vector<Result> results;
  std::string obstacle;
  for (const Check& check : checks) {
    Result& result = results.emplace_back(Result{.name = check.name, .promise = check.promise});
    if (!obstacle.empty()) {
      result.finding = Skipped(obstacle);
      on_result(result);
      continue;
    }
    const absl::Time start = absl::Now();
    result.finding = RunCheck(check, target);
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
