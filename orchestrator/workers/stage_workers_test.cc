// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_workers.h"

#include <gmock/gmock.h>

#include <future>
#include <map>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/testing/test_worker.h"
#include "orchestrator/workers/stage_channels.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Addresses that nobody else listens at or calls from, so that a port there is free when it is wanted, and again.
constexpr char kOwnHost[] = "127.0.9.1";
constexpr char kOtherOwnHost[] = "127.0.9.2";

absl::Status Answer(runtime::CallContext&) { return absl::OkStatus(); }

// Answers nothing until nobody waits any more.
absl::Status Hang(runtime::CallContext& call) {
  runtime::TestGate given_up;
  runtime::OnCancel guard(call.cancellation(), [&] { given_up.Open(); });
  given_up.Wait();
  return absl::CancelledError("given up");
}

class StageWorkersTest : public ::testing::Test {
 protected:
  // The optimizers at these addresses, when all that are listed are ready; the other stages are not called.
  void Start(const std::string& addresses) {
    config_.mutable_stages()->set_language("127.0.0.1:1");
    config_.mutable_stages()->set_translator("127.0.0.1:1");
    config_.mutable_stages()->set_renderer("127.0.0.1:1");
    config_.mutable_stages()->set_optimizer(addresses);
    workers_ = std::make_unique<StageWorkers>(
        *ConnectStages(config_),
        StageWorkersOptions{.calls = config_.stage_calls(),
                            .log =
                                [this](const std::string& remark) {
                                  std::lock_guard lock(mutex_);
                                  remarks_ += remark + "\n";
                                },
                            .lookup = [this](const std::string& host) { return LookUp(host); }},
        runtime::SystemClock());
    const StageAddresses listed = *ParseStageAddresses(addresses);
    for (const std::string& address : listed.workers) {
      WaitForState(address, v1::WORKER_STATE_READY);
    }
  }

  // Who answered one call; or why nobody did.
  absl::StatusOr<std::string> Solve(absl::Duration within = absl::Seconds(60)) {
    StageCall call("r", absl::Now() + within, runtime::SystemClock());
    ASSIGN_OR_RETURN(v1::SolveResponse answer, workers_->clients().Solve({}, call));
    return answer.producer().program();
  }

  // Answers by worker of calls that are made by so many at once.
  std::map<std::string, int> SolveMany(int count, int at_once) {
    std::vector<std::future<std::vector<std::string>>> callers;
    for (int i = 0; i < at_once; ++i) {
      callers.push_back(std::async(std::launch::async, [this, count, at_once] {
        std::vector<std::string> answers;
        for (int made = 0; made < count / at_once; ++made) {
          const absl::StatusOr<std::string> who = Solve();
          answers.push_back(who.ok() ? *who : who.status().ToString());
        }
        return answers;
      }));
    }
    std::map<std::string, int> answers;
    for (auto& caller : callers) {
      for (const std::string& who : caller.get()) ++answers[who];
    }
    return answers;
  }

  // Calls until each of these has answered; nobody else does.
  void SolveUntilAllAnswer(const std::set<std::string>& all) {
    std::set<std::string> answered;
    while (answered.size() < all.size()) {
      for (const auto& [who, count] : SolveMany(4, 4)) {
        ASSERT_TRUE(all.contains(who)) << who;
        answered.insert(who);
      }
    }
  }

  v1::WorkerStatus StatusOf(const std::string& address) const {
    for (const v1::WorkerStatus& status : workers_->Status()) {
      if (status.address() == address && status.stage() == "optimizer") return status;
    }
    return {};
  }

  void WaitForState(const std::string& address, v1::WorkerState state) const {
    while (StatusOf(address).state() != state) std::this_thread::yield();
  }

  absl::StatusOr<std::vector<std::string>> LookUp(const std::string& host) {
    std::lock_guard lock(mutex_);
    looked_up_ = host;
    return addresses_;
  }
  void SetAddresses(absl::StatusOr<std::vector<std::string>> addresses) {
    {
      std::lock_guard lock(mutex_);
      addresses_ = std::move(addresses);
    }
    workers_->LookAgain();
  }

  std::mutex mutex_;
  absl::StatusOr<std::vector<std::string>> addresses_ = std::vector<std::string>{};
  std::string looked_up_;
  std::string remarks_;
  config::v1::OrchestratorConfig config_;
  std::unique_ptr<StageWorkers> workers_;
};

