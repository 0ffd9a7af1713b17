// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::HasSubstr;

class WorkerPoolTest : public ::testing::Test {
 protected:
  WorkerPoolTest() { pool_.SetFound(absl::OkStatus()); }

  WorkerId AddReady(const std::string& address, std::optional<std::string> revision = "1") {
    const WorkerId id = pool_.Add(address);
    pool_.SetReady(id, std::move(revision));
    return id;
  }

  // One call of a worker, chosen by the pool, that takes so long and ends so; -1 when none has room.
  WorkerId Call(absl::Duration duration = absl::Milliseconds(10), Verdict verdict = Verdict::kGood,
                const std::set<WorkerId>& tried = {}) {
    const std::optional<Place> place = pool_.TryTake(tried);
    if (!place.has_value()) return -1;
    clock_.Advance(duration);
    pool_.End(*place, verdict);
    return place->worker;
  }

  void Break(WorkerId id) {
    std::set<WorkerId> others;
    for (WorkerId other = 1; other < 10; ++other) {
      if (other != id) others.insert(other);
    }
    for (int i = 0; i < options_.failure_limit; ++i) {
      ASSERT_EQ(Call(absl::Milliseconds(1), Verdict::kFailed, others), id);
    }
  }

  v1::WorkerStatus StatusOf(const std::string& address) const {
    for (const v1::WorkerStatus& status : pool_.Status()) {
      if (status.address() == address) return status;
    }
    return {};
  }

  runtime::FakeClock clock_;
  WorkerPoolOptions options_ = {.stage = "optimizer", .setting = "stages.optimizer", .in_flight_limit = 4};
  WorkerPool pool_{options_, clock_};
  runtime::CallContext call_;
};

TEST_F(WorkerPoolTest, WorkersTakeTurns) {
  const std::set<WorkerId> workers = {AddReady("a:1"), AddReady("b:1"), AddReady("c:1")};
  for (int round = 0; round < 10; ++round) {
    std::set<WorkerId> called;
    std::vector<Place> places;
    for (int i = 0; i < 3; ++i) places.push_back(*pool_.TryTake({}));
    for (const Place& place : places) called.insert(place.worker);
    EXPECT_EQ(called, workers);
    clock_.Advance(absl::Milliseconds(10));
    for (const Place& place : places) pool_.End(place, Verdict::kGood);
  }
}

TEST_F(WorkerPoolTest, ABusyWorkerKeepsItsTurn) {
  const WorkerId busy = AddReady("busy:1"), other = AddReady("b:1");
  EXPECT_EQ(pool_.TryTake({other})->worker, busy);
  EXPECT_EQ(pool_.TryTake({})->worker, other);
  EXPECT_EQ(pool_.TryTake({})->worker, busy) << "in rotation, however many calls it has";
}

TEST_F(WorkerPoolTest, NoWorkerGetsMoreThanItMay) {
  AddReady("a:1");
  AddReady("b:1");
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(pool_.TryTake({}).has_value());
  EXPECT_FALSE(pool_.TryTake({}).has_value());
  EXPECT_EQ(StatusOf("a:1").in_flight_count(), 4);
}

