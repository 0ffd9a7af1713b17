// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/peer_pool.h"

#include <gtest/gtest.h>

#include "worker_runtime/testing/fakes.h"

namespace flair::optimizer {
namespace {

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

const absl::Status kWhy = absl::UnavailableError("nobody listens");

TEST(PeerPool, SaysWhyAPeerIsLeftOutAndForHowLong) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  std::vector<std::string> remarks;
  PeerPool pool(std::move(peers), clock, [&](const std::string& remark) { remarks.push_back(remark); });
  const PeerOptimizer& peer = *pool.Available()[0];
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
  ASSERT_EQ(pool.Available().size(), 1u);
  const PeerOptimizer& peer = *pool.Available()[0];
  for (int rest_s : {1, 2, 4, 8, 16, 32, 60, 60}) {
    pool.ReportFailure(peer, kWhy);
    clock.Advance(absl::Seconds(rest_s) - absl::Milliseconds(1));
    EXPECT_TRUE(pool.Available().empty()) << rest_s;
    clock.Advance(absl::Milliseconds(1));
    EXPECT_EQ(pool.Available().size(), 1u) << rest_s;
  }
  pool.ReportSuccess(peer);
  pool.ReportFailure(peer, kWhy);
  clock.Advance(absl::Seconds(1));
  EXPECT_EQ(pool.Available().size(), 1u);
}

TEST(PeerPool, OnePeersFailureLeavesTheOthers) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  peers.push_back(std::make_unique<IdlePeer>());
  PeerPool pool(std::move(peers), clock);
  PeerOptimizer* const second = pool.Available()[1];
  pool.ReportFailure(*pool.Available()[0], kWhy);
  ASSERT_EQ(pool.Available().size(), 1u);
  EXPECT_EQ(pool.Available()[0], second);
}

TEST(PeerPool, APeerHasABoundedNumberOfCallsAndOneThatEndsMakesRoom) {
  runtime::FakeClock clock;
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  peers.push_back(std::make_unique<IdlePeer>());
  peers.push_back(std::make_unique<IdlePeer>());
  PeerPool pool(std::move(peers), clock);
  const PeerOptimizer &busy = *pool.Available()[0], &free = *pool.Available()[1];
  const auto at_once = [] { return true; };
  std::vector<std::optional<PeerPool::Slot>> slots;
  for (int i = 0; i < PeerPool::kMostCalls; ++i) {
    slots.push_back(pool.WaitForSlot(busy, at_once));
    EXPECT_TRUE(slots.back().has_value());
  }
  EXPECT_FALSE(pool.WaitForSlot(busy, at_once).has_value());
  EXPECT_TRUE(pool.WaitForSlot(free, at_once).has_value());
  slots.back().reset();
  EXPECT_TRUE(pool.WaitForSlot(busy, at_once).has_value());
}

}  // namespace
}  // namespace flair::optimizer
