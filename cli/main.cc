// SPDX-License-Identifier: GPL-3.0-or-later
// flair, flair-design and flair-dev, which differ in their commands: FLAIR_COMMANDS names the function that lists them.
#include "cli/commands/commands.h"
#include "worker_runtime/bootstrap/build_id.h"

int main(int argc, char** argv) {
  return flair::cli::RunProgram(argc, argv, flair::cli::FLAIR_COMMANDS(), flair::runtime::BuildName());
}
