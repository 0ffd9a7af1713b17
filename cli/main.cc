// SPDX-License-Identifier: GPL-3.0-or-later
// flair: from a sentence to a furnished room.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <system_error>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/connection_flags.h"
#include "fmt/format.h"
#include "worker_runtime/bootstrap/build_name.h"

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit is an error like any other
  // What gRPC says to its authors of handshakes that fail is said again, for people, by whoever made the call.
  ::setenv("GRPC_VERBOSITY", "NONE", 0);
  CLI::App program("From a sentence to a furnished, explained, editable room.", "flair");
  program.footer(fmt::format("{}\n\nTry: flair design \"A bedroom that is 4m x 5m.\" --out out/bedroom",
                             flair::cli::kExitCodeHelp));
  program.require_subcommand(1);
  program.set_version_flag("--version", fmt::format("flair {}, build {}", FLAIR_VERSION, flair::runtime::BuildName()));
  absl::Status result;
  flair::cli::AddDesign(program, result);
  flair::cli::AddInspect(program, result);
  flair::cli::AddDiff(program, result);
  flair::cli::AddGraph(program, result);
  flair::cli::AddExplain(program, result);
  flair::cli::AddJobs(program, result);
  flair::cli::AddTop(program, result);
  flair::cli::AddBatch(program, result);
  flair::cli::AddReplay(program, result);
  flair::cli::AddRender(program, result);
  flair::cli::AddContactSheet(program, result);
  flair::cli::AddSolve(program, result);
  flair::cli::AddResolve(program, result);
  flair::cli::AddCompare(program, result);
  flair::cli::AddImport(program, result);
  flair::cli::AddExport(program, result);
  flair::cli::AddBench(program, result);
  flair::cli::AddBenchRender(program, result);
  flair::cli::AddBenchResolve(program, result);
  flair::cli::AddBenchRestarts(program, result);
  flair::cli::AddBenchTranslate(program, result);
  flair::cli::AddCatalog(program, result);
  flair::cli::AddContract(program, result);
  flair::cli::AddDoctor(program, result);
  flair::cli::AddHealth(program, result);
  flair::cli::AddPrompts(program, result);
  flair::cli::AddProtocol(program, result);
  flair::cli::AddToken(program, result);
  flair::cli::AddConnectionFlags(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? flair::cli::kExitDone : flair::cli::kExitBadInput;
  } catch (const std::system_error& error) {
    // Printing throws it, say when the reader of a pipe has gone. What is said here must not throw again.
    std::fprintf(stderr, "flair: output: %s\n", error.what());
    return flair::cli::kExitFiles;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flair: %s\n", error.what());
    return flair::cli::kExitFailed;
  }
  const int code = flair::cli::ExitCodeOf(result);
  const bool printed = code == flair::cli::kExitDone || code == flair::cli::kExitDiffers;
  if (printed && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) {
    std::fprintf(stderr, "flair: output: cannot be written: its reader has gone, or the disk is full\n");
    return flair::cli::kExitFiles;
  }
  if (!result.message().empty()) std::fprintf(stderr, "flair: %s\n", std::string(result.message()).c_str());
  return code;
}
