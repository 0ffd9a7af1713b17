// SPDX-License-Identifier: GPL-3.0-or-later
// Callers who send too much, too slowly or too often: they are refused, and others do not notice.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

#include "absl/time/clock.h"
#include "tests/security/attacks.h"
#include "tests/security/secure_programs.h"

namespace flair::testing {
namespace {

constexpr char kSolve[] = "/flair.v1.OptimizerService/Solve";

// Plain text, on a free port.
class PlainOptimizer {
 public:
  PlainOptimizer()
      : program_("flair-optimizer", "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n",
                 folder_.path()) {}
  const std::string& address() const { return program_.address(); }
  Process& process() { return program_.process(); }

 private:
  TestFolder folder_;
  ServerProgram program_;
};

// The same of an orchestrator, which knows the token "good".
class PlainOrchestrator {
 public:
  PlainOrchestrator() {
    WriteAll(folder_ / "tokens.textproto", TokenEntry("alice", "good"));
    program_ = std::make_unique<ServerProgram>(
        "flair-orchestrator",
        fmt::format("runtime {{ listen_address: \"127.0.0.1:0\" log_level: \"error\" }} store_path: \"{0}/store\" "
                    "tokens_path: \"{0}/tokens.textproto\" stages {{ language: \"127.0.0.1:1\" translator: "
                    "\"127.0.0.1:1\" optimizer: \"127.0.0.1:1\" renderer: \"127.0.0.1:1\" }}\n",
                    folder_.path().string()),
        folder_.path());
  }
  const std::string& address() const { return program_->address(); }
  Process& process() { return program_->process(); }

 private:
  TestFolder folder_;
  std::unique_ptr<ServerProgram> program_;
};

// Asks over a connection of its own until it is told to stop; counts what came of it.
class Innocent {
 public:
  explicit Innocent(const std::string& address)
      : done_(std::async(std::launch::async, [this, address] {
          while (!stop_) {
            // Three attempts, as a job has: a connection may go as it comes, which is not the call's fault.
            absl::Status status = AskWho(address, {});
            for (int attempt = 1; attempt < 3 && absl::IsUnavailable(status); ++attempt) status = AskWho(address, {});
            if (status.ok()) {
              ++answered_;
            } else {
              ADD_FAILURE() << status;
              ++refused_;
            }
          }
        })) {}
  // At least one call was made while it ran.
  void Stop() {
    while (answered_ + refused_ == 0) std::this_thread::yield();
    stop_ = true;
    done_.get();
  }
  int answered() const { return answered_; }
  int refused() const { return refused_; }

