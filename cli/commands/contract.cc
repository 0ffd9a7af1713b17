// SPDX-License-Identifier: GPL-3.0-or-later
// flair contract: what a server of a stage promises, and whether it keeps it.
#include <algorithm>
#include <cstdio>

#include "cli/commands/commands.h"
#include "cli/contract/check.h"
#include "cli/contract/target.h"
#include "cli/exit_code.h"
#include "cli/input/command_line.h"
#include "cli/input/service_flags.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

std::vector<std::string> StageNames() {
  std::vector<std::string> names;
  for (const contract::Stage& stage : contract::AllStages()) names.push_back(stage.name);
  return names;
}

struct ContractArguments : Options {
  using Options::Options;
  std::string& stage = Word("STAGE", StageNames(), fmt::format("The stage: {}", fmt::join(StageNames(), ", ")), "");
  std::string& target = Text("--target ADDRESS", "The server, HOST:PORT or unix:PATH");
  std::string& only = Text("--only TEXT", "Only the checks whose names contain TEXT");
  double& patience_s = Decimal("--patience S", 0.1, 3600, 20,
                               "Seconds to wait for an answer before the server counts as silent, 0.1 to 3600 (20)");
  int& max_message_mib =
      Whole("--max-message-mib MIB", 4, 1024, 32, "The largest message that the server accepts, 4 to 1024 MiB (32)");
  bool& list = Flag("--list", "List the promises, without a server");
  bool& json = Flag("--json", "As JSON; progress goes to standard error");
  bool& markdown = Flag("--markdown", "As docs/contract.md", {"--json"}, "--list");
};

// Those whose name contains `only`, and those without which no other makes sense.
absl::StatusOr<std::vector<contract::Check>> ChosenChecks(const contract::Stage& stage, const std::string& only) {
  std::vector<contract::Check> checks = contract::ChecksOf(stage);
  const auto is_meant = [&only](const contract::Check& check) { return check.name.find(only) != std::string::npos; };
  if (std::ranges::none_of(checks, is_meant)) {
    return absl::InvalidArgumentError(
        fmt::format("--only \"{}\": no check of the {} has this in its name; flair contract {} --list names them", only,
                    stage.name, stage.name));
  }
  std::erase_if(checks, [&](const contract::Check& check) { return !check.decisive && !is_meant(check); });
  return checks;
}

absl::Status List(const ContractArguments& arguments) {
  const contract::Stage* const stage = contract::FindStage(arguments.stage);
  const auto stages = stage != nullptr ? std::span(stage, 1) : contract::AllStages();
  if (arguments.json) fmt::print("{}", contract::ListJson(stages));
  if (arguments.markdown) fmt::print("{}", contract::kMarkdownHead);
  for (const contract::Stage& each : arguments.json ? std::span<const contract::Stage>() : stages) {
    ASSIGN_OR_RETURN(const std::vector<contract::Check> checks, ChosenChecks(each, arguments.only));
    fmt::print("{}", arguments.markdown ? contract::ListMarkdown(each, checks) : contract::ListText(each, checks));
  }
  return absl::OkStatus();
}

absl::Status Test(const contract::Stage& stage, const ContractArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<contract::Check> checks, ChosenChecks(stage, arguments.only));
  // Stages are not told the token of an orchestrator.
  const bool is_orchestrator = stage.service == std::string_view(v1::OrchestratorService::service_full_name());
  ASSIGN_OR_RETURN(const runtime::ChannelOptions connection,
                   is_orchestrator ? OrchestratorConnection() : StageConnection());
  auto target = contract::Target::Connect({.address = arguments.target,
                                           .service = stage.service,
                                           .patience = absl::Seconds(arguments.patience_s),
                                           .max_message_mib = arguments.max_message_mib,
                                           .connection = connection});
  if (!target.ok())
    return absl::Status(target.status().code(), fmt::format("--target {}", std::string(target.status().message())));
  // With --json standard output is for programs alone.
  std::FILE* const out = arguments.json ? stderr : stdout;
  const auto say = [out](const std::string& text) {
    fmt::print(out, "{}", text);
    std::fflush(out);
  };
  say(contract::HeadText(stage, **target));
  const std::vector<contract::Result> results = contract::RunChecks(
      checks, **target, [&say](const contract::Result& result) { say(contract::ResultText(result)); });
  say(contract::SummaryText(results));
  if (arguments.json) fmt::print("{}", contract::ResultsJson(stage, **target, results));
  const int broken = contract::BrokenCount(results);
  if (broken == 0) return absl::OkStatus();
  return BrokenPromises(
      fmt::format("{} breaks {} of {} put to it", arguments.target, broken, Counted(std::ssize(results), "promise")));
}

absl::Status Contract(const ContractArguments& arguments) {
  const contract::Stage* const stage = contract::FindStage(arguments.stage);
  if (arguments.list) return List(arguments);
  if (stage == nullptr) return absl::InvalidArgumentError("STAGE: missing; flair contract --help names them");
  if (arguments.target.empty()) {
    return absl::InvalidArgumentError(
        "--target: missing; HOST:PORT of the server to test, or --list for what is asked");
  }
  return Test(*stage, arguments);
}

}  // namespace

void AddContract(const Commands& program) {
  program.Add("contract",
              "Check a server against every promise of its stage, and list which it keeps and which it breaks.",
              Contract,
              "Optional promises are checked only for servers that claim them (GetWorkerResponse.capabilities). An "
              "orchestrator is given real jobs, which stay in its store. Exits with 0 when all promises are kept, 8 "
              "when one is broken, 3 when no server answers at the address.");
}

}  // namespace flair::cli