TEST_F(StageWorkersTest, SpreadsCallsOverAllThatAreListed) {
  std::atomic<int> arrived = 0;
  const auto together = [&](runtime::CallContext&) {
    ++arrived;
    while (arrived < 3) std::this_thread::yield();
    return absl::OkStatus();
  };
  TestWorker a(together), b(together), c(together);
  Start(a.address() + "," + b.address() + ", " + c.address());
  EXPECT_EQ(SolveMany(3, 3).size(), 3u);
  EXPECT_EQ(StatusOf(a.address()).call_count(), 1);
}

TEST_F(StageWorkersTest, AWorkerThatGoesAndComesBackIsNoticed) {
  auto a = std::make_unique<TestWorker>(Answer, TestWorkerOptions{.listen_address = absl::StrCat(kOwnHost, ":0")});
  TestWorker b;
  const std::string address = a->address();
  Start(address + "," + b.address());
  a->Kill();
  WaitForState(address, v1::WORKER_STATE_GONE);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(*Solve(), b.address());
  a = nullptr;
  TestWorker again(Answer, {.listen_address = address});
  ASSERT_EQ(again.address(), address);
  SolveUntilAllAnswer({address, b.address()});
}

TEST_F(StageWorkersTest, ACallWhoseWorkerDiesIsMadeOfAnother) {
  TestWorker dying(Hang), other;
  Start(dying.address() + "," + other.address());
  auto answers = std::async(std::launch::async, [&] { return SolveMany(2, 2); });
  while (dying.calls() == 0) std::this_thread::yield();
  dying.Kill();
  EXPECT_EQ(answers.get().at(other.address()), 2);
}

TEST_F(StageWorkersTest, WorkersOfANameJoinAndLeave) {
  TestWorker first(Answer, {.listen_address = absl::StrCat(kOwnHost, ":0")});
  const std::string port = first.address().substr(first.address().rfind(':') + 1);
  Start("dns:///optimizers:" + port);
  EXPECT_THAT(std::string(Solve().status().message()), HasSubstr("its name has no address"));
  SetAddresses(absl::UnavailableError("no name server"));
  while (!absl::StrContains(std::string(Solve().status().message()), "no name server")) std::this_thread::yield();
  SetAddresses(std::vector<std::string>{kOwnHost});
  WaitForState(first.address(), v1::WORKER_STATE_READY);
  EXPECT_EQ(*Solve(), first.address());
  EXPECT_EQ(looked_up_, "optimizers");
  TestWorker second(Answer, {.listen_address = absl::StrCat(kOtherOwnHost, ":", port)});
  ASSERT_EQ(second.address(), absl::StrCat(kOtherOwnHost, ":", port));
  SetAddresses(std::vector<std::string>{kOwnHost, kOtherOwnHost});
  SolveUntilAllAnswer({first.address(), second.address()});
  SetAddresses(absl::UnavailableError("no name server"));
  SolveUntilAllAnswer({first.address(), second.address()});  // What cannot be told changes nothing.
  SetAddresses(std::vector<std::string>{kOtherOwnHost});
  while (!StatusOf(first.address()).address().empty()) std::this_thread::yield();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(*Solve(), second.address());
}

TEST_F(StageWorkersTest, AWorkerThatDrainsEndsItsCallsAndGetsNoMore) {
  runtime::TestGate solving, go_on;
  TestWorker a([&](runtime::CallContext&) {
    solving.Open();
    go_on.Wait();
    return absl::OkStatus();
  });
  Start(a.address());
  auto running = std::async(std::launch::async, [&] { return Solve(); });
  solving.Wait();
  auto drained = std::async(std::launch::async, [&] { a.Drain(); });
  WaitForState(a.address(), v1::WORKER_STATE_GONE);
  EXPECT_EQ(Solve().status().code(), absl::StatusCode::kUnavailable);
  go_on.Open();
  EXPECT_EQ(*running.get(), a.address());
}

TEST_F(StageWorkersTest, WhenAllAreFullCallsWaitInsteadOfFailing) {
  const auto slowly = [](runtime::CallContext& call) {
    WaitUnlessCancelled(absl::Milliseconds(2), call);
    return absl::OkStatus();
  };
  TestWorker a(slowly, {.thread_count = 1, .queue_limit = 1}), b(slowly, {.thread_count = 1, .queue_limit = 1});
  Start(a.address() + "," + b.address());
  const std::map<std::string, int> answers = SolveMany(320, 32);
  EXPECT_EQ(answers.size(), 2u) << answers.begin()->first;
  EXPECT_EQ(StatusOf(a.address()).failure_count(), 0);
}

