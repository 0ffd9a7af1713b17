// SPDX-License-Identifier: GPL-3.0-or-later
// One function per command: adds it to the program and, when it is the one called, runs it and says how it ended.
#pragma once

#include <string>
#include <vector>

#include "absl/status/status.h"

namespace CLI {
class App;
}

namespace flair::cli {

using AddCommand = void (*)(CLI::App& program, absl::Status& result);

// Commands under one heading of --help.
struct CommandGroup {
  std::string title;
  std::vector<AddCommand> commands;
};

struct Program {
  std::string name;
  std::string description;
  // In the order of --help.
  std::vector<CommandGroup> groups;
  // The end of --help.
  std::string footer;
};

// flair: what users and operators do.
Program FlairCommands();
// flair-design: the part of it that ./flair builds first.
Program DesignCommands();
// flair-dev: what only Flair's own developers do.
Program DevCommands();

// Runs the command that the arguments name; returns the exit code.
int RunProgram(int argc, char** argv, const Program& about);

// The commands in their groups, with what they share: how --help looks, and the flags of connections.
void AddCommands(CLI::App& program, const std::vector<CommandGroup>& groups, absl::Status& result);

void AddDesign(CLI::App& program, absl::Status& result);
void AddBatch(CLI::App& program, absl::Status& result);
void AddJobs(CLI::App& program, absl::Status& result);
void AddReplay(CLI::App& program, absl::Status& result);

void AddInspect(CLI::App& program, absl::Status& result);
void AddExplain(CLI::App& program, absl::Status& result);
void AddDiff(CLI::App& program, absl::Status& result);
void AddGraph(CLI::App& program, absl::Status& result);
void AddRender(CLI::App& program, absl::Status& result);
void AddContactSheet(CLI::App& program, absl::Status& result);

void AddSolve(CLI::App& program, absl::Status& result);
void AddResolve(CLI::App& program, absl::Status& result);
void AddCompare(CLI::App& program, absl::Status& result);

void AddExport(CLI::App& program, absl::Status& result);

void AddHandbook(CLI::App& program, absl::Status& result);
void AddCatalog(CLI::App& program, absl::Status& result);
void AddProtocol(CLI::App& program, absl::Status& result);
void AddPrompts(CLI::App& program, absl::Status& result);
void AddContract(CLI::App& program, absl::Status& result);

void AddTop(CLI::App& program, absl::Status& result);
void AddDoctor(CLI::App& program, absl::Status& result);
void AddHealth(CLI::App& program, absl::Status& result);
void AddToken(CLI::App& program, absl::Status& result);

// Of flair-dev.
void AddImport(CLI::App& program, absl::Status& result);
// Into the command that AddImport makes.
void AddImportAnswers(CLI::App& import, absl::Status& result);
void AddExportFlairGpt(CLI::App& program, absl::Status& result);
void AddBench(CLI::App& program, absl::Status& result);
// After AddBench.
void AddBenchRender(CLI::App& program, absl::Status& result);
void AddBenchResolve(CLI::App& program, absl::Status& result);
void AddBenchRestarts(CLI::App& program, absl::Status& result);
void AddBenchTranslate(CLI::App& program, absl::Status& result);

}  // namespace flair::cli
