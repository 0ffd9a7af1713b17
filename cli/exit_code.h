// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "fmt/format.h"

namespace flair::cli {

// What `flair` ends with; `flair --help` lists them.
enum ExitCode : int {
  kExitDone = 0,
  kExitFailed = 1,       // something else went wrong: a bug or a broken installation
  kExitBadInput = 2,     // the request, an argument or a file's content is not right
  kExitUnreachable = 3,  // a service is down, full, too slow (trying again may help), or speaks another version
  kExitFiles = 4,        // a file or folder cannot be read or written
  kExitCorrupt = 5,      // stored bytes are not what they were
  kExitModel = 6,        // the language model: it cannot be reached, refuses the key, its budget is spent, or its
                         // answers are of no use
  kExitDiffers = 7,      // what was compared is not the same; nothing failed
  kExitBroken = 8,       // a server breaks a promise of its stage
  kExitSomeFailed = 9,   // a batch ended, and jobs of it failed or lines of it were rejected
  kExitCancelled = 10,   // the batch was cancelled
  kExitStopped = 130,    // interrupted (^C, SIGTERM) in the middle of what can be gone on with
};

int ExitCodeOf(const absl::Status& status);

// FAILED_PRECONDITION, which stands for kExitFiles here.
absl::Status FileError(const std::string& message);
template <typename... Args>
requires(sizeof...(Args) > 0) absl::Status FileError(fmt::format_string<Args...> message, Args&&... args) {
  return FileError(fmt::format(message, std::forward<Args>(args)...));
}

// ABORTED, which stands for kExitModel here.
absl::Status ModelError(const std::string& message);

// What stands for kExitDiffers, for commands that have told all about it: nothing more is said.
absl::Status DiffersStatus();

// What stands for kExitBroken.
absl::Status BrokenPromises(const std::string& message);

// The same status about `subject`: "SUBJECT: message".
absl::Status About(const std::string& subject, const absl::Status& status);
// What stands for a code that no status code stands for.
absl::Status EndWith(ExitCode code, const std::string& message);
template <typename... Args>
requires(sizeof...(Args) > 0) absl::Status EndWith(ExitCode code, fmt::format_string<Args...> message, Args&&... args) {
  return EndWith(code, fmt::format(message, std::forward<Args>(args)...));
}

// The codes for `flair --help`, a line or two each.
inline constexpr char kExitCodeHelp[] =
    "Exit codes:\n"
    "  0    done\n"
    "  1    any other failure: a bug, or a broken installation\n"
    "  2    the request or an argument is wrong, or names something that does not exist\n"
    "  3    a service cannot be reached, is full, or speaks another version\n"
    "  4    a file or folder cannot be read or written\n"
    "  5    an artifact or the store is corrupt\n"
    "  6    the language model cannot be reached, refuses the key, gives unusable\n       answers, or its budget is "
    "spent\n"
    "  7    what was compared differs\n"
    "  8    a server breaks a promise of its stage\n"
    "  9    jobs of a batch failed, or lines of it were rejected\n"
    "  10   the batch was cancelled\n"
    "  130  interrupted";

}  // namespace flair::cli
