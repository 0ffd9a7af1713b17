// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/graph/run_dot.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "absl/time/clock.h"
#include "cli/exit_code.h"
#include "fmt/format.h"

extern char** environ;

namespace flair::cli {
namespace {

constexpr absl::Duration kWithin = absl::Minutes(2);
constexpr size_t kMostWords = 300;

// A file without a name, in memory.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : descriptor_(memfd_create(name, MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  bool Write(const std::string& text) const {
    for (size_t done = 0; done < text.size();) {
      const ssize_t count = write(descriptor_, text.data() + done, text.size() - done);
      if (count <= 0) return false;
      done += static_cast<size_t>(count);
    }
    return lseek(descriptor_, 0, SEEK_SET) == 0;
  }

  std::string Read() const {
    std::string bytes;
    lseek(descriptor_, 0, SEEK_SET);
    char buffer[65536];
    for (ssize_t count = read(descriptor_, buffer, sizeof(buffer)); count > 0;
         count = read(descriptor_, buffer, sizeof(buffer))) {
      bytes.append(buffer, static_cast<size_t>(count));
    }
    return bytes;
  }

 private:
  const int descriptor_;
};

// Its status as waitpid tells it.
absl::StatusOr<int> WaitFor(pid_t process) {
  const absl::Time end = absl::Now() + kWithin;
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (absl::Now() > end) {
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
      return absl::DeadlineExceededError(fmt::format(
          "dot: not done within {}; --out FILE.dot writes what it would read", absl::FormatDuration(kWithin)));
    }
    absl::SleepFor(absl::Milliseconds(5));
  }
  return status;
}

// Cairo writes the time of drawing into a PDF; no two files would be equal.
std::string WithoutTime(std::string pdf) {
  const std::string before = "/CreationDate (D:";
  const size_t at = pdf.find(before);
  if (at == std::string::npos) return pdf;
  for (size_t i = at + before.size(); i < pdf.size() && pdf[i] != ')'; ++i) {
    if (pdf[i] >= '0' && pdf[i] <= '9') pdf[i] = '0';
  }
  return pdf;
}

}  // namespace

absl::StatusOr<std::string> RunDot(const std::string& text, const std::string& format) {
  const MemoryFile in("dot-in"), out("dot-out"), said("dot-said");
  if (in.descriptor() < 0 || out.descriptor() < 0 || said.descriptor() < 0 || !in.Write(text)) {
    return FileError(fmt::format("dot: no memory for its files: {}", std::strerror(errno)));
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, said.descriptor(), STDERR_FILENO);
  std::string program = "dot", as = "-T" + format;
  char* arguments[] = {program.data(), as.data(), nullptr};
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    return FileError(fmt::format("dot: {}: Graphviz draws graphs; apt-get install graphviz, or write --out FILE.dot",
                                 std::strerror(error)));
  }
  const absl::StatusOr<int> status = WaitFor(process);
  if (!status.ok()) return status.status();
  std::string bytes = out.Read();
  if (!WIFEXITED(*status) || WEXITSTATUS(*status) != 0 || bytes.empty()) {
    return absl::InternalError(fmt::format("dot: it failed: {}", said.Read().substr(0, kMostWords)));
  }
  return format == "pdf" ? WithoutTime(std::move(bytes)) : bytes;
}

}  // namespace flair::cli
