// SPDX-License-Identifier: GPL-3.0-or-later
// flair: from a sentence to a furnished room.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/usage_error.h"
#include "fmt/format.h"
#include "worker_runtime/bootstrap/build_id.h"

namespace {

// Whoever reads only the beginning (`flair ... | head`) wants no word about the rest.
int OutputFailed(int error) {
  if (error != EPIPE) {
    std::fprintf(stderr, "flair: output: cannot be written: %s\n",
                 error == 0 ? "the disk may be full" : std::strerror(error));
  }
  return flair::cli::kExitFiles;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit is an error like any other
  // What gRPC says to its authors of handshakes that fail is said again, for people, by whoever made the call.
  ::setenv("GRPC_VERBOSITY", "NONE", 0);
  CLI::App program("From a sentence to a furnished, explained, editable room.", "flair");
  program.require_subcommand(1);
  program.set_version_flag("--version", fmt::format("flair {}, build {}", FLAIR_VERSION, flair::runtime::BuildName()),
                           "Show version and build and end");
  absl::Status result;
  flair::cli::AddCommands(program, result);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    program.exit(wanted);  // prints the help or the version
  } catch (const CLI::ParseError& error) {
    result = flair::cli::UsageError(program, error);
  } catch (const std::system_error& error) {
    // Printing throws it. What is said here must not throw again.
    return OutputFailed(error.code().value());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flair: %s\n", error.what());
    return flair::cli::kExitFailed;
  }
  const int code = flair::cli::ExitCodeOf(result);
  const bool printed = code == flair::cli::kExitDone || code == flair::cli::kExitDiffers;
  errno = 0;
  if (printed && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) return OutputFailed(errno);
  if (!result.message().empty()) std::fprintf(stderr, "flair: %s\n", std::string(result.message()).c_str());
  return code;
}
