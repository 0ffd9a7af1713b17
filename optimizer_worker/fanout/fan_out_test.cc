// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/fan_out.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::optimizer {
namespace {

using Behaviour =
    std::function<absl::StatusOr<v1::SolveRestartsResponse>(const v1::SolveRestartsRequest&, runtime::Cancellation&)>;

class FakePeer final : public PeerOptimizer {
 public:
  explicit FakePeer(Behaviour behaviour) : behaviour_(std::move(behaviour)) {}
  const std::string& name() const override { return name_; }
  absl::StatusOr<v1::SolveRestartsResponse> SolveRestarts(const v1::SolveRestartsRequest& request,
                                                          runtime::Cancellation& cancellation) override {
    return behaviour_(request, cancellation);
  }

 private:
  std::string name_ = "fake";
  Behaviour behaviour_;
};

// Works as a real one does: through the messages.
absl::StatusOr<v1::SolveRestartsResponse> Answer(const v1::SolveRestartsRequest& request) {
  absl::StatusOr<std::vector<v1::RestartOutcome>> outcomes = SolveStageRestarts(request, NloptSolver());
  if (!outcomes.ok()) return outcomes.status();
  v1::SolveRestartsResponse response;
  for (v1::RestartOutcome& outcome : *outcomes) *response.add_outcomes() = std::move(outcome);
  return response;
}

Behaviour Working(std::atomic<int>& calls) {
  return [&calls](const v1::SolveRestartsRequest& request, runtime::Cancellation&) {
    ++calls;
    return Answer(request);
  };
}

absl::StatusOr<v1::SolveRestartsResponse> Dead(const v1::SolveRestartsRequest&, runtime::Cancellation&) {
  return absl::UnavailableError("connection reset");
}

// Answers only when the call is cancelled: a process that was stopped.
absl::StatusOr<v1::SolveRestartsResponse> Stuck(const v1::SolveRestartsRequest&, runtime::Cancellation& cancellation) {
  std::mutex mutex;
  std::condition_variable cancelled;
  const runtime::OnCancel guard(cancellation, [&] {
    const std::lock_guard lock(mutex);
    cancelled.notify_all();
  });
  std::unique_lock lock(mutex);
  cancelled.wait(lock, [&] { return cancellation.cancelled(); });
  return absl::CancelledError("cancelled");
}

absl::StatusOr<v1::SolveRestartsResponse> Lying(const v1::SolveRestartsRequest& request, runtime::Cancellation&) {
  absl::StatusOr<v1::SolveRestartsResponse> response = Answer(request);
  if (response.ok()) response->mutable_outcomes(0)->clear_placements();
  return response;
}

std::string SolvedWith(std::vector<Behaviour> behaviours, int threads = 2, int64_t seed = 3) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  for (Behaviour& behaviour : behaviours) peers.push_back(std::make_unique<FakePeer>(std::move(behaviour)));
  PeerPool pool(std::move(peers), clock);
  v1::SolveOptions options;
  options.set_seed(seed);
  options.set_max_restart_count(24);
  options.set_thread_count(threads);
  const FanOutRestartRunner runner(pool, options);
  absl::StatusOr<SolveResult> result = SolveLayout(Bedroom(), options, NloptSolver(), nullptr, runner);
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? result->layout.SerializeAsString() : "";
}

TEST(FanOut, AnyNumberOfPeersGivesTheSameBytes) {
  const std::string alone = SolvedWith({}, 1);
  for (int peers : {1, 2, 7}) {
    std::atomic<int> calls = 0;
    std::vector<Behaviour> behaviours(static_cast<size_t>(peers), Working(calls));
    EXPECT_TRUE(SolvedWith(behaviours, 1 + peers % 3) == alone) << peers << " peers";
    EXPECT_GT(calls, 0) << "no peer was asked";
  }
}

TEST(FanOut, ADeadPeerChangesNothing) {
  std::atomic<int> calls = 0;
  EXPECT_TRUE(SolvedWith({Dead, Working(calls), Dead}) == SolvedWith({}));
}

