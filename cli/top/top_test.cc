// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "absl/strings/str_join.h"
#include "cli/output/text.h"
#include "cli/top/cluster_state.h"
#include "cli/top/terminal.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

const absl::Time kStart = absl::FromUnixSeconds(1779371100);

google::protobuf::Timestamp At(double seconds) {
  google::protobuf::Timestamp time;
  time.set_seconds(absl::ToUnixSeconds(kStart + absl::Seconds(seconds)));
  return time;
}

v1::OrchestratorStatus Orchestrator(const std::string& id, double reported_seconds, int64_t succeeded) {
  v1::OrchestratorStatus status;
  status.set_id(id);
  *status.mutable_report_time() = At(reported_seconds);
  status.set_running_count(3);
  status.set_running_limit(4);
  status.set_succeeded_count(succeeded);
  return status;
}

void AddWorker(v1::OrchestratorStatus& status, const std::string& stage, const std::string& address,
               v1::WorkerState state, int64_t calls, int milliseconds) {
  v1::WorkerStatus& worker = *status.add_workers();
  worker.set_stage(stage);
  worker.set_address(address);
  worker.set_state(state);
  worker.set_in_flight_count(2);
  worker.set_call_count(calls);
  worker.mutable_call_duration()->set_nanos(milliseconds * 1000000);
}

v1::Batch Batch(int64_t ended) {
  v1::Batch batch;
  batch.set_id("20260521T134501123456-3fa2c1");
  batch.set_label("rooms.jsonl");
  batch.set_state(v1::BATCH_STATE_ACTIVE);
  batch.set_job_count(1000);
  batch.set_open_count(static_cast<int>(1000 - ended));
  batch.set_succeeded_count(static_cast<int>(ended - 2));
  batch.set_failed_count(2);
  return batch;
}

// Two orchestrators of one queue, ten seconds apart.
ClusterState BusyCluster() {
  ClusterState state;
  for (const int seconds : {0, 10}) {
    ClusterLook look{kStart + absl::Seconds(seconds), {}, {Batch(100 + 10 * seconds)}};
    look.cluster.set_queued_count(1234);
    v1::OrchestratorStatus& first = *look.cluster.add_orchestrators();
    first = Orchestrator("host-a-17-00ff", seconds, 5000 + 6 * seconds);
    AddWorker(first, "renderer", "10.0.0.4:7000", v1::WORKER_STATE_READY, 100, 250);
    AddWorker(first, "optimizer", "10.0.0.2:7000", v1::WORKER_STATE_READY, 100 + 3 * seconds, 100);
    AddWorker(first, "optimizer", "10.0.0.3:7000", v1::WORKER_STATE_BROKEN, 7, 1500);
    v1::OrchestratorStatus& second = *look.cluster.add_orchestrators();
    second = Orchestrator("host-b-18-00aa", seconds - 3, 50 + 4 * seconds);
    AddWorker(second, "optimizer", "10.0.0.2:7000", v1::WORKER_STATE_READY, 300, 200);
    state.See(look);
  }
  return state;
}

TEST(RateMeter, KnowsNothingOfOneLook) {
  RateMeter meter(absl::Seconds(10));
  meter.Add("a", kStart, 5);
  meter.Add("a", kStart, 6);
  EXPECT_EQ(meter.PerSecond("a"), std::nullopt);
  EXPECT_EQ(meter.PerSecond("b"), std::nullopt);
}

TEST(RateMeter, ForgetsWhatIsOlderThanItsWindow) {
  RateMeter meter(absl::Seconds(10));
  for (int i = 0; i <= 20; ++i) meter.Add("a", kStart + absl::Seconds(i), i < 10 ? 100 * i : 1000);
  EXPECT_EQ(meter.PerSecond("a"), 0);
}

TEST(RateMeter, BeginsAnewWhenACountFalls) {
  RateMeter meter(absl::Seconds(10));
  meter.Add("a", kStart, 1000);
  meter.Add("a", kStart + absl::Seconds(1), 0);
  EXPECT_EQ(meter.PerSecond("a"), std::nullopt);
  meter.Add("a", kStart + absl::Seconds(2), 3);
  EXPECT_EQ(meter.PerSecond("a"), 3);
}