TEST_F(WorkerPoolTest, CallsWaitInLineInTheOrderInWhichTheyCame) {
  options_.in_flight_limit = 1;
  WorkerPool pool(options_, runtime::SystemClock());
  pool.SetFound(absl::OkStatus());
  pool.SetReady(pool.Add("a:1"), "1");
  const Place first = *pool.TryTake({});
  std::mutex mutex;
  std::vector<int> order;
  std::vector<std::thread> threads;
  for (int i = 0; i < 5; ++i) {
    std::promise<void> about_to_wait;
    threads.emplace_back([&, i] {
      runtime::CallContext call;
      about_to_wait.set_value();
      const Place place = *pool.Take({}, call);
      {
        std::lock_guard lock(mutex);
        order.push_back(i);
      }
      pool.End(place, Verdict::kGood);
    });
    about_to_wait.get_future().wait();
    while (pool.waiting() < i + 1) std::this_thread::yield();
  }
  pool.End(first, Verdict::kGood);
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(order, ::testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST_F(WorkerPoolTest, AWaitingCallCanBeCancelledAndEndsAtItsDeadline) {
  AddReady("a:1");
  while (pool_.TryTake({}).has_value()) {
  }
  auto waiting = std::async(std::launch::async, [&] { return pool_.Take({}, call_).status(); });
  call_.cancellation().Cancel();
  EXPECT_EQ(waiting.get().code(), absl::StatusCode::kCancelled);
  runtime::CallContext late("", clock_.Now(), clock_);
  EXPECT_EQ(pool_.Take({}, late).status().code(), absl::StatusCode::kDeadlineExceeded);
  EXPECT_EQ(pool_.waiting(), 0);
}

TEST_F(WorkerPoolTest, WaitsForAWorkerThatIsBeingReached) {
  const WorkerId id = pool_.Add("a:1");
  auto waiting = std::async(std::launch::async, [&] { return pool_.Take({}, call_); });
  while (pool_.waiting() == 0) std::this_thread::yield();
  pool_.SetReady(id, "7");
  EXPECT_EQ(waiting.get()->revision, "7");
}

TEST_F(WorkerPoolTest, ACallThatCannotGoToAFreeWorkerKeepsNobodyElseFromIt) {
  const WorkerId a = AddReady("a:1"), b = AddReady("b:1");
  while (pool_.TryTake({a}).has_value()) {
  }
  auto waiting = std::async(std::launch::async, [&] { return pool_.Take({a}, call_); });
  while (pool_.waiting() == 0) std::this_thread::yield();
  runtime::CallContext other;
  EXPECT_EQ(pool_.Take({}, other)->worker, a);
  pool_.Remove(b);
  EXPECT_EQ(waiting.get().status().code(), absl::StatusCode::kUnavailable);
}

TEST_F(WorkerPoolTest, SaysWhoIsNotReachableAndWhatToDo) {
  const WorkerId a = pool_.Add("a:1");
  pool_.SetGone(a, absl::UnavailableError("connection refused"));
  EXPECT_EQ(pool_.Take({}, call_).status().message(),
            "optimizer worker at a:1 is not reachable: connection refused; start it or fix stages.optimizer");
  const WorkerId b = pool_.Add("b:1");
  pool_.SetGone(b, absl::UnavailableError("no route"));
  EXPECT_THAT(std::string(pool_.Take({}, call_).status().message()),
              HasSubstr("none of the 2 optimizer workers is reachable; the one at a:1: connection refused"));
  pool_.SetGone(b, absl::UnimplementedError("speaks flair.v2"));
  EXPECT_EQ(pool_.Take({}, call_).status(), absl::UnimplementedError("speaks flair.v2"));
  pool_.Remove(a);
  pool_.Remove(b);
  pool_.SetFound(absl::UnavailableError("the name x is not known"));
  EXPECT_THAT(std::string(pool_.Take({}, call_).status().message()), HasSubstr("the name x is not known"));
}

TEST_F(WorkerPoolTest, AnswersToOtherQuestionsDoNotHideThatOneKindFails) {
  AddReady("a:1");
  for (int i = 0; i < options_.failure_limit; ++i) {
    for (const auto& [request, verdict] :
         {std::pair("EvaluateRequest", Verdict::kGood), std::pair("SolveRequest", Verdict::kFailed)}) {
      Place place = *pool_.TryTake({});
      place.request = request;
      pool_.End(place, verdict);
    }
  }
  EXPECT_EQ(StatusOf("a:1").state(), v1::WORKER_STATE_BROKEN);
}

TEST_F(WorkerPoolTest, ABrokenWorkerIsNotCalledUntilItsTrial) {
  const WorkerId a = AddReady("a:1"), b = AddReady("b:1");
  Break(a);
  EXPECT_EQ(StatusOf("a:1").state(), v1::WORKER_STATE_BROKEN);
  EXPECT_EQ(StatusOf("a:1").failure_count(), 5);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(Call(), b);
  clock_.Advance(options_.recovery);
  const Place trial = *pool_.TryTake({});
  EXPECT_EQ(trial.worker, a) << "first, or it would never show that it works";
  EXPECT_TRUE(trial.on_trial);
  EXPECT_EQ(Call(), b) << "one trial at a time";
  pool_.End(trial, Verdict::kGood);
  EXPECT_EQ(StatusOf("a:1").state(), v1::WORKER_STATE_READY);
}

TEST_F(WorkerPoolTest, WhatIsWrongWithARequestSpeaksAgainstNobody) {
  AddReady("a:1");
  for (int i = 0; i < 50; ++i) EXPECT_NE(Call(absl::ZeroDuration(), VerdictOf(absl::InvalidArgumentError("x"))), -1);
  for (int i = 0; i < 50; ++i) EXPECT_NE(Call(absl::ZeroDuration(), VerdictOf(absl::CancelledError("x"))), -1);
  EXPECT_EQ(StatusOf("a:1").failure_count(), 0);
  EXPECT_EQ(StatusOf("a:1").call_count(), 50) << "calls that were given up have no answer";
}

TEST_F(WorkerPoolTest, AWitnessIsAnotherOneThatWorksOfTheSameRevisionIfThereIsOne) {
  const WorkerId a = AddReady("a:1"), broken = AddReady("broken:1");
  Break(broken);
  const Place place = *pool_.TryTake({broken});
  ASSERT_EQ(place.worker, a);
  EXPECT_FALSE(pool_.TakeWitness(place, {a}).has_value());
  const WorkerId other = AddReady("other:1", "2");
  EXPECT_EQ(pool_.TakeWitness(place, {a})->worker, other);
  const WorkerId twin = AddReady("twin:1");
  while (pool_.TryTake({}).has_value()) {
  }
  EXPECT_EQ(pool_.TakeWitness(place, {a})->worker, twin) << "though it is full";
}

TEST_F(WorkerPoolTest, ACallIsLateByWhatIsUsualForItsKind) {
  AddReady("a:1");
  Place place = *pool_.TryTake({});
  place.request = "SolveRequest";
  const absl::Duration unknown = pool_.Patience(place);
  EXPECT_LE(unknown, absl::Seconds(8));
  clock_.Advance(absl::Minutes(1));
  pool_.End(place, Verdict::kGood);
  EXPECT_GE(pool_.Patience(place), absl::Minutes(2));
  place.request = "EvaluateRequest";
  EXPECT_EQ(pool_.Patience(place), unknown);
}

TEST_F(WorkerPoolTest, WhoeverIsBeatenIsNotCalledForAWhile) {
  const WorkerId a = AddReady("a:1"), b = AddReady("b:1");
  EXPECT_EQ(Call(absl::Seconds(9), Verdict::kBeaten, {b}), a);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(Call(), b);
}

TEST_F(WorkerPoolTest, JobsMayWaitForTheEndOfAnOutageButNotForEver) {
  const WorkerId a = pool_.Add("a:1");
  const auto outage = [&] { return IsOutage(pool_.Take({}, call_).status()); };
  pool_.SetGone(a, absl::UnavailableError("connection refused"));
  EXPECT_TRUE(outage());
  clock_.Advance(options_.outage_limit - absl::Seconds(1));
  EXPECT_TRUE(outage());
  clock_.Advance(absl::Seconds(1));
  EXPECT_FALSE(outage());
  pool_.SetReady(a, "1");
  pool_.SetGone(a, absl::UnavailableError("connection refused"));
  EXPECT_TRUE(outage());
  pool_.SetGone(a, absl::UnimplementedError("speaks flair.v2"));
  EXPECT_FALSE(outage()) << "no patience mends that";
}

TEST_F(WorkerPoolTest, LatenessOfCallsThatCameTooLateSpeaksAgainstNobody) {
  AddReady("a:1");
  for (int i = 0; i < 5; ++i) Call(absl::Seconds(10));
  for (int i = 0; i < 20; ++i) Call(absl::Milliseconds(1), Verdict::kLate);
  EXPECT_EQ(StatusOf("a:1").state(), v1::WORKER_STATE_READY);
  for (int i = 0; i < 5; ++i) Call(absl::Seconds(600), Verdict::kLate);
  EXPECT_EQ(StatusOf("a:1").state(), v1::WORKER_STATE_BROKEN);
}

TEST_F(WorkerPoolTest, WhenAllAreBrokenCallsWaitForTheTrialAndShareItsEnd) {
  const WorkerId a = AddReady("a:1");
  Break(a);
  clock_.Advance(options_.recovery);
  const Place trial = *pool_.TryTake({});
  std::vector<std::future<absl::Status>> waiting;
  for (int i = 0; i < 3; ++i) {
    waiting.push_back(std::async(std::launch::async, [&] {
      runtime::CallContext call;
      return pool_.Take({}, call).status();
    }));
  }
  while (pool_.waiting() < 3) std::this_thread::yield();
  pool_.End(trial, Verdict::kFailed);
  for (auto& status : waiting) EXPECT_EQ(status.get().code(), absl::StatusCode::kUnavailable);
}

TEST_F(WorkerPoolTest, AFullWorkerIsNotBrokenAndOthersAreCalledMeanwhile) {
  const WorkerId a = AddReady("a:1"), b = AddReady("b:1");
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(Call(absl::ZeroDuration(), Verdict::kFull, {b}), a);
    EXPECT_EQ(Call(absl::Milliseconds(1)), b);
    clock_.Advance(absl::Seconds(2));
  }
  EXPECT_EQ(StatusOf("a:1").state(), v1::WORKER_STATE_READY);
  EXPECT_EQ(StatusOf("a:1").failure_count(), 0);
}

TEST_F(WorkerPoolTest, AFullWorkerIsLeftAloneForAMomentLongerEachTime) {
  const WorkerId a = AddReady("a:1");
  for (const int rest_ms : {20, 40, 80}) {
    ASSERT_EQ(Call(absl::ZeroDuration(), Verdict::kFull), a);
    EXPECT_EQ(Call(), -1);
    clock_.Advance(absl::Milliseconds(rest_ms) - absl::Nanoseconds(1));
    EXPECT_EQ(Call(), -1);
    clock_.Advance(absl::Nanoseconds(1));
  }
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(Call(absl::ZeroDuration(), Verdict::kFull), a);
    clock_.Advance(absl::Seconds(2));
  }
  ASSERT_EQ(Call(absl::Milliseconds(1), Verdict::kGood), a);
  ASSERT_EQ(Call(absl::ZeroDuration(), Verdict::kFull), a);
  clock_.Advance(absl::Milliseconds(20));
  EXPECT_EQ(Call(), a) << "an answer ends it";
}

