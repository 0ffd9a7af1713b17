// SPDX-License-Identifier: GPL-3.0-or-later
// Servers that break one promise each: the check of that promise says so, and no check hangs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <mutex>

#include "tests/contract/servers.h"

namespace flair::testing {
namespace {

using contract::Finding;
using contract::Verdict;
using ::testing::HasSubstr;

const contract::Stage& Stage() { return *contract::FindStage("optimizer"); }

class BadServer : public ::testing::Test {
 protected:
  // A good optimizer for all tests of this process.
  static void SetUpTestSuite() { good_ = new StageProgram(Stage()); }
  static void TearDownTestSuite() {
    delete good_;
    good_ = nullptr;
  }
  static const std::string& Good() { return good_->address(); }

  // How the check of that name comes out with the server at the address.
  static Finding Put(const std::string& name, const std::string& address, absl::Duration patience = absl::Seconds(60)) {
    const std::vector<contract::Check> checks = contract::ChecksOf(Stage());
    const auto check = std::ranges::find(checks, name, &contract::Check::name);
    if (check == checks.end()) {
      ADD_FAILURE() << "no check \"" << name << "\"";
      return {};
    }
    const std::unique_ptr<contract::Target> target = ConnectTo(Stage(), address, patience);
    return target == nullptr ? Finding() : contract::RunCheck(*check, *target);
  }
  // Expects that the check finds the fault, and that what came back is told.
  static void ExpectFound(const std::string& name, Fault fault, const std::string& got) {
    const SpoiltOptimizer server(Good(), std::move(fault));
    const Finding finding = Put(name, server.address());
    EXPECT_EQ(finding.verdict, Verdict::kBroken) << FindingText(finding);
    EXPECT_THAT(finding.got, HasSubstr(got));
    EXPECT_NE(finding.sent, "");
    EXPECT_NE(finding.right, "");
  }
  static std::vector<contract::Result> PutAll(const std::string& address, absl::Duration patience) {
    const std::unique_ptr<contract::Target> target = ConnectTo(Stage(), address, patience);
    if (target == nullptr) return {};
    return contract::RunChecks(contract::ChecksOf(Stage()), *target, [](const contract::Result&) {});
  }
  static long CountOf(const std::vector<contract::Result>& results, Verdict verdict) {
    return std::ranges::count_if(results, [&](const contract::Result& r) { return r.finding.verdict == verdict; });
  }
  static v1::GetWorkerResponse Claiming(v1::Capability capability) {
    v1::GetWorkerResponse worker;
    worker.add_capabilities(capability);
    return worker;
  }
  static v1::Placement& First(v1::SolveResponse& answer) {
    return *answer.mutable_solved_layout()->mutable_placements(0);
  }

