// SPDX-License-Identifier: GPL-3.0-or-later
// flair top as people and scripts run it.
#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// `flair top` on a terminal of its own.
class TerminalTop {
 public:
  TerminalTop(const std::string& orchestrator, winsize size) {
    pid_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (pid_ == 0) {
      ::setenv("TERM", "xterm-256color", 1);
      ::setenv("NO_COLOR", "1", 1);
      const std::string path = ProgramPath("flair").string();
      ::execl(path.c_str(), path.c_str(), "top", "--orchestrator", orchestrator.c_str(), "--interval", "0.1", nullptr);
      ::_exit(127);
    }
  }
  ~TerminalTop() {
    ::close(terminal_);
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
  }
  TerminalTop(const TerminalTop&) = delete;
  TerminalTop& operator=(const TerminalTop&) = delete;

  // Reads until it has shown `text` since the last call; false when it ends before, or shows other things for long.
  bool WaitFor(const std::string& text) {
    char buffer[4096];
    while (shown_.find(text, seen_) == std::string::npos) {
      const ssize_t n = ::read(terminal_, buffer, sizeof buffer);
      if (n <= 0 || shown_.size() > seen_ + (1 << 20)) return false;
      shown_.append(buffer, static_cast<size_t>(n));
    }
    seen_ = shown_.find(text, seen_) + text.size();
    return true;
  }
  void Press(char key) { (void)!::write(terminal_, &key, 1); }
  void Resize(winsize size) { ::ioctl(terminal_, TIOCSWINSZ, &size); }
  int Wait() {
    WaitFor("nothing that it shows");
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  const std::string& shown() const { return shown_; }

 private:
  int terminal_ = -1;
  pid_t pid_ = -1;
  std::string shown_;
  size_t seen_ = 0;
};

TEST(TopCommand, RedrawsInPlaceAndLeavesTheTerminalAsItWas) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  TerminalTop top(programs.orchestrator(), {.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0});
  ASSERT_TRUE(top.WaitFor("\x1b[?1049h")) << top.shown();
  ASSERT_TRUE(top.WaitFor("flair top  " + programs.orchestrator()));
  ASSERT_TRUE(top.WaitFor("0 waiting"));
  ASSERT_TRUE(top.WaitFor("q quits"));
  ASSERT_TRUE(top.WaitFor("\x1b[H")) << "draws again over the first";
  top.Resize({.ws_row = 50, .ws_col = 132, .ws_xpixel = 0, .ws_ypixel = 0});
  ASSERT_TRUE(top.WaitFor(std::string(60, ' '))) << "columns spread over the wider screen";
  top.Press('q');
  EXPECT_EQ(top.Wait(), 0);
  EXPECT_THAT(top.shown(), EndsWith("\x1b[?7h\x1b[?25h\x1b[?1049l"));
  EXPECT_THAT(top.shown(), Not(HasSubstr("\x1b[2J"))) << "wiping the screen flickers";
}

TEST(TopCommand, KeepsItsPictureWhileTheOrchestratorIsAwayAndEndsOnASignal) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  TerminalTop top(programs.orchestrator(), {.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0});
  ASSERT_TRUE(top.WaitFor("0 waiting"));
  programs.orchestrator_program().process().Signal(SIGKILL);
  ASSERT_TRUE(top.WaitFor("No answer for"));
  ASSERT_TRUE(top.WaitFor("ORCHESTRATOR"));
  top.Press('\x03');
  EXPECT_EQ(top.Wait(), 0);
  EXPECT_THAT(top.shown(), EndsWith("\x1b[?1049l"));
}

TEST(TopCommand, PrintsOnceForScripts) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  const std::vector<std::string> arguments = {"top", "--orchestrator", programs.orchestrator(), "--interval", "0.05"};
  const Finished text = RunProgram("flair", arguments);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, AllOf(StartsWith("flair top  " + programs.orchestrator()), HasSubstr("ORCHESTRATOR"),
                              Not(HasSubstr("\x1b"))));
  std::vector<std::string> as_json = arguments;
  as_json.insert(as_json.end(), {"--once", "--json"});
  const Finished finished = RunProgram("flair", as_json);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const auto json = nlohmann::json::parse(finished.out);
  EXPECT_EQ(json["totals"]["queued_count"], 0);
  EXPECT_EQ(json["orchestrators"].size(), 1u);
}

TEST(TopCommand, SaysThatNobodyAnswers) {
  const Finished run = RunProgram("flair", {"top", "--orchestrator", "127.0.0.1:9", "--once"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("no orchestrator answers at 127.0.0.1:9"));
}

TEST(TopCommand, LooksAtTheLocalStore) {
  const TestFolder folder;
  const Finished run =
      RunProgram("flair", {"top", "--once", "--interval", "0.05"}, {{"FLAIR_HOME", (folder / "home").string()}});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("flair top  the local store"));
}

}  // namespace
}  // namespace flair::testing