// Whatever it says: that it is out of order, or that the request is at fault.
class WrongWorker : public StageWorkersTest, public ::testing::WithParamInterface<absl::StatusCode> {};

TEST_P(WrongWorker, HarmsNobodyAndIsBroken) {
  config_.mutable_stage_calls()->set_failure_limit(3);
  config_.mutable_stage_calls()->set_recovery_seconds(0.01);
  TestWorker bad([](runtime::CallContext&) { return absl::Status(GetParam(), "I do not like it"); });
  TestWorker good([](runtime::CallContext& call) {
    WaitUnlessCancelled(absl::Milliseconds(5), call);
    return absl::OkStatus();
  });
  Start(bad.address() + "," + good.address());
  while (StatusOf(bad.address()).state() != v1::WORKER_STATE_BROKEN) SolveUntilAllAnswer({good.address()});
  const int before = bad.calls();
  while (bad.calls() < before + 3) EXPECT_EQ(*Solve(), good.address()) << "calls on trial are made of another";
  std::lock_guard lock(mutex_);
  EXPECT_THAT(remarks_, HasSubstr("optimizer worker at " + bad.address() + " is not called for 10ms"));
  EXPECT_THAT(remarks_, HasSubstr("I do not like it"));
}

INSTANTIATE_TEST_SUITE_P(Stage, WrongWorker,
                         ::testing::Values(absl::StatusCode::kInvalidArgument, absl::StatusCode::kFailedPrecondition,
                                           absl::StatusCode::kInternal));

TEST_F(StageWorkersTest, BytesThatAreNoMessageAreNoAnswer) {
  TestWorker garbage([](runtime::CallContext&) { return absl::OkStatus(); }, {.garbage = true});
  TestWorker good;
  Start(garbage.address() + "," + good.address());
  for (int i = 0; i < 2; ++i) EXPECT_EQ(*Solve(), good.address());
  EXPECT_GT(StatusOf(garbage.address()).failure_count(), 0);
}

TEST_F(StageWorkersTest, WhatTwoSayAgainstARequestCounts) {
  const auto refuse = [](runtime::CallContext&) { return absl::InvalidArgumentError("no such room"); };
  TestWorker a(refuse), b(refuse);
  Start(a.address() + "," + b.address());
  EXPECT_EQ(Solve().status(), absl::InvalidArgumentError("no such room"));
  EXPECT_EQ(a.calls() + b.calls(), 2);
  EXPECT_EQ(StatusOf(a.address()).failure_count() + StatusOf(b.address()).failure_count(), 0);
}

TEST_F(StageWorkersTest, BadAnswersBreakAWorker) {
  config_.mutable_stage_calls()->set_failure_limit(3);
  TestWorker bad;
  Start(bad.address());
  for (int i = 0; i < 3; ++i) {
    StageCall call;
    const absl::Status status = workers_->clients().Solve({}, call).status();
    ASSERT_TRUE(status.ok()) << status;
    call.ReportBadAnswer(absl::InternalError("no layout"));
  }
  EXPECT_EQ(StatusOf(bad.address()).state(), v1::WORKER_STATE_BROKEN);
}

TEST_F(StageWorkersTest, AWorkerThatNeverAnswersIsBroken) {
  config_.mutable_stage_calls()->set_failure_limit(2);
  TestWorker hanging(Hang);
  Start(hanging.address());
  // On a busy machine a call may be late before it reaches anybody, which speaks against nobody.
  int calls = 0;
  for (; StatusOf(hanging.address()).state() != v1::WORKER_STATE_BROKEN; ++calls) {
    EXPECT_EQ(Solve(absl::Milliseconds(50)).status().code(), absl::StatusCode::kDeadlineExceeded);
  }
  EXPECT_GE(calls, 2);
}

TEST_F(StageWorkersTest, ACallThatTakesItsTimeIsMadeOfASecondWorkerAndNoThird) {
  config_.mutable_stage_calls()->set_hedge_seconds(0.02);
  TestWorker hanging(Hang), also_hanging(Hang), third(Hang);
  Start(hanging.address() + "," + also_hanging.address() + "," + third.address());
  const auto calls = [&] { return hanging.calls() + also_hanging.calls() + third.calls(); };
  StageCall call;
  auto answer = std::async(std::launch::async, [&] { return workers_->clients().Solve({}, call).status(); });
  while (calls() < 2) std::this_thread::yield();
  // Many times as long as the second was waited for.
  EXPECT_EQ(answer.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout);
  EXPECT_EQ(calls(), 2);
  call.cancellation().Cancel();
  EXPECT_EQ(answer.get().code(), absl::StatusCode::kCancelled);
}

