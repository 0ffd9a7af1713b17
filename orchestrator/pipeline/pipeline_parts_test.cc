// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/testing/fake_stages.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// One of revision `answering` answers, whichever is thought to.
class OptimizersOfRevisions : public FakeStages {
 public:
  std::optional<std::string> answering;

  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest& request,
                                                                      Call& call) override {
    auto response = FakeStages::ListConstraintTypes(request, call);
    if (!response.ok()) return response;
    response->mutable_catalog()->set_library("of " + answering.value_or("nobody"));
    call.SetAnswerer({answering});
    return response;
  }
  std::string Ask(CatalogCache& cache, std::optional<std::string> revision) {
    set_revision(std::move(revision));
    StageCall call;
    const auto catalog = cache.Get(*this, call);
    return catalog.ok() ? (*catalog)->catalog.library() : catalog.status().ToString();
  }
  int asked() const { return calls("ListConstraintTypes"); }
};

TEST(CatalogCache, AsksOptimizersOfOneRevisionOnce) {
  OptimizersOfRevisions optimizers;
  CatalogCache cache;
  optimizers.answering = "1";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(optimizers.Ask(cache, "1"), "of 1");
  EXPECT_EQ(optimizers.asked(), 1);
  optimizers.answering = "2";
  EXPECT_EQ(optimizers.Ask(cache, "2"), "of 2");
  EXPECT_EQ(optimizers.Ask(cache, "1"), "of 1");
  EXPECT_EQ(optimizers.asked(), 2);
}

TEST(CatalogCache, KeepsWhatIsAnsweredAsThatOfWhoAnswered) {
  OptimizersOfRevisions optimizers;
  CatalogCache cache;
  optimizers.answering = "2";
  EXPECT_EQ(optimizers.Ask(cache, "1"), "of 2");
  optimizers.answering = "1";
  EXPECT_EQ(optimizers.Ask(cache, "1"), "of 1");
  EXPECT_EQ(optimizers.Ask(cache, "2"), "of 2");
  EXPECT_EQ(optimizers.asked(), 2);
}

TEST(CatalogCache, AsksThoseThatDoNotSayWhichTheyAreEachTime) {
  OptimizersOfRevisions optimizers;
  CatalogCache cache;
  for (int i = 0; i < 2; ++i) EXPECT_EQ(optimizers.Ask(cache, std::nullopt), "of nobody");
  EXPECT_EQ(optimizers.asked(), 2);
}

TEST(BackoffPolicy, GrowsToItsLimitWithinTheSpread) {
  const BackoffPolicy policy;
  const absl::Status full = absl::ResourceExhaustedError("the queue is full");
  for (int attempt = 0; attempt < 100; ++attempt) {
    const absl::Duration most = std::min(absl::Milliseconds(100) * (1 << std::min(attempt, 10)), absl::Seconds(2));
    const absl::Duration delay = *policy.DelayAfter(full, attempt, "j1");
    EXPECT_LE(delay, most);
    EXPECT_GE(delay, most / 2);
  }
}

TEST(BackoffPolicy, SpreadsCallersThatFailedTogether) {
  const BackoffPolicy policy;
  const absl::Status down = absl::UnavailableError("down");
  EXPECT_NE(policy.DelayAfter(down, 0, "j1"), policy.DelayAfter(down, 0, "j2"));
}

TEST(BackoffPolicy, EndsWithTheLastAttempt) {
  const BackoffPolicy policy{.unavailable_attempt_limit = 3};
  const absl::Status down = absl::UnavailableError("down");
  EXPECT_TRUE(policy.DelayAfter(down, 1, "j1").has_value());
  EXPECT_FALSE(policy.DelayAfter(down, 2, "j1").has_value());
}

