// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev: measurements, and exchange with the paper's released implementation.
#include "cli/commands/commands.h"

namespace flair::cli {

Program DevCommands() {
  return {.name = "flair-dev",
          .description = "Measures Flair, and exchanges problems with the paper's released implementation.",
          .groups = {{"Measure", {AddBench, AddBenchRender, AddBenchResolve, AddBenchRestarts, AddBenchTranslate}},
                     {"Exchange with the released implementation", {AddImport, AddExportFlairGpt}}},
          .footer = "flair-dev COMMAND --help says more."};
}

}  // namespace flair::cli
