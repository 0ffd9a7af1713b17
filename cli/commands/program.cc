// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of flair, flair-design and flair-dev: the command line in, the exit code out.
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <system_error>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/command_line.h"
#include "cli/input/service_flags.h"
#include "cli/output/text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// Whether whoever read standard output has gone, as `head` does after its lines.
bool ReaderHasGone() {
  pollfd out = {.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

// Whoever reads only the beginning (`flair ... | head`) wants no word about the rest. `error` is 0 when it is not
// known.
int OutputFailed(int error) {
  if (error != EPIPE && !ReaderHasGone()) {
    std::fprintf(stderr, "flair: output: cannot be written: %s\n",
                 error == 0 ? "the disk may be full" : std::strerror(error));
  }
  return kExitFiles;
}

}  // namespace

void AddCommands(const Commands& commands, const std::vector<CommandGroup>& groups) {
  CLI::App& program = commands.app;
  program.formatter(std::make_shared<HelpText>(TextWidth()));
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.require_subcommand(1);
  for (const CommandGroup& group : groups) {
    for (const AddCommand add : group.commands) {
      const size_t before = program.get_subcommands(nullptr).size();
      add(commands);
      const std::vector<CLI::App*> added = program.get_subcommands(nullptr);
      for (size_t i = before; i < added.size(); ++i) added[i]->group(group.title);
    }
  }
  AddConnectionFlags(program);
}

int RunProgram(int argc, char** argv, const Program& about, const std::string& build) {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit is an error like any other
  // What gRPC says to its authors of handshakes that fail is said again, for people, by whoever made the call.
  ::setenv("GRPC_VERBOSITY", "NONE", 0);
  if (about.prepare != nullptr) about.prepare();
  CLI::App program(about.description, about.name);
  program.set_version_flag("--version", fmt::format("{} {}, build {}", about.name, FLAIR_VERSION, build),
                           "Print version and build and exit");
  absl::Status result;
  AddCommands({program, result}, about.groups);
  // Set last: commands would take it for theirs.
  program.footer(fmt::format("{}\n\n{}", kExitCodeHelp, about.footer));
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    program.exit(wanted);  // prints the help or the version
  } catch (const CLI::ParseError& error) {
    result = UsageError(program, error);
  } catch (const std::system_error& error) {
    // Printing throws it. What is said here must not throw again.
    return OutputFailed(error.code().value());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flair: %s\n", error.what());
    return kExitFailed;
  }
  const int code = ExitCodeOf(result);
  const bool printed = code == kExitDone || code == kExitDiffers;
  errno = 0;
  if (printed && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) return OutputFailed(errno);
  if (!result.message().empty()) std::fprintf(stderr, "flair: %s\n", std::string(result.message()).c_str());
  return code;
}

}  // namespace flair::cli
