// SPDX-License-Identifier: GPL-3.0-or-later
// flair catalog, flair protocol, flair prompts: what those who put stages of their own in the place of ours read.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/contract/check.h"
#include "cli/contract/target.h"
#include "cli/exit_code.h"
#include "cli/input/message_text.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/protocol/protocol.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "fmt/format.h"
#include "language_worker/model/model_tools.h"
#include "optimizer_worker/constraints/facts.h"
#include "translator_worker/model/model_translator.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct CatalogArguments : Options {
  using Options::Options;
  std::string& type = Text("TYPE", "One type in full, by name or alias");
  bool& json = Flag("--json", "As JSON");
  bool& markdown = Flag("--markdown", "All of them in full, as docs/constraints.md", {"--json"});
};

absl::Status Catalog(const CatalogArguments& arguments) {
  const v1::ConstraintCatalog& catalog = optimizer::MakeCatalog();
  if (!arguments.type.empty()) {
    const optimizer::ConstraintFacts* const facts = optimizer::FindConstraint(arguments.type);
    if (facts == nullptr) {
      std::vector<std::string> names;
      for (const v1::ConstraintType& type : catalog.types()) names.push_back(type.name());
      return NotFound("\"{}\" is not a constraint{}; flair catalog lists them", arguments.type,
                      DidYouMean(arguments.type, names));
    }
    for (const v1::ConstraintType& type : catalog.types()) {
      if (type.name() == facts->name()) fmt::print("{}", arguments.json ? ToJson(type) : TypeText(type));
    }
    return absl::OkStatus();
  }
  fmt::print("{}", arguments.json       ? ToJson(catalog)
                   : arguments.markdown ? CatalogMarkdown(catalog)
                                        : CatalogOverview(catalog));
  return absl::OkStatus();
}

struct ProtocolArguments : Options {
  using Options::Options;
  std::string& name = Text("NAME", "One entry in full: a service, call, message or enum");
};

absl::Status Protocol(const ProtocolArguments& arguments) {
  if (arguments.name.empty()) {
    fmt::print("{}", ProtocolOverview());
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(const std::string entry, ProtocolEntryText(arguments.name));
  fmt::print("{}", entry);
  return absl::OkStatus();
}

namespace fs = std::filesystem;

struct PromptsArguments : Options {
  using Options::Options;
  std::string& out = Required("-o,--out DIR", "Folder to write them to");
};

// The prompts of one worker's folder. Both have a "repair", which is the same.
absl::Status AddFolder(const fs::path& folder, std::vector<OutputFile>& files) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".txt") continue;
    ASSIGN_OR_RETURN(std::string text, ReadFile(entry.path()));
    const std::string name = entry.path().filename().string();
    const auto same = std::ranges::find_if(files, [&](const OutputFile& file) { return file.name == name; });
    if (same == files.end()) {
      files.push_back({name, std::move(text)});
    } else if (same->content != text) {
      return Internal("{}: two workers' prompts of this name differ", entry.path().string());
    }
  }
  if (error) return FileError("{}: {}; build again: ./flair build", folder.string(), error.message());
  return absl::OkStatus();
}

absl::Status WritePrompts(const PromptsArguments& arguments) {
  std::vector<OutputFile> files;
  for (const fs::path& folder : {language::DefaultPromptsFolder(), translator::DefaultPromptFolder()}) {
    RETURN_IF_ERROR(AddFolder(folder, files));
  }
  std::ranges::sort(files, [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
  std::vector<std::string> names;
  for (const OutputFile& file : files) {
    names.push_back(file.name);
    std::error_code error;
    if (!fs::exists(fs::path(arguments.out) / file.name, error)) continue;
    return FileError("{}/{}: already exists and may be your own; choose another folder", arguments.out, file.name);
  }
  RETURN_IF_ERROR(CheckOutputFolder(arguments.out, names));
  RETURN_IF_ERROR(WriteOutputFolder(arguments.out, files));
  for (const std::string& name : names) fmt::print(stderr, "{}/{}\n", arguments.out, name);
  fmt::print(stderr, "next       flair design TEXT --out DIR --llm FILE --prompts {}\n", arguments.out);
  return absl::OkStatus();
}

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
    return InvalidArgument(
        "--only \"{}\": no check of the {} has this in its name; flair contract {} --list names them", only, stage.name,
        stage.name);
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

void AddCatalog(const Commands& program) {
  program.Add("catalog", "List the constraints that the optimizer understands.", Catalog);
}

void AddProtocol(const Commands& program) {
  program.Add("protocol", "List the services and messages of the protocol.", Protocol);
}

void AddPrompts(const Commands& program) {
  program.Add("prompts", "Write the prompts for language models to files, for you to change.", WritePrompts,
              "Keep the files that you change and delete the others, so that those of the installed version are used.");
}

// flair contract: what a server of a stage promises, and whether it keeps it.

void AddContract(const Commands& program) {
  program.Add("contract",
              "Check a server against every promise of its stage, and list which it keeps and which it breaks.",
              Contract,
              "Optional promises are checked only for servers that claim them (GetWorkerResponse.capabilities). An "
              "orchestrator is given real jobs, which stay in its store. Exits with 0 when all promises are kept, 8 "
              "when one is broken, 3 when no server answers at the address.");
}

}  // namespace flair::cli
