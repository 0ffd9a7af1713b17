// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "orchestrator/workers/worker_pool.h"

namespace flair::orchestrator {
namespace {

constexpr absl::Duration kRecovery = absl::Seconds(5);

// Made to fail as often as it takes, at time 0.
Circuit Broken() {
  Circuit circuit(3, kRecovery);
  for (int i = 0; i < 3; ++i) circuit.Fail(circuit.Begin(), absl::ZeroDuration());
  return circuit;
}

TEST(Circuit, OpensAfterFailuresInARow) {
  Circuit circuit(3, kRecovery);
  EXPECT_FALSE(circuit.Fail(circuit.Begin(), absl::ZeroDuration()));
  EXPECT_FALSE(circuit.Fail(circuit.Begin(), absl::ZeroDuration()));
  EXPECT_TRUE(circuit.Allows(absl::ZeroDuration()));
  EXPECT_TRUE(circuit.Fail(circuit.Begin(), absl::ZeroDuration()));
  EXPECT_TRUE(circuit.open());
  EXPECT_FALSE(circuit.Allows(kRecovery - absl::Nanoseconds(1)));
}

TEST(Circuit, ASuccessBetweenFailuresKeepsItClosed) {
  Circuit circuit(3, kRecovery);
  for (int i = 0; i < 10; ++i) {
    circuit.Fail(circuit.Begin(), absl::ZeroDuration());
    circuit.Fail(circuit.Begin(), absl::ZeroDuration());
    circuit.Begin();
    circuit.Succeed();
  }
  EXPECT_FALSE(circuit.open());
}

TEST(Circuit, AllowsOneTrialWhenItsTimeHasCome) {
  Circuit circuit = Broken();
  ASSERT_TRUE(circuit.Allows(kRecovery));
  EXPECT_TRUE(circuit.Begin());
  EXPECT_FALSE(circuit.Allows(kRecovery));
}

TEST(Circuit, ClosesWhenTheTrialSucceeds) {
  Circuit circuit = Broken();
  circuit.Begin();
  circuit.Succeed();
  EXPECT_FALSE(circuit.open());
  EXPECT_TRUE(circuit.Allows(kRecovery));
  EXPECT_FALSE(circuit.Begin()) << "calls are on trial no more";
}

TEST(Circuit, OpensAnewWhenTheTrialFails) {
  Circuit circuit = Broken();
  EXPECT_TRUE(circuit.Fail(circuit.Begin(), kRecovery));
  EXPECT_FALSE(circuit.Allows(2 * kRecovery - absl::Nanoseconds(1)));
  EXPECT_TRUE(circuit.Allows(2 * kRecovery));
}

TEST(Circuit, AnotherTrialFollowsOneThatWasGivenUp) {
  Circuit circuit = Broken();
  circuit.GiveUp(circuit.Begin());
  EXPECT_TRUE(circuit.open());
  EXPECT_TRUE(circuit.Allows(kRecovery));
}

TEST(Circuit, CallsFromBeforeItOpenedDoNotProlongIt) {
  Circuit circuit = Broken();
  EXPECT_FALSE(circuit.Fail(false, absl::Seconds(4)));
  EXPECT_TRUE(circuit.Allows(kRecovery));
}

TEST(Circuit, AWorkerThatIsThereAnewIsTriedAtOnce) {
  Circuit circuit = Broken();
  circuit.AllowTrial();
  EXPECT_TRUE(circuit.Allows(absl::ZeroDuration()));
  EXPECT_TRUE(circuit.Begin());
}

TEST(Circuit, OneFailureMayCountForMany) {
  Circuit circuit(3, kRecovery);
  EXPECT_TRUE(circuit.Fail(circuit.Begin(), absl::ZeroDuration(), 3));
  EXPECT_TRUE(circuit.open());
}

}  // namespace
}  // namespace flair::orchestrator