TEST(OfStore, AStoreThatIsAwayIsWaitedFor) {
  const absl::Status away = OfStore(absl::UnavailableError("the queue does not answer"));
  EXPECT_TRUE(IsOutage(away));
  EXPECT_EQ(KindOfFailure(away, "brief"), v1::FAILURE_KIND_STORE);
  EXPECT_FALSE(IsOutage(OfStore(absl::ResourceExhaustedError("the disk is full"))));
  EXPECT_FALSE(IsOutage(OfStore(absl::OkStatus())));
}

TEST(WaitUnlessCancelled, ReturnsAtOnceWhenCancelled) {
  runtime::CallContext call;
  call.cancellation().Cancel();
  WaitUnlessCancelled(absl::Hours(1), call);
}

// Remembers what is stored by its stages, a write "brief room".
class RememberingLease final : public Lease {
 public:
  RememberingLease() : Lease({}) {}
  absl::Status Announce(std::span<const StageRecord>) override { return absl::OkStatus(); }
  absl::Status RecordAll(std::span<const StageRecord> records) override {
    if (!answer.ok() || records.empty()) return answer;
    std::string write;
    for (const StageRecord& record : records) write += (write.empty() ? "" : " ") + record.event.stage();
    writes.push_back(write);
    return absl::OkStatus();
  }
  absl::Status End(const JobEnd&) override { return absl::OkStatus(); }
  absl::Status Return(absl::Duration, const std::string&) override { return absl::OkStatus(); }
  runtime::Cancellation& cancellation() override { return cancellation_; }
  bool cancel_requested() override { return false; }
  bool lost() override { return false; }

  std::vector<std::string> writes;
  absl::Status answer;

 private:
  runtime::Cancellation cancellation_;
};

// Remembers artifacts among the lease's writes: "+a+b".
class RememberingStore final : public ArtifactStore {
 public:
  explicit RememberingStore(RememberingLease& lease) : lease_(lease) {}
  absl::Status PutAll(std::span<const SealedArtifact> artifacts) override {
    std::string write;
    for (const SealedArtifact& artifact : artifacts) write += "+" + artifact.ref.id();
    if (!write.empty()) lease_.writes.push_back(write);
    return answer;
  }
  absl::StatusOr<v1::Artifact> Get(const std::string&) override { return absl::NotFoundError(""); }
  absl::Status Flush(std::span<const v1::ArtifactRef>) override { return absl::OkStatus(); }
  absl::StatusOr<int64_t> Mark() override { return 0; }
  absl::StatusOr<int64_t> Delete(std::span<const std::string>, int64_t) override { return 0; }

  absl::Status answer;

 private:
  RememberingLease& lease_;
};

SealedArtifact Named(const std::string& id) {
  SealedArtifact artifact;
  artifact.ref.set_id(id);
  return artifact;
}

StageRecord Step(const std::string& stage, int took_ms) {
  StageRecord record;
  record.event.set_stage(stage);
  record.event.mutable_duration()->set_nanos(took_ms * 1'000'000);
  return record;
}

constexpr StepLog::Urgency kMayWait = StepLog::Urgency::kMayWait;
constexpr StepLog::Urgency kAtOnce = StepLog::Urgency::kAtOnce;

TEST(StepLog, ALongStepIsStoredAtOnceWithTheShortOnesBeforeIt) {
  RememberingLease lease;
  RememberingStore artifacts(lease);
  StepLog steps(lease, artifacts);
  EXPECT_TRUE(steps.Add(Step("brief", 0), {}, kMayWait).ok());
  EXPECT_TRUE(steps.Add(Step("room", 3), {}, kMayWait).ok());
  EXPECT_THAT(lease.writes, IsEmpty());
  EXPECT_TRUE(steps.Add(Step("zones", 900), {}, kMayWait).ok());
  EXPECT_TRUE(steps.Add(Step("objects", 900), {}, kMayWait).ok());
  EXPECT_THAT(lease.writes, ElementsAre("brief room zones", "objects"));
}