TEST_F(StageWorkersTest, TheFirstAnswerCountsAndTheOtherCallIsCancelled) {
  config_.mutable_stage_calls()->set_hedge_seconds(0.02);
  TestWorker hanging(Hang);
  // Whichever is called first, the other is asked as well.
  TestWorker quick([&](runtime::CallContext& call) {
    while (hanging.calls() == 0 && !call.cancelled()) std::this_thread::yield();
    return absl::OkStatus();
  });
  Start(hanging.address() + "," + quick.address());
  for (int i = 0; i < 10; ++i) EXPECT_EQ(*Solve(), quick.address());
  EXPECT_EQ(StatusOf(hanging.address()).in_flight_count(), 0);
  EXPECT_EQ(StatusOf(hanging.address()).state(), v1::WORKER_STATE_BROKEN);
  EXPECT_EQ(hanging.calls(), 1) << "once was enough";
}

TEST_F(StageWorkersTest, WithoutASecondWorkerTheFirstIsWaitedFor) {
  config_.mutable_stage_calls()->set_hedge_seconds(0.001);
  TestWorker slow([](runtime::CallContext& call) {
    WaitUnlessCancelled(absl::Milliseconds(100), call);
    return absl::OkStatus();
  });
  Start(slow.address());
  EXPECT_EQ(*Solve(), slow.address());
  EXPECT_EQ(slow.calls(), 1);
}

TEST_F(StageWorkersTest, ACancelledCallEndsAtOnceWhereverItIs) {
  config_.mutable_stage_calls()->set_in_flight_limit(1);
  TestWorker hanging(Hang);
  Start(hanging.address());
  StageCall running, waiting;
  auto first = std::async(std::launch::async, [&] { return workers_->clients().Solve({}, running).status(); });
  while (hanging.calls() == 0) std::this_thread::yield();
  auto second = std::async(std::launch::async, [&] { return workers_->clients().Solve({}, waiting).status(); });
  waiting.cancellation().Cancel();
  EXPECT_EQ(second.get().code(), absl::StatusCode::kCancelled);
  running.cancellation().Cancel();
  EXPECT_EQ(first.get().code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(hanging.calls(), 1);
}

TEST_F(StageWorkersTest, AnswersSayWhichRevisionTheyAreOf) {
  TestWorker old_one(Answer, {.revision = "old"}), new_one(Answer, {.revision = "new"});
  Start(old_one.address() + "," + new_one.address());
  std::map<std::string, std::set<std::string>> revisions;
  while (revisions.size() < 2) {
    StageCall call;
    const std::string who = workers_->clients().Solve({}, call)->producer().program();
    revisions[who].insert(call.answerer()->revision.value());
  }
  EXPECT_THAT(revisions[old_one.address()], ::testing::ElementsAre(HasSubstr("/old")));
  EXPECT_THAT(revisions[new_one.address()], ::testing::ElementsAre(HasSubstr("/new")));
}

TEST_F(StageWorkersTest, AWorkerThatWasReplacedIsOfItsNewRevision) {
  auto worker = std::make_unique<TestWorker>(
      Answer, TestWorkerOptions{.revision = "old", .listen_address = absl::StrCat(kOwnHost, ":0")});
  const std::string address = worker->address();
  Start(address);
  StageCall call;
  EXPECT_THAT(**workers_->clients().Revision(v1::ARTIFACT_KIND_SOLVED_LAYOUT, call), HasSubstr("/old"));
  worker = nullptr;
  WaitForState(address, v1::WORKER_STATE_GONE);
  TestWorker other(Answer, {.revision = "new", .listen_address = address});
  WaitForState(address, v1::WORKER_STATE_READY);
  EXPECT_THAT(**workers_->clients().Revision(v1::ARTIFACT_KIND_SOLVED_LAYOUT, call), HasSubstr("/new"));
}

TEST_F(StageWorkersTest, WhatIsTooLargeForAnyIsSaidAtOnce) {
  config_.mutable_runtime()->set_max_message_mib(1);
  TestWorker a;
  Start(a.address());
  v1::SolveRequest request;
  request.set_request_id(std::string(2 << 20, 'x'));
  StageCall call;
  EXPECT_EQ(workers_->clients().Solve(request, call).status().code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(StatusOf(a.address()).failure_count(), 0);
}

}  // namespace
}  // namespace flair::orchestrator