TEST(ClusterState, AddsUpOrchestratorsByWhenTheyReported) {
  const nlohmann::ordered_json state = BusyCluster().json();
  EXPECT_EQ(state["totals"]["queued_count"], 1234);
  EXPECT_EQ(state["totals"]["running_count"], 6);
  EXPECT_EQ(state["totals"]["running_limit"], 8);
  EXPECT_EQ(state["totals"]["succeeded_count"], 5060 + 90);
  EXPECT_DOUBLE_EQ(state["totals"]["jobs_per_second"], 10);
  EXPECT_EQ(state["orchestrators"][1]["seen_s"], 3);
}

TEST(ClusterState, SeesAWorkerAsAllOrchestratorsTogetherDo) {
  const nlohmann::ordered_json workers = BusyCluster().json()["workers"];
  ASSERT_THAT(workers, SizeIs(3));
  EXPECT_EQ(workers[0]["address"], "10.0.0.3:7000") << "the one in trouble is first of its stage";
  const nlohmann::ordered_json& shared = workers[1];
  EXPECT_EQ(shared["address"], "10.0.0.2:7000");
  EXPECT_EQ(shared["in_flight_count"], 4);
  EXPECT_EQ(shared["call_count"], 430);
  EXPECT_NEAR(shared["call_duration_s"], (130 * 0.1 + 300 * 0.2) / 430, 1e-12);
  EXPECT_DOUBLE_EQ(shared["calls_per_second"], 3);
  EXPECT_EQ(workers[2]["stage"], "renderer");
}

TEST(ClusterState, SaysWhenABatchWillHaveEnded) {
  EXPECT_EQ(BusyCluster().json()["batches"][0]["remaining_s"], 80);
  for (const bool open : {true, false}) {
    ClusterState state;
    for (const int seconds : {0, 10}) {
      v1::Batch batch = Batch(100 + seconds);
      batch.set_open(open);
      if (!open) batch.set_state(v1::BATCH_STATE_PAUSED);
      state.See({kStart + absl::Seconds(seconds), {}, {batch}});
    }
    EXPECT_TRUE(state.json()["batches"][0]["remaining_s"].is_null());
  }
}

TEST(TopText, FitsATerminalOf80By24) {
  EXPECT_THAT(TopText(BusyCluster(), "127.0.0.1:50050", "", {.width = 80, .height = 23}),
              ElementsAre(AllOf(HasSubstr("flair top  127.0.0.1:50050"), SizeIs(80)),
                          "1,234 waiting  6/8 running  10 jobs/s  5,150 done  0 failed  0 retried", "",
                          "BATCH                                        ENDED  FAILED  JOBS/S",
                          "rooms.jsonl         ██░░░░░░░░  20%      200/1,000       2      10     ETA 1m20s", "",
                          "ORCHESTRATOR                    RUNNING       DONE  FAILED RETRIED JOBS/S   SEEN",
                          "host-a-17-00ff                      3/4      5,060       0       0    6.0    now",
                          "host-b-18-00aa                      3/4         90       0       0    4.0    3 s", "",
                          "WORKER      ADDRESS           STATE    BUSY      CALLS  FAILED  LATENCY  CALLS/S",
                          "optimizer   10.0.0.3:7000     broken      2          7       0    1.5 s      0.0",
                          "optimizer   10.0.0.2:7000     ready       4        430       0   170 ms      3.0",
                          "renderer    10.0.0.4:7000     ready       2        100       0   250 ms      0.0"));
}

TEST(TopText, SaysWhatIsHiddenWhereRoomIsScarce) {
  ClusterState state;
  ClusterLook look{kStart, {}, {}};
  v1::OrchestratorStatus& status = *look.cluster.add_orchestrators();
  status = Orchestrator("host", 0, 0);
  for (int i = 0; i < 40; ++i) {
    AddWorker(status, "optimizer", "10.0.0." + std::to_string(i) + ":1", v1::WORKER_STATE_READY, 1, 1);
  }
  state.See(look);
  for (const int height : {1, 5, 10, 24}) {
    const std::vector<std::string> lines = TopText(state, "x", "", {.width = 60, .height = height});
    EXPECT_LE(lines.size(), static_cast<size_t>(std::max(height, 6)));
    for (const std::string& line : lines) EXPECT_LE(ColumnsOf(line), 60u) << line;
  }
  EXPECT_THAT(TopText(state, "x", "", {.width = 60, .height = 24}).back(), HasSubstr("… and 24 more"));
}