 private:
  static inline StageProgram* good_ = nullptr;
};

constexpr char kPlacesAll[] = "Solve places every object once, in a valid layout";

TEST_F(BadServer, AServerThatHandsOnAGoodOneIsGood) {
  const SpoiltOptimizer server(Good(), {});
  EXPECT_EQ(Put(kPlacesAll, server.address()).verdict, Verdict::kKept);
}

TEST_F(BadServer, WhatIsNotClaimedIsSkippedAndSaidSo) {
  const SpoiltOptimizer server(Good(), {});
  const Finding finding = Put("The same request gets the same answer again", server.address());
  EXPECT_EQ(finding.verdict, Verdict::kSkipped);
  EXPECT_THAT(finding.reason, HasSubstr("DETERMINISTIC"));
}

TEST_F(BadServer, AServerThatSaysNothingOfItselfClaimsNothing) {
  const SpoiltOptimizer server(Good(), {.worker = std::nullopt});
  EXPECT_EQ(Put("The server speaks flair.v1", server.address()).verdict, Verdict::kKept);
  EXPECT_EQ(Put("Every placed example comes to its verdict", server.address()).verdict, Verdict::kSkipped);
}

TEST_F(BadServer, NaNIsFound) {
  ExpectFound(kPlacesAll,
              {.spoil_solve = [](auto& answer) { First(answer).set_x_m(std::numeric_limits<double>::quiet_NaN()); }},
              "placements[0].x_m: nan");
}

TEST_F(BadServer, AnObjectLeftOutIsFound) {
  ExpectFound(kPlacesAll,
              {.spoil_solve = [](auto& answer) { answer.mutable_solved_layout()->mutable_placements()->RemoveLast(); }},
              "is not among them");
}

TEST_F(BadServer, DegreesAreFound) {
  ExpectFound(
      "Headings are radians and 0 faces north: a bench fits a straight corridor",
      {.spoil_solve = [](auto& answer) { First(answer).set_theta_rad(First(answer).theta_rad() * 180 / M_PI); }},
      "theta_rad");
}

TEST_F(BadServer, ClockwiseHeadingsAreFound) {
  ExpectFound("Headings turn counter-clockwise: a bench fits a slanting corridor",
              {.spoil_solve = [](auto& answer) { First(answer).set_theta_rad(2 * M_PI - First(answer).theta_rad()); }},
              "outside the room");
}

TEST_F(BadServer, AWrongStatusIsFound) {
  ExpectFound("Solve refuses a width that is not a number",
              {.spoil_code = [](int code) { return code == grpc::INVALID_ARGUMENT ? grpc::UNKNOWN : code; }},
              "UNKNOWN");
}

TEST_F(BadServer, AnErrorThatIsSwallowedIsFound) {
  ExpectFound("Solve refuses two objects of one id", {.spoil_code = [](int) { return grpc::OK; }}, "OK");
}

TEST_F(BadServer, AClaimOfDeterminismThatIsNotTrueIsFound) {
  auto calls = std::make_shared<std::atomic<int>>(0);
  ExpectFound("The same request gets the same answer again",
              {.spoil_solve = [calls](auto& answer) { First(answer).set_x_m(First(answer).x_m() + 1e-9 * ++*calls); },
               .worker = Claiming(v1::CAPABILITY_DETERMINISTIC)},
              "differ");
}

TEST_F(BadServer, AMovedPinIsFound) {
  ExpectFound("Pinned objects stay where they are",
              {.spoil_solve = [](auto& answer) { First(answer).set_x_m(First(answer).x_m() + 1e-6); }},
              "x_m: 2.250001");
}

TEST_F(BadServer, ACatalogueThatRepeatsANameIsFound) {
  ExpectFound("The catalogue is valid: unique names, summaries, parameters",
              {.spoil_catalogue =
                   [](auto& answer) {
                     answer.mutable_catalog()->mutable_types(1)->set_name(answer.catalog().types(0).name());
                   }},
              "types[1].name");
}

TEST_F(BadServer, AnExampleThatDoesNotComeToItsVerdictIsFound) {
  ExpectFound("Every placed example comes to its verdict",
              {.spoil_evaluate =
                   [](auto& answer) {
                     if (answer.edge_outcomes_size() > 0) {
                       answer.mutable_edge_outcomes(0)->set_status(v1::OUTCOME_STATUS_SATISFIED);
                     }
                   },
               .worker = Claiming(v1::CAPABILITY_EVALUATE)},
              "OUTCOME_STATUS_SATISFIED");
}

// Works on one call at a time, whoever waits for it, until it is let go at the end of the test.
TEST_F(BadServer, WorkThatGoesOnForNobodyIsFound) {
  std::promise<void> let_go;
  const std::shared_future<void> gone = let_go.get_future().share();
  std::mutex one_at_a_time;
  Finding finding;
  {
    const SpoiltOptimizer server(Good(), {.on_solve = [&](const v1::SolveRequest& request) {
                                   std::lock_guard lock(one_at_a_time);
                                   if (request.layout_graph().object_list().objects_size() > 2) gone.wait();
                                 }});
    finding = Put("Work whose deadline has passed ends, and the server goes on", server.address(), absl::Seconds(4));
    let_go.set_value();
  }
  EXPECT_EQ(finding.verdict, Verdict::kBroken) << FindingText(finding);
  EXPECT_THAT(finding.got, HasSubstr("DEADLINE_EXCEEDED"));
}

TEST_F(BadServer, AServerOfAnotherVersionIsAskedNothingElse) {
  v1::GetWorkerResponse worker;
  worker.set_program("their-optimizer");
  worker.add_protocols("flair.v2");
  const SpoiltOptimizer server(Good(), {.worker = worker});
  const auto results = PutAll(server.address(), absl::Seconds(60));
  EXPECT_EQ(results[0].finding.verdict, Verdict::kBroken);
  EXPECT_THAT(results[0].finding.got, HasSubstr("their-optimizer speaks flair.v2"));
  EXPECT_EQ(CountOf(results, Verdict::kSkipped), static_cast<long>(results.size()) - 1);
}

TEST_F(BadServer, AServerOfAnotherStageIsAskedNothingElse) {
  const StageProgram language(*contract::FindStage("language"));
  const auto results = PutAll(language.address(), absl::Seconds(60));
  EXPECT_EQ(results[1].finding.verdict, Verdict::kBroken);
  EXPECT_THAT(results[1].finding.right, HasSubstr("port of another stage"));
  EXPECT_EQ(CountOf(results, Verdict::kBroken), 1);
}

TEST_F(BadServer, AServerThatFallsOverIsNotAskedAgain) {
  std::unique_ptr<SpoiltOptimizer> server;
  std::future<void> stopped;
  std::once_flag once;
  server = std::make_unique<SpoiltOptimizer>(
      Good(), Fault{.on_solve = [&](const v1::SolveRequest& request) {
        if (request.layout_graph().object_list().objects_size() > 0) return;
        std::call_once(once, [&] { stopped = std::async(std::launch::async, [&] { server->Stop(); }); });
      }});
  const auto results = PutAll(server->address(), absl::Seconds(5));
  const auto last = std::ranges::find_if(results, [](const contract::Result& result) {
    return result.finding.got.find("since then the server cannot be reached") != std::string::npos;
  });
  ASSERT_NE(last, results.end());
  EXPECT_TRUE(std::all_of(last + 1, results.end(),
                          [](const contract::Result& r) { return r.finding.verdict == Verdict::kSkipped; }));
}

TEST_F(BadServer, GarbageBreaksPromisesAndNothingElse) {
  // What it says of itself is garbage too, and taken for nothing said.
  const AnyServer server(std::string("\xff\xfe garbage"), false);
  const auto results = PutAll(server.address(), absl::Seconds(5));
  EXPECT_EQ(results.size(), contract::ChecksOf(Stage()).size());
  EXPECT_GT(CountOf(results, Verdict::kBroken), 20);
}

TEST_F(BadServer, EmptyAnswersBreakPromisesAndNothingElse) {
  const AnyServer server("", false);
  const auto results = PutAll(server.address(), absl::Seconds(5));
  EXPECT_EQ(results.size(), contract::ChecksOf(Stage()).size());
  EXPECT_GT(CountOf(results, Verdict::kBroken), 20);
}

// A solve that never ends costs every RPC one wait, not every check.
TEST_F(BadServer, AServerThatHangsIsAskedOnce) {
  std::promise<void> let_go;
  const std::shared_future<void> gone = let_go.get_future().share();
  std::vector<contract::Result> results;
  {
    const SpoiltOptimizer server(Good(), {.on_solve = [&](const v1::SolveRequest&) { gone.wait(); }});
    results = PutAll(server.address(), absl::Seconds(1));
    let_go.set_value();
  }
  EXPECT_EQ(results.size(), contract::ChecksOf(Stage()).size());
  const auto places = std::ranges::find(results, kPlacesAll, &contract::Result::name);
  EXPECT_THAT(places->finding.got, HasSubstr("DEADLINE_EXCEEDED"));
  EXPECT_GT(std::ranges::count_if(results,
                                  [](const contract::Result& result) {
                                    return result.finding.got.find("not asked again") != std::string::npos;
                                  }),
            10);
}

TEST_F(BadServer, ASilentServerIsUnreachable) {
  const AnyServer server("", true);
  const auto target = contract::Target::Connect(
      {.address = server.address(), .service = Stage().service, .patience = absl::Seconds(1)});
  EXPECT_EQ(target.status().code(), absl::StatusCode::kUnavailable) << target.status();
}

}  // namespace
}  // namespace flair::testing