TEST(StepLog, ManyShortStepsAreWorthAWriteTogether) {
  RememberingLease lease;
  RememberingStore artifacts(lease);
  StepLog steps(lease, artifacts);
  int added = 0;
  for (; lease.writes.empty() && added < 100; ++added) EXPECT_TRUE(steps.Add(Step("s", 20), {}, kMayWait).ok());
  // Of 500 ms at most a step's worth more.
  EXPECT_EQ(added, 26);
  EXPECT_TRUE(steps.Add(Step("s", 20), {}, kMayWait).ok());
  EXPECT_EQ(lease.writes.size(), 1u);
}

TEST(StepLog, WhatMayNotWaitDoesNot) {
  RememberingLease lease;
  RememberingStore artifacts(lease);
  StepLog steps(lease, artifacts);
  EXPECT_TRUE(steps.Add(Step("brief", 0), {}, kMayWait).ok());
  EXPECT_TRUE(steps.Add(Step("room", 0), {}, kAtOnce).ok());
  EXPECT_THAT(lease.writes, ElementsAre("brief room"));
}

TEST(StepLog, WhatIsKeptBackIsStoredOrGivenAwayOnce) {
  RememberingLease lease;
  RememberingStore artifacts(lease);
  StepLog steps(lease, artifacts);
  EXPECT_TRUE(steps.Add(Step("brief", 0), {}, kMayWait).ok());
  EXPECT_TRUE(steps.Store().ok());
  EXPECT_TRUE(steps.Store().ok());
  EXPECT_THAT(lease.writes, ElementsAre("brief"));
  EXPECT_TRUE(steps.Add(Step("room", 0), {}, kMayWait).ok());
  EXPECT_EQ(steps.TakeLast()->size(), 1u);
  EXPECT_THAT(*steps.TakeLast(), IsEmpty());
  EXPECT_TRUE(steps.Store().ok());
  EXPECT_THAT(lease.writes, ElementsAre("brief"));
}

TEST(StepLog, ArtifactsAreThereBeforeTheyAreRecorded) {
  RememberingLease lease;
  RememberingStore artifacts(lease);
  StepLog steps(lease, artifacts);
  EXPECT_TRUE(steps.Add(Step("brief", 0), Named("a"), kMayWait).ok());
  EXPECT_TRUE(steps.Add(Step("room", 0), Named("b"), kAtOnce).ok());
  EXPECT_TRUE(steps.Add(Step("zones", 0), Named("c"), kMayWait).ok());
  EXPECT_THAT(lease.writes, ElementsAre("+a+b", "brief room"));
  EXPECT_EQ(steps.TakeLast()->size(), 1u);
  EXPECT_THAT(lease.writes, ElementsAre("+a+b", "brief room", "+c"));
}

TEST(StepLog, NothingIsRecordedWhoseArtifactIsNotThere) {
  RememberingLease lease;
  RememberingStore artifacts(lease);
  artifacts.answer = absl::ResourceExhaustedError("the disk is full");
  StepLog steps(lease, artifacts);
  EXPECT_TRUE(absl::IsResourceExhausted(steps.Add(Step("brief", 0), Named("a"), kAtOnce)));
  EXPECT_TRUE(steps.Add(Step("brief", 0), Named("a"), kMayWait).ok());
  EXPECT_TRUE(absl::IsResourceExhausted(steps.TakeLast().status()));
  EXPECT_THAT(lease.writes, ElementsAre("+a", "+a"));
}

TEST(StepLog, SaysWhatKeptItFromStoring) {
  RememberingLease lease;
  lease.answer = absl::AbortedError("another run has it");
  RememberingStore artifacts(lease);
  StepLog steps(lease, artifacts);
  EXPECT_TRUE(steps.Add(Step("brief", 0), {}, kMayWait).ok());
  EXPECT_TRUE(absl::IsAborted(steps.Add(Step("solve", 900), {}, kMayWait)));
  EXPECT_THAT(*steps.TakeLast(), IsEmpty());
}

}  // namespace
}  // namespace flair::orchestrator