TEST(FanOut, APeerThatDiesInTheMiddleChangesNothing) {
  std::atomic<int> calls = 0;
  const Behaviour dying = [&calls](const v1::SolveRestartsRequest& request,
                                   runtime::Cancellation&) -> absl::StatusOr<v1::SolveRestartsResponse> {
    if (++calls > 3) return absl::UnavailableError("killed");
    return Answer(request);
  };
  EXPECT_TRUE(SolvedWith({dying, dying}) == SolvedWith({}));
}

TEST(FanOut, AStuckPeerHoldsNobodyUp) { EXPECT_TRUE(SolvedWith({Stuck, Stuck}) == SolvedWith({})); }

TEST(FanOut, APeerThatAnswersWronglyIsNotBelieved) { EXPECT_TRUE(SolvedWith({Lying}) == SolvedWith({})); }

TEST(FanOut, SeveralSolvesAtOnceShareThePeersAndGiveTheSameBytes) {
  runtime::FakeClock clock;
  std::atomic<int> now = 0, most = 0;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<FakePeer>([&](const v1::SolveRestartsRequest& request, runtime::Cancellation&) {
    const int in_flight = ++now;
    for (int seen = most; seen < in_flight && !most.compare_exchange_weak(seen, in_flight);) {
    }
    absl::StatusOr<v1::SolveRestartsResponse> response = Answer(request);
    --now;
    return response;
  }));
  PeerPool pool(std::move(peers), clock);
  v1::SolveOptions options;
  options.set_seed(3);
  options.set_max_restart_count(24);
  options.set_thread_count(1);
  std::vector<std::string> layouts(6);
  std::vector<std::thread> threads;
  for (std::string& layout : layouts) {
    threads.emplace_back([&] {
      const FanOutRestartRunner runner(pool, options);
      absl::StatusOr<SolveResult> result = SolveLayout(Bedroom(), options, NloptSolver(), nullptr, runner);
      if (result.ok()) layout = result->layout.SerializeAsString();
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string alone = SolvedWith({}, 1);
  for (const std::string& layout : layouts) EXPECT_TRUE(layout == alone);
  EXPECT_GE(most, 1);
  EXPECT_LE(most, PeerPool::kMostSolves);
}

TEST(FanOut, AFailureSendsThePeerToRest) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  std::atomic<int> calls = 0;
  peers.push_back(std::make_unique<FakePeer>(
      [&calls](const v1::SolveRestartsRequest&, runtime::Cancellation&) -> absl::StatusOr<v1::SolveRestartsResponse> {
        ++calls;
        return absl::UnavailableError("down");
      }));
  PeerPool pool(std::move(peers), clock);
  v1::SolveOptions options;
  options.set_max_restart_count(24);
  options.set_thread_count(1);
  const FanOutRestartRunner runner(pool, options);
  ASSERT_TRUE(SolveLayout(Bedroom(), options, NloptSolver(), nullptr, runner).ok());
  const int asked = calls;
  EXPECT_GE(asked, 1);
  ASSERT_TRUE(SolveLayout(Bedroom(), options, NloptSolver(), nullptr, runner).ok());
  EXPECT_EQ(calls, asked) << "it was asked although it rests";
}

TEST(FanOut, APeerWhoseAnswerDiffersInOneBitIsFoundOutAndNotBelieved) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  // Comes too late, so that its piece has been run here as well.
  peers.push_back(
      std::make_unique<FakePeer>([](const v1::SolveRestartsRequest& request, runtime::Cancellation& cancellation) {
        (void)Stuck(request, cancellation);
        absl::StatusOr<v1::SolveRestartsResponse> response = Answer(request);
        if (!response.ok()) return response;
        for (v1::RestartOutcome& outcome : *response->mutable_outcomes()) {
          outcome.set_cost(std::nextafter(outcome.cost(), -1));
        }
        return response;
      }));
  PeerPool pool(std::move(peers), clock);
  v1::SolveOptions options;
  options.set_seed(3);
  options.set_max_restart_count(24);
  options.set_thread_count(1);
  const FanOutRestartRunner runner(pool, options);
  const absl::StatusOr<SolveResult> result = SolveLayout(Bedroom(), options, NloptSolver(), nullptr, runner);
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_TRUE(result->layout.SerializeAsString() == SolvedWith({}, 1));
  EXPECT_TRUE(pool.Borrow().empty());
}

