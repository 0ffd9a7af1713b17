// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/commands.h"

namespace flair::cli {

Program FlairCommands() {
  return {.name = "flair",
          .description = "From a sentence to a furnished, explained, editable room.",
          .groups = {{"Design", {AddDesign, AddBatch, AddJobs, AddReplay}},
                     {"Look at what was made", {AddInspect, AddExplain, AddDiff, AddGraph, AddRender, AddContactSheet}},
                     {"Place the furniture again", {AddSolve, AddResolve, AddCompare}},
                     {"Exchange with other programs", {AddExport}},
                     {"Stages of your own", {AddHandbook, AddCatalog, AddProtocol, AddPrompts, AddContract}},
                     {"Operate", {AddTop, AddDoctor, AddHealth, AddToken}}},
          .footer =
              "flair COMMAND --help says more. Try:\n"
              "  flair design \"A bedroom that is 4m x 5m.\" --out out/bedroom"};
}

}  // namespace flair::cli