 private:
  std::atomic<bool> stop_ = false;
  std::atomic<int> answered_ = 0;
  std::atomic<int> refused_ = 0;
  std::future<void> done_;
};

TEST(Flood, AMessageOfAGigabyteIsNotTakenIn) {
  PlainOptimizer optimizer;
  ASSERT_TRUE(AskWho(optimizer.address(), {}).ok());
  const int before_mib = PeakMib(optimizer.process());
  Innocent innocent(optimizer.address());
  std::vector<std::future<grpc::Status>> attackers;
  for (int i = 0; i < 2; ++i) {
    attackers.push_back(std::async(std::launch::async, [&] { return SendMessage(optimizer.address(), kSolve, 1024); }));
  }
  for (auto& attacker : attackers) EXPECT_EQ(attacker.get().error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  innocent.Stop();
  EXPECT_EQ(innocent.refused(), 0) << "of " << innocent.answered();
  // gRPC alone would take in both, whole.
  EXPECT_LT(PeakMib(optimizer.process()) - before_mib, 600);
}

TEST(Flood, AMessageBeyondTheLimitIsRefusedAndOneWithinItIsNot) {
  PlainOptimizer optimizer;
  const grpc::Status over = SendMessage(optimizer.address(), kSolve, 33);
  EXPECT_EQ(over.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED) << over.error_message();
  // No request of ours, but taken in.
  EXPECT_NE(SendMessage(optimizer.address(), kSolve, 31).error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

// What a server has taken at most when ten callers have sent it 30 MiB each.
int PeakOfTen(const std::string& address, Process& process, const std::string& method, const std::string& unit,
              const std::string& token) {
  std::vector<std::future<grpc::Status>> callers;
  for (int i = 0; i < 10; ++i) {
    callers.push_back(std::async(std::launch::async, SendMessage, address, method, 30, unit, token));
  }
  for (auto& caller : callers) caller.wait();
  fmt::print("{} {}: {} MiB\n", method, token, PeakMib(process));
  return PeakMib(process);
}

const std::string kUnknownField("\xfa\x3e\0", 3);

// Whoever it is: health is told without a token.
TEST(Flood, HealthTakesInNoLargeMessage) {
  for (const char* method : {"/grpc.health.v1.Health/Check", "/grpc.health.v1.Health/Watch"}) {
    for (const char* token : {"", "bad", "good"}) {
      PlainOrchestrator orchestrator;
      EXPECT_LT(PeakOfTen(orchestrator.address(), orchestrator.process(), method, kUnknownField, token), 300);
    }
    PlainOptimizer optimizer;
    EXPECT_LT(PeakOfTen(optimizer.address(), optimizer.process(), method, kUnknownField, ""), 300);
  }
}

// Ten callers, 30 MiB each of fields that are empty: 15.7 million job specs, or what no message of ours has. Not even
// who may call may make a server unfold them.
TEST(Flood, SmallFieldsDoNotUnfold) {
  const std::string spec("\x12\0", 2);
  const std::string number("\xf8\x3e\1", 3);
  constexpr char kBatch[] = "/flair.v1.OrchestratorService/CreateBatch";
  constexpr char kWatch[] = "/flair.v1.OrchestratorService/WatchJob";
  constexpr char kWho[] = "/flair.v1.WorkerService/GetWorker";
  constexpr char kReflection[] = "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo";
  PlainOrchestrator orchestrator;
  for (const char* token : {"bad", "good"}) {
    EXPECT_LT(PeakOfTen(orchestrator.address(), orchestrator.process(), kBatch, spec, token), 300);
    EXPECT_LT(PeakOfTen(orchestrator.address(), orchestrator.process(), kBatch, number, token), 300);
    EXPECT_LT(PeakOfTen(orchestrator.address(), orchestrator.process(), kWatch, kUnknownField, token), 300);
  }
  PlainOptimizer optimizer;
  for (const char* method : {kSolve, kWho, kReflection}) {
    EXPECT_LT(PeakOfTen(optimizer.address(), optimizer.process(), method, kUnknownField, ""), 300);
  }
}

// Both servers wait at the same time.
TEST(Flood, HalfAHandshakeIsNotWaitedForLongWithTlsOrWithout) {
  PlainOptimizer optimizer;
  SecureOptimizer secure("log_level: \"error\"");
  Sockets silent;
  Sockets slow;
  Sockets slow_tls;
  for (int i = 0; i < 150; ++i) {
    // From other addresses: one has a share of the connections, which is small where few files may be open.
    ASSERT_TRUE(silent.Connect(optimizer.address(), "127.0.0.2"));
    ASSERT_TRUE(slow.Connect(optimizer.address(), "127.0.0.3"));
    ASSERT_TRUE(slow_tls.Connect(secure.address()));
  }
  // One says nothing at all, the others begin and leave it at that.
  EXPECT_EQ(slow.SendToAll(kPreface.substr(0, 10)), 150);
  // The beginning of a ClientHello.
  EXPECT_EQ(slow_tls.SendToAll(std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11)), 150);
  Innocent innocent(optimizer.address());
  EXPECT_TRUE(AskWho(secure.address(), secure.Friend()).ok());
  EXPECT_EQ(silent.WaitForClose(60), 0);
  EXPECT_EQ(slow.WaitForClose(60), 0);
  EXPECT_EQ(slow_tls.WaitForClose(60), 0);
  EXPECT_TRUE(AskWho(secure.address(), secure.Friend()).ok());
  innocent.Stop();
  EXPECT_EQ(innocent.refused(), 0) << "of " << innocent.answered();
}

TEST(Flood, HeadersThatNeverEndTakeNoThread) {
  PlainOptimizer optimizer;
  Sockets slow;
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(slow.Connect(optimizer.address(), i % 2 == 0 ? "127.0.0.2" : "127.0.0.3"));
  }
  EXPECT_EQ(slow.SendToAll(kPreface + kEndlessHeaders), 300);
  Innocent innocent(optimizer.address());
  // One byte of headers after the other, each a frame of its own.
  for (int i = 0; i < 50; ++i) slow.SendToAll(kMoreHeaders);
  innocent.Stop();
  EXPECT_EQ(innocent.refused(), 0) << "of " << innocent.answered();
}

// gRPC keeps headers until they end, however many there are. Frames of 16 KB, each one header.
TEST(Flood, HeadersThatNeverEndDoNotPileUp) {
  PlainOptimizer optimizer;
  const std::string field = std::string("\0\1x\x7f\x81\x7c", 6) + std::string(16000, 'a');
  const std::string frame = std::string("\0\x3e\x86\x9\0\0\0\0\1", 9) + field;
  std::vector<std::future<void>> attackers;
  for (int i = 0; i < 10; ++i) {
    attackers.push_back(std::async(std::launch::async, [&, i] {
      Sockets endless;
      ASSERT_TRUE(endless.Connect(optimizer.address(), fmt::format("127.0.0.{}", 2 + i)));
      endless.SendToLast(kPreface + kEndlessHeaders);
      for (int i = 0; i < 20'000 && endless.SendAllToLast(frame); ++i) continue;
    }));
  }
  for (auto& attacker : attackers) attacker.wait();
  EXPECT_TRUE(AskWho(optimizer.address(), {}).ok());
  fmt::print("{} MiB\n", PeakMib(optimizer.process()));
  // 110 to 220: what is sent before they are looked at. All that they send is 3 GiB.
  EXPECT_LT(PeakMib(optimizer.process()), 300);
}

// gRPC copies the header that is not whole for every frame that continues it: 30 KB of it and a byte in each frame
// keep a thread busy.
TEST(Flood, HeadersInTinyFramesHoldUpNobody) {
  PlainOptimizer optimizer;
  // A value of 268 MB.
  const std::string begin("\0\x0f\xa0\x9\0\0\0\0\1\0\1x\x7f\xff\xff\xff\x7f", 17);
  std::string tiny;
  for (int i = 0; i < 10'000; ++i) tiny += std::string("\0\0\1\x9\0\0\0\0\1a", 10);
  std::atomic<bool> stop = false;
  std::vector<std::future<void>> attackers;
  for (int i = 0; i < 4; ++i) {
    attackers.push_back(std::async(std::launch::async, [&, i] {
      Sockets endless;
      ASSERT_TRUE(endless.Connect(optimizer.address(), fmt::format("127.0.0.{}", 2 + i)));
      endless.SendToLast(kPreface + kEndlessHeaders);
      endless.SendAllToLast(begin + std::string(4000 - 8, 'a'));
      while (!stop && endless.SendAllToLast(tiny)) continue;
    }));
  }
  Innocent innocent(optimizer.address());
  // They are sent away.
  for (auto& attacker : attackers) attacker.wait();
  stop = true;
  innocent.Stop();
  EXPECT_EQ(innocent.refused(), 0) << "of " << innocent.answered();
}

TEST(Flood, WhoAsksAllTheTimeWhetherWeAreThereIsSentAway) {
  PlainOptimizer optimizer;
  Sockets nervous;
  ASSERT_TRUE(nervous.Connect(optimizer.address()));
  nervous.SendToAll(kPreface);
  // PING frames.
  for (int i = 0; i < 20; ++i) nervous.SendToAll(std::string("\0\0\x08\6\0\0\0\0\0abcdefgh", 17));
  EXPECT_EQ(nervous.WaitForClose(60), 0);
  EXPECT_TRUE(AskWho(optimizer.address(), {}).ok());
}

// A server that may open few files, which is what a container often gives it.
TEST(Flood, AServerWithoutFilesAnswersAgainWhenThereAreSome) {
  const TestFolder folder;
  WriteAll(folder / "config.textproto", "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n");
  Process optimizer("/usr/bin/prlimit", {"--nofile=256:256", ProgramPath("flair-optimizer").string(),
                                         (folder / "config.textproto").string()});
  const std::string address = optimizer.WaitForLine("listening on ");
  ASSERT_NE(address, "");
  {
    Sockets flood;
    for (int i = 0; i < 600; ++i) flood.Connect(address, "127.0.0.2");
    flood.SendToAll(kPreface);
    // Others than the one who floods are served all the while.
    EXPECT_TRUE(AskWho(address, {}).ok());
    EXPECT_LT(flood.CountOpen(), 256);
  }
  EXPECT_TRUE(AskWho(address, {}).ok());
}

// Ten thousand connections that do nothing but be there, from two addresses: those beyond their share are refused.
TEST(Flood, TenThousandConnectionsAreNoBurden) {
  constexpr int kConnections = 10000;
  const int files = RaiseFileLimit();
  if (files < kConnections + 100) GTEST_SKIP() << "this process may open only " << files << " files";
  PlainOptimizer optimizer;
  ASSERT_TRUE(AskWho(optimizer.address(), {}).ok());
  Sockets flood;
  for (int i = 0; i < kConnections; ++i) {
    flood.Connect(optimizer.address(), i % 2 == 0 ? "127.0.0.2" : "127.0.0.3");
    // At once: who has not said it in time is left, and all together may take longer.
    flood.SendToLast(kPreface);
  }
  EXPECT_EQ(flood.count(), kConnections);
  std::vector<double> milliseconds;
  for (int i = 0; i < 200; ++i) {
    const absl::Time begin = absl::Now();
    const absl::Status status = AskWho(optimizer.address(), {});
    ASSERT_TRUE(status.ok()) << status;
    milliseconds.push_back(absl::ToDoubleMilliseconds(absl::Now() - begin));
  }
  const int open = flood.CountOpen();
  EXPECT_GT(open, 1000);
  EXPECT_LT(open, 2000);
  std::ranges::sort(milliseconds);
  fmt::print("{} connections, {} kept: a call takes {:.1f} ms (median), {:.1f} ms (99 %); the server {} MiB\n",
             kConnections, open, milliseconds[100], milliseconds[198], PeakMib(optimizer.process()));
  EXPECT_LT(PeakMib(optimizer.process()), 400);
}

}  // namespace
}  // namespace flair::testing