TEST(TopText, WhatStrangersWroteDoesNotSteerTheTerminal) {
  ClusterState state;
  v1::Batch batch = Batch(10);
  batch.set_label("\x1b[2J\x1b]0;owned\x07\nnew line");
  ClusterLook look{kStart, {}, {batch}};
  AddWorker(*look.cluster.add_orchestrators(), "\x1b[31mred", "a\r\nb", v1::WORKER_STATE_READY, 1, 1);
  state.See(look);
  const std::vector<std::string> lines = TopText(state, "x", "\x1b[5mtrouble", {.width = 80});
  EXPECT_THAT(lines, Each(AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\n")), Not(HasSubstr("\r")))));
}

TEST(TopText, ShowsTroubleAndColours) {
  const std::string text =
      absl::StrJoin(TopText(BusyCluster(), "x", "No answer for 4 s", {.width = 80, .color = true}), "\n");
  EXPECT_THAT(text, AllOf(HasSubstr("\x1b[31mNo answer for 4 s\x1b[0m"), HasSubstr("\x1b[31mbroken\x1b[0m")));
}

TEST(TopText, OfAStoreWithoutOrchestratorsTellsItsBatchesAndHowToSeeACluster) {
  ClusterState state;
  for (const int seconds : {0, 10}) {
    v1::Batch batch = Batch(100 + 10 * seconds);
    batch.set_running_count(3);
    ClusterLook look{kStart + absl::Seconds(seconds), {}, {batch}};
    look.cluster.set_queued_count(797);
    state.See(look);
  }
  const std::vector<std::string> lines = TopText(state, "the local store", "", {.width = 80});
  ASSERT_THAT(lines, SizeIs(7));
  EXPECT_EQ(lines[1], "797 waiting  3 running  10 jobs/s  198 done  2 failed  0 retried");
  EXPECT_EQ(lines[6], "The store of this machine alone. A cluster: flair top --orchestrator HOST:PORT");
}

TEST(TopText, AnEmptyStoreIsNoProblem) {
  ClusterState state;
  state.See({kStart, {}, {}});
  EXPECT_THAT(TopText(state, "x", "", {.width = 80}),
              ElementsAre(HasSubstr("flair top  x"), "0 waiting  0 running  - jobs/s  0 done  0 failed  0 retried", "",
                          "No batch is open.",
                          "The store of this machine alone. A cluster: flair top --orchestrator HOST:PORT"));
}

TEST(StyledLine, CutsByCharactersNotBytes) {
  EXPECT_EQ(StyledLine(5, false).Add("zwölfäü").text(), "zwölf");
  EXPECT_EQ(StyledLine(20, false).Left("größer", 4).Add("|").text(), "grö…|");
  EXPECT_EQ(StyledLine(20, false).Right("ä", 3).Add("|").text(), "  ä|");
}

TEST(ShortDuration, HasTwoUnitsAtMost) {
  EXPECT_EQ(ShortDuration(absl::Seconds(-3)), "0 s");
  EXPECT_EQ(ShortDuration(absl::Seconds(59)), "59 s");
  EXPECT_EQ(ShortDuration(absl::Seconds(3599)), "59m59s");
  EXPECT_EQ(ShortDuration(absl::Seconds(7500)), "2h05m");
  EXPECT_EQ(ShortDuration(absl::Hours(76)), "3d04h");
}

TEST(Grouped, SetsCommas) {
  EXPECT_EQ(Grouped(0), "0");
  EXPECT_EQ(Grouped(-123456), "-123,456");
  EXPECT_EQ(Grouped(1234567), "1,234,567");
}

TEST(TopJson, IsOneLineWithAllOfIt) {
  const std::string text = TopJson(BusyCluster());
  EXPECT_THAT(text, Not(HasSubstr("\n")));
  const nlohmann::json json = nlohmann::json::parse(text);
  EXPECT_EQ(json["totals"]["queued_count"], 1234);
  EXPECT_EQ(json["totals"]["jobs_per_second"], 10);
  EXPECT_EQ(json["batches"][0]["label"], "rooms.jsonl");
  EXPECT_EQ(json["batches"][0]["remaining_s"], 80);
  EXPECT_EQ(json["orchestrators"][1]["id"], "host-b-18-00aa");
  EXPECT_EQ(json["workers"][0]["state"], "broken");
}

}  // namespace
}  // namespace flair::cli
