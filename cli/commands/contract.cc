// SPDX-License-Identifier: GPL-3.0-or-later
// flair contract: what a server of a stage promises, and whether it keeps it.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/contract/report.h"
#include "cli/contract/target.h"
#include "cli/exit_code.h"
#include "cli/input/command_line.h"
#include "cli/input/service_flags.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ContractArguments {
  std::string stage;
  std::string target;
  std::string only;
  double patience_s = 20;
  int max_message_mib = 32;
  bool list = false;
  bool markdown = false;
  bool json = false;
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
    const absl::StatusOr<std::vector<contract::Check>> checks = ChosenChecks(each, arguments.only);
    if (!checks.ok()) return checks.status();
    fmt::print("{}", arguments.markdown ? contract::ListMarkdown(each, *checks) : contract::ListText(each, *checks));
  }
  return absl::OkStatus();
}

absl::Status Test(const contract::Stage& stage, const ContractArguments& arguments) {
  const absl::StatusOr<std::vector<contract::Check>> checks = ChosenChecks(stage, arguments.only);
  if (!checks.ok()) return checks.status();
  // Stages are not told the token of an orchestrator.
  const bool is_orchestrator = stage.service == std::string_view(v1::OrchestratorService::service_full_name());
  const auto connection = is_orchestrator ? OrchestratorConnection() : StageConnection();
  if (!connection.ok()) return connection.status();
  auto target = contract::Target::Connect({.address = arguments.target,
                                           .service = stage.service,
                                           .patience = absl::Seconds(arguments.patience_s),
                                           .max_message_mib = arguments.max_message_mib,
                                           .connection = *connection});
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
      *checks, **target, [&say](const contract::Result& result) { say(contract::ResultText(result)); });
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

void AddContract(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ContractArguments>();
  CLI::App* command = program.add_subcommand(
      "contract", "Put every promise of a stage to a server and say which it keeps and which it breaks.");
  std::vector<std::string> names;
  for (const contract::Stage& stage : contract::AllStages()) names.push_back(stage.name);
  command->add_option("STAGE", arguments->stage, fmt::format("What the server is: {}", fmt::join(names, ", ")))
      ->check(OneOf(names));
  command->add_option("--target", arguments->target, "The server, HOST:PORT or unix:PATH")->type_name("ADDRESS");
  command->add_option("--only", arguments->only, "Checks whose name contains this")->type_name("TEXT");
  command
      ->add_option("--patience", arguments->patience_s,
                   "Seconds that a call may take before the server is silent, 0.1 to 3600 (20)")
      ->type_name("S")
      ->check(Number(0.1, 3600.0));
  command
      ->add_option("--max-message-mib", arguments->max_message_mib,
                   "The largest message that the server takes, 4 to 1024 MiB (32)")
      ->type_name("MIB")
      ->check(WholeNumber(4, 1024));
  CLI::Option* const list = command->add_flag("--list", arguments->list, "Say what is promised, without a server");
  CLI::Option* const json = command->add_flag("--json", arguments->json, "As JSON; progress goes to standard error");
  command->add_flag("--markdown", arguments->markdown, "As docs/contract.md")->needs(list)->excludes(json);
  command->footer(
      "Optional promises are put only to servers that claim them (GetWorkerResponse.capabilities). An "
      "orchestrator is given real jobs, which stay in its store. Ends with 0 when all promises are kept, 8 "
      "when one is broken, 3 when nobody answers at the address.");
  command->callback([arguments, &result] {
    result = Contract(*arguments);
    std::fflush(stdout);
  });
}

}  // namespace flair::cli