TEST(FanOut, ACancelledCallerEndsIt) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<FakePeer>(Stuck));
  PeerPool pool(std::move(peers), clock);
  v1::SolveOptions options;
  options.set_max_restart_count(24);
  const FanOutRestartRunner runner(pool, options);
  const absl::StatusOr<SolveResult> result = SolveLayout(
      Bedroom(), options, NloptSolver(), [] { return true; }, runner);
  EXPECT_EQ(result.status().code(), absl::StatusCode::kCancelled) << result.status();
}

class IdlePeer final : public PeerOptimizer {
 public:
  const std::string& name() const override { return name_; }
  absl::StatusOr<v1::SolveRestartsResponse> SolveRestarts(const v1::SolveRestartsRequest&,
                                                          runtime::Cancellation&) override {
    return absl::UnavailableError("idle");
  }

 private:
  std::string name_ = "idle";
};

std::vector<PeerOptimizer*> Available(PeerPool& pool) {
  const std::vector<PeerOptimizer*> peers = pool.Borrow();
  for (const PeerOptimizer* peer : peers) pool.Return(*peer);
  return peers;
}

const absl::Status kWhy = absl::UnavailableError("nobody listens");

TEST(PeerPool, SaysWhyAPeerIsLeftOutAndForHowLong) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  std::vector<std::string> remarks;
  PeerPool pool(std::move(peers), clock, [&](const std::string& remark) { remarks.push_back(remark); });
  const PeerOptimizer& peer = *Available(pool)[0];
  pool.ReportFailure(peer, kWhy);
  pool.ReportSuccess(peer);
  pool.ReportFailure(peer, kWhy);
  pool.ReportFailure(peer, kWhy);
  EXPECT_EQ(remarks,
            (std::vector<std::string>{"peer idle is left out for 1 s: nobody listens; its restarts run elsewhere",
                                      "peer idle is left out for 1 s: nobody listens; its restarts run elsewhere",
                                      "peer idle is left out for 2 s: nobody listens; its restarts run elsewhere"}));
}

TEST(PeerPool, APeerThatFailsRestsLongerEachTimeAndOneSuccessEndsThat) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  PeerPool pool(std::move(peers), clock);
  ASSERT_EQ(Available(pool).size(), 1u);
  const PeerOptimizer& peer = *Available(pool)[0];
  for (int rest_s : {1, 2, 4, 8, 16, 32, 60, 60}) {
    pool.ReportFailure(peer, kWhy);
    clock.Advance(absl::Seconds(rest_s) - absl::Milliseconds(1));
    EXPECT_TRUE(Available(pool).empty()) << rest_s;
    clock.Advance(absl::Milliseconds(1));
    EXPECT_EQ(Available(pool).size(), 1u) << rest_s;
  }
  pool.ReportSuccess(peer);
  pool.ReportFailure(peer, kWhy);
  clock.Advance(absl::Seconds(1));
  EXPECT_EQ(Available(pool).size(), 1u);
}

TEST(PeerPool, OnePeersFailureLeavesTheOthers) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  peers.push_back(std::make_unique<IdlePeer>());
  PeerPool pool(std::move(peers), clock);
  PeerOptimizer* const second = Available(pool)[1];
  pool.ReportFailure(*Available(pool)[0], kWhy);
  ASSERT_EQ(Available(pool).size(), 1u);
  EXPECT_EQ(Available(pool)[0], second);
}

TEST(PeerPool, APeerServesABoundedNumberOfSolvesAndOneThatEndsMakesRoom) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  PeerPool pool(std::move(peers), clock);
  const PeerOptimizer& peer = *Available(pool)[0];
  for (int i = 0; i < PeerPool::kMostSolves; ++i) EXPECT_EQ(pool.Borrow().size(), 1u);
  EXPECT_TRUE(pool.Borrow().empty());
  pool.Return(peer);
  EXPECT_EQ(pool.Borrow().size(), 1u);
}

}  // namespace
}  // namespace flair::optimizer
