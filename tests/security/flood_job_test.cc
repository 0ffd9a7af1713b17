// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody designs rooms while others do to the orchestrator what they can.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "tests/fixtures/programs.h"
#include "tests/security/attacks.h"
#include "tests/security/secure_programs.h"

namespace flair::testing {
namespace {

TEST(FloodedOrchestrator, DesignsARoomForSomebodyElse) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  Attack attack(programs.orchestrator(), "/flair.v1.OrchestratorService/CreateJob");
  attack.WaitUntilUnderWay();
  const Finished design = RunProgram("flair",
                                     {"design", "A bedroom that is 3m x 4m.", "--out", (folder / "bedroom").string(),
                                      "--quiet", "--orchestrator", programs.orchestrator()},
                                     {{"FLAIR_HOME", (folder / "home").string()}});
  EXPECT_EQ(design.exit_code, 0) << design.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "bedroom" / "plan.png"));
  fmt::print("meanwhile: {} connections, {} large messages refused; the orchestrator {} MiB\n",
             attack.connection_count(), attack.refused_count(), PeakMib(programs.orchestrator_program().process()));
  EXPECT_EQ(attack.taken_count(), 0);
  EXPECT_LT(PeakMib(programs.orchestrator_program().process()), 700);
}

TEST(FloodedOrchestrator, TellsWatchersOfEveryJob) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  OrchestratorCaller innocent(programs.orchestrator(), {});
  const auto before = innocent.CreateJob("A study that is 3m x 3m.", "before");
  ASSERT_TRUE(before.ok()) << before.status();
  Attack attack(programs.orchestrator(), "/flair.v1.OrchestratorService/CreateJob");
  attack.WaitUntilUnderWay();
  for (int i = 0; i < 3; ++i) {
    const auto job = innocent.CreateJob("A bedroom that is 3m x 4m.", fmt::format("during-{}", i));
    ASSERT_TRUE(job.ok()) << job.status();
    const auto end = innocent.EndOf(job->id());
    ASSERT_TRUE(end.ok()) << end.status();
    EXPECT_EQ(end->state(), v1::JOB_STATE_SUCCEEDED) << end->error();
  }
  const auto end = innocent.EndOf(before->id());
  ASSERT_TRUE(end.ok()) << end.status();
  EXPECT_EQ(end->state(), v1::JOB_STATE_SUCCEEDED) << end->error();
}

// Takes connections at an address of its own; hands on all but the first, to which it says nothing until the caller has
// had enough.
class SlowToSayHello {
 public:
  explicit SlowToSayHello(std::string server) : server_(std::move(server)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(listener_, 8), 0);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    address_ = fmt::format("127.0.0.1:{}", ntohs(address.sin_port));
    threads_.emplace_back([this] {
      const int first = ::accept(listener_, nullptr, nullptr);
      char buffer[4096];
      while (::read(first, buffer, sizeof buffer) > 0) {
      }
      ::close(first);
      HandOn(::accept(listener_, nullptr, nullptr));
    });
  }
  ~SlowToSayHello() {
    ::shutdown(listener_, SHUT_RDWR);
    threads_.clear();
    ::close(listener_);
  }
  const std::string& address() const { return address_; }
  bool handed_on() const { return handed_on_; }

 private:
  static void Copy(int from, int to) {
    char buffer[65536];
    for (ssize_t n; (n = ::read(from, buffer, sizeof buffer)) > 0;) (void)::send(to, buffer, n, MSG_NOSIGNAL);
    ::shutdown(to, SHUT_RDWR);
  }
  void HandOn(int caller) {
    if (caller < 0) return;
    handed_on_ = true;
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to = {};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<uint16_t>(std::stoi(server_.substr(server_.rfind(':') + 1))));
    EXPECT_EQ(::connect(server, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    {
      const std::jthread back([&] { Copy(server, caller); });
      Copy(caller, server);
    }
    ::close(server);
    ::close(caller);
  }

  const std::string server_;
  const int listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  std::string address_;
  std::atomic<bool> handed_on_ = false;
  std::vector<std::jthread> threads_;
};

TEST(BusyOrchestrator, IsWaitedForWhenItIsSlowToSayHello) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  SlowToSayHello busy(programs.orchestrator());
  const Finished jobs = RunProgram("flair", {"jobs", "--orchestrator", busy.address()});
  EXPECT_EQ(jobs.exit_code, 0) << jobs.err;
  EXPECT_THAT(jobs.err, ::testing::HasSubstr(busy.address() + " is slow to answer"));
  EXPECT_TRUE(busy.handed_on());
}

}  // namespace
}  // namespace flair::testing
