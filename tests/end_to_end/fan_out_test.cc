// SPDX-License-Identifier: GPL-3.0-or-later
// A solve spread over several optimizer processes gives the same bytes as one alone, whatever happens to the others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <memory>

#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

constexpr char kListen[] = "runtime { listen_address: \"127.0.0.1:0\" log_level: \"warning\" }\n";

// An optimizer that knows others, and a room for it to solve.
class FanOut : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    const Finished run =
        RunProgram("flair", {"design", "A bedroom that is 4m x 5m.", "--out", *folder_ / "room", "--quiet"},
                   {{"FLAIR_HOME", *folder_ / "home"}});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    alone_ = Solve("alone", "");
    ASSERT_FALSE(alone_.empty());
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::vector<std::string> Arguments(const std::string& out, const std::string& optimizer) {
    std::vector<std::string> arguments = {"solve",      (folder_->path() / "room" / "graph.pb").string(),
                                          "--restarts", "32",
                                          "--seed",     "5",
                                          "--threads",  "1",
                                          "--out",      *folder_ / (out + ".pb")};
    if (!optimizer.empty()) arguments.insert(arguments.end(), {"--optimizer", optimizer});
    return arguments;
  }
  static std::string Solve(const std::string& out, const std::string& optimizer) {
    const Finished run = RunProgram("flair", Arguments(out, optimizer));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return ReadAll(*folder_ / (out + ".pb"));
  }

  static std::unique_ptr<ServerProgram> Start(const std::string& name, const std::string& peers = "",
                                              const std::string& program_name = "flair-optimizer") {
    const std::filesystem::path folder = folder_->path() / name;
    std::filesystem::create_directories(folder);
    auto program = std::make_unique<ServerProgram>(program_name, kListen + peers, folder);
    EXPECT_NE(program->address(), "");
    return program;
  }
  static std::string PeerLine(const ServerProgram& peer) { return "peer_addresses: \"" + peer.address() + "\"\n"; }

  static std::unique_ptr<TestFolder> folder_;
  static std::string alone_;
};

std::unique_ptr<TestFolder> FanOut::folder_;
std::string FanOut::alone_;

TEST_F(FanOut, OneAndThreePeersGiveTheSameBytes) {
  const auto a = Start("a"), b = Start("b"), c = Start("c");
  EXPECT_TRUE(Solve("one", Start("one_driver", PeerLine(*a))->address()) == alone_);
  EXPECT_TRUE(Solve("three", Start("three_driver", PeerLine(*a) + PeerLine(*b) + PeerLine(*c))->address()) == alone_);
}

TEST_F(FanOut, APeerThatIsKilledInTheMiddleChangesNothing) {
  const auto a = Start("killed"), b = Start("survivor");
  const auto driver = Start("killed_driver", PeerLine(*a) + PeerLine(*b));
  Process solve(ProgramPath("flair"), Arguments("killed", driver->address()));
  a->process().Signal(SIGKILL);
  EXPECT_EQ(solve.Wait().exit_code, 0);
  EXPECT_TRUE(ReadAll(*folder_ / "killed.pb") == alone_);
  EXPECT_TRUE(Solve("after", driver->address()) == alone_) << "with the peer gone for good";
}

TEST_F(FanOut, APeerThatStandsStillHoldsNobodyUp) {
  const auto a = Start("stopped");
  const auto driver = Start("stopped_driver", PeerLine(*a));
  EXPECT_TRUE(Solve("before", driver->address()) == alone_);
  a->process().Signal(SIGSTOP);
  EXPECT_TRUE(Solve("stopped", driver->address()) == alone_);
  a->process().Signal(SIGCONT);
}

TEST_F(FanOut, APeerOfAnotherBuildIsRefusedAndTheOwnThreadsDoItsWork) {
  const auto other = Start("other_build", "", "../test_bin/flair_other_optimizer");
  const auto driver = Start("other_build_driver", PeerLine(*other));
  EXPECT_TRUE(Solve("other_build", driver->address()) == alone_);
  driver->process().Signal(SIGTERM);
  const std::string log = driver->process().Wait().err;
  EXPECT_THAT(log, HasSubstr("peer " + other->address() + " is left out"));
  EXPECT_THAT(log, HasSubstr("it is flair-optimizer slsqp 1, build another-build; this optimizer is flair-optimizer "
                             "slsqp 1, build " +
                             BuildOfFlair()));
}

TEST_F(FanOut, APeerAddressThatCannotBeIsRefusedAtTheStart) {
  WriteAll(*folder_ / "bad.textproto", std::string(kListen) + "peer_addresses: \"nowhere\"\n");
  const Finished run = RunProgram("flair-optimizer", {*folder_ / "bad.textproto"});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.err.find("peer_addresses[0]"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace flair::testing