TEST_F(WorkerPoolTest, CallsThatWereRefusedTogetherAreOneRefusal) {
  const WorkerId a = AddReady("a:1");
  std::vector<Place> places;
  for (int i = 0; i < 4; ++i) places.push_back(*pool_.TryTake({}));
  for (const Place& place : places) pool_.End(place, Verdict::kFull);
  clock_.Advance(absl::Milliseconds(20));
  EXPECT_EQ(Call(), a);
}

TEST_F(WorkerPoolTest, AWorkerThatIsThereAnewIsTriedAtOnce) {
  const WorkerId a = AddReady("a:1");
  Break(a);
  pool_.SetConnecting(a);
  EXPECT_EQ(Call(), -1);
  pool_.SetReady(a, "2");
  const Place trial = *pool_.TryTake({});
  EXPECT_TRUE(trial.on_trial);
  EXPECT_EQ(trial.revision, "2");
}

TEST_F(WorkerPoolTest, TellsTheRevisionOfAWorkerThatWorksThoughAllAreFull) {
  const WorkerId a = AddReady("a:1", "old");
  AddReady("b:1", "new");
  Break(a);
  EXPECT_EQ(*pool_.Revision(call_), "new");
  while (pool_.TryTake({}).has_value()) {
  }
  EXPECT_EQ(*pool_.Revision(call_), "new");
}

TEST_F(WorkerPoolTest, AThousandWorkersComeAndGoWithCallsUnderWay) {
  std::vector<std::thread> threads;
  std::atomic<bool> stop = false;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (int made = 0; made < 500; ++made) {
        runtime::CallContext call;
        const absl::StatusOr<Place> place = pool_.Take({}, call);
        if (place.ok()) pool_.End(*place, (made + i) % 7 == 0 ? Verdict::kFull : Verdict::kGood);
      }
    });
  }
  AddReady("always:1");
  std::thread coming([&] {
    for (int i = 0; i < 1000 || !stop; ++i) {
      const WorkerId id = AddReady("w" + std::to_string(i) + ":1");
      if (i % 3 == 0) pool_.SetConnecting(id);
      pool_.Remove(id);
      clock_.Advance(absl::Milliseconds(50));
    }
  });
  for (std::thread& thread : threads) thread.join();
  stop = true;
  coming.join();
  EXPECT_EQ(pool_.Status().size(), 1u);
  EXPECT_EQ(StatusOf("always:1").in_flight_count(), 0);
}

}  // namespace
}  // namespace flair::orchestrator
