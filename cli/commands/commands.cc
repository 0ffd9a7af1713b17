// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/commands.h"

#include <memory>
#include <vector>

#include "cli/exit_code.h"
#include "cli/input/connection_flags.h"
#include "cli/output/help_text.h"
#include "cli/output/wrapped_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using AddCommand = void (*)(CLI::App&, absl::Status&);

struct CommandGroup {
  const char* title;
  std::vector<AddCommand> commands;
};

// In the order of `flair --help`.
std::vector<CommandGroup> CommandGroups() {
  return {{"Design", {AddDesign, AddBatch, AddJobs, AddReplay}},
          {"Look at what was made", {AddInspect, AddExplain, AddDiff, AddGraph, AddRender, AddContactSheet}},
          {"Place the furniture again", {AddSolve, AddResolve, AddCompare}},
          {"Exchange with other programs", {AddImport, AddExport}},
          {"Stages of your own",
           {AddHandbook, AddCatalog, AddProtocol, AddPrompts, AddContract, AddBench, AddBenchRender, AddBenchResolve,
            AddBenchRestarts, AddBenchTranslate}},
          {"Operate", {AddTop, AddDoctor, AddHealth, AddToken}}};
}

}  // namespace

void AddCommands(CLI::App& program, absl::Status& result) {
  program.formatter(std::make_shared<HelpText>(TextWidth()));
  program.set_help_flag("-h,--help", "Show this and end");
  for (const CommandGroup& group : CommandGroups()) {
    for (const AddCommand add : group.commands) {
      const size_t before = program.get_subcommands(nullptr).size();
      add(program, result);
      const std::vector<CLI::App*> commands = program.get_subcommands(nullptr);
      for (size_t i = before; i < commands.size(); ++i) commands[i]->group(group.title);
    }
  }
  AddConnectionFlags(program);
  // Set last: commands would take it for theirs.
  program.footer(
      fmt::format("{}\n\nflair COMMAND --help says more. Try:\n"
                  "  flair design \"A bedroom that is 4m x 5m.\" --out out/bedroom",
                  kExitCodeHelp));
}

}  // namespace flair::cli
