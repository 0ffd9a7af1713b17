// SPDX-License-Identifier: GPL-3.0-or-later
// flair-design: what a first room and the next steps with it need, so that ./flair need not build everything first.
// ./flair names the same commands in `first_commands`.
#include "cli/commands/commands.h"

namespace flair::cli {

Program DesignCommands() {
  return {.name = "flair",
          .description = "From a sentence to a furnished, explained, editable room.",
          .groups = {{"Design", {AddDesign}},
                     {"Look at what was made", {AddInspect, AddExplain, AddRender}},
                     {"Place the furniture again", {AddSolve, AddResolve}}},
          .footer = "These are the commands that are built first; ./flair --help lists all."};
}

}  // namespace flair::cli
