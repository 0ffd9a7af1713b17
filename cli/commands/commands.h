// SPDX-License-Identifier: GPL-3.0-or-later
// One function per command, which adds it to the program.
#pragma once

#include <string>
#include <vector>

namespace flair::cli {

struct Commands;  // input/options.h

using AddCommand = void (*)(const Commands& program);

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
  // Called before a command: registers what this program links and others do without. May be null.
  void (*prepare)() = nullptr;
};

// Runs the command that the arguments name, of a program of the given build; returns the exit code.
int RunProgram(int argc, char** argv, const Program& about, const std::string& build);

// The commands in their groups, with what they share: how --help looks, and the flags of connections.
void AddCommands(const Commands& program, const std::vector<CommandGroup>& groups);

void AddDesign(const Commands& program);
void AddStudio(const Commands& program);
void AddMcp(const Commands& program);
void AddBatch(const Commands& program);
void AddJobs(const Commands& program);
void AddReplay(const Commands& program);

void AddInspect(const Commands& program);
void AddExplain(const Commands& program);
void AddDiff(const Commands& program);
void AddGraph(const Commands& program);
void AddRender(const Commands& program);
void AddContactSheet(const Commands& program);

void AddSolve(const Commands& program);
void AddResolve(const Commands& program);
void AddCompare(const Commands& program);

void AddExport(const Commands& program);

void AddHandbook(const Commands& program);
void AddCatalog(const Commands& program);
void AddProtocol(const Commands& program);
void AddPrompts(const Commands& program);
void AddContract(const Commands& program);

void AddTop(const Commands& program);
void AddDoctor(const Commands& program);
void AddHealth(const Commands& program);
void AddToken(const Commands& program);

// Of flair-dev.
void AddBench(const Commands& program);

// The programs: inline, so that each links only its own commands.

void UseOurModels();  // embedded/embedded_services.h

// flair: what users and operators do.
inline Program FlairCommands() {
  return {.name = "flair",
          .description = "From a sentence to a furnished, explained, editable room.",
          .groups = {{"Design", {AddDesign, AddStudio, AddMcp, AddBatch, AddJobs, AddReplay}},
                     {"Look at what was made", {AddInspect, AddExplain, AddDiff, AddGraph, AddRender, AddContactSheet}},
                     {"Place the furniture again", {AddSolve, AddResolve, AddCompare}},
                     {"Exchange with other programs", {AddExport}},
                     {"Stages of your own", {AddHandbook, AddCatalog, AddProtocol, AddPrompts, AddContract}},
                     {"Operate", {AddTop, AddDoctor, AddHealth, AddToken}}},
          .footer =
              "flair COMMAND --help says more. Try:\n"
              "  flair design \"A bedroom that is 4m x 5m.\" --out out/bedroom",
          .prepare = UseOurModels};
}

// flair-design: what a first room and the next steps with it need, so that ./flair need not build everything first.
// ./flair names the same commands in `first_commands`.
inline Program DesignCommands() {
  return {.name = "flair",
          .description = "From a sentence to a furnished, explained, editable room.",
          .groups = {{"Design", {AddDesign}},
                     {"Look at what was made", {AddInspect, AddExplain, AddRender}},
                     {"Place the furniture again", {AddSolve, AddResolve}}},
          .footer = "These are the commands that are built first; ./flair --help lists all."};
}

// flair-dev: what only Flair's own developers do.
inline Program DevCommands() {
  return {.name = "flair-dev",
          .description = "Measures Flair; ./flair-dev also exchanges problems with the released implementation.",
          .groups = {{"Measure", {AddBench}}},
          .footer = "flair-dev COMMAND --help says more.",
          .prepare = UseOurModels};
}

}  // namespace flair::cli
