// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "room/validation/validate.h"
#include "tests/contract/contract.h"

namespace flair::testing {
namespace {

using Service = v1::OptimizerService::StubInterface;
using ::testing::HasSubstr;

class OptimizerContract : public ::testing::Test {
 protected:
  // The bedroom without sentences: any optimizer can solve it, whatever its library.
  static v1::SolveRequest Request() {
    v1::SolveRequest request;
    request.set_request_id("r1");
    *request.mutable_layout_graph() = BedroomGraph();
    request.mutable_options()->set_seed(5);
    return request;
  }

  ServerUnderTest server_{"optimizer"};
  std::unique_ptr<v1::OptimizerService::Stub> stub_ = v1::OptimizerService::NewStub(server_.channel());
};

TEST_F(OptimizerContract, PublishesACatalogueThatValidates) {
  const auto answer = Ask(*stub_, &Service::ListConstraintTypes, v1::ListConstraintTypesRequest());
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(Validate(answer->catalog()).ok()) << Validate(answer->catalog());
}

TEST_F(OptimizerContract, PlacesEveryObject) {
  const auto answer = Ask(*stub_, &Service::Solve, Request());
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(Validate(answer->solved_layout()).ok()) << Validate(answer->solved_layout());
  EXPECT_EQ(answer->solved_layout().placements_size(), 2);
  EXPECT_EQ(answer->solved_layout().edge_outcomes_size(), answer->solved_layout().graph().edges_size());
}

TEST_F(OptimizerContract, ThreadsAndRepeatsDoNotChangeTheAnswer) {
  v1::SolveRequest request = Request();
  request.mutable_options()->set_thread_count(1);
  const auto one = Ask(*stub_, &Service::Solve, request);
  request.mutable_options()->set_thread_count(4);
  request.set_request_id("r2");
  const auto four = Ask(*stub_, &Service::Solve, request);
  ASSERT_TRUE(one.ok() && four.ok());
  EXPECT_EQ(one->solved_layout().SerializeAsString(), four->solved_layout().SerializeAsString());
}

TEST_F(OptimizerContract, EvaluatesGivenPlacements) {
  v1::EvaluateRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  v1::Placement& bed = *request.add_placements();
  bed.set_object_id("bed");
  bed.set_x_m(2);
  bed.set_y_m(0.5);
  const auto answer = Ask(*stub_, &Service::Evaluate, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_NEAR(answer->metrics().oob_percent(), 100 * 1.6 * 0.5 / 20, 1e-6);
}

TEST_F(OptimizerContract, SolvesAgainAfterAnEditAndSaysWhatMoved) {
  const auto solved = Ask(*stub_, &Service::Solve, Request());
  ASSERT_TRUE(solved.ok()) << solved.status();
  v1::ResolveRequest request;
  request.set_request_id("r3");
  *request.mutable_solved_layout() = solved->solved_layout();
  v1::Placement& target = *request.add_edits()->mutable_move_object();
  target = solved->solved_layout().placements(0);
  target.set_x_m(2);
  target.set_y_m(2);
  const auto answer = Ask(*stub_, &Service::Resolve, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(Validate(answer->solved_layout()).ok()) << Validate(answer->solved_layout());
  EXPECT_EQ(answer->solved_layout().placements(0).x_m(), 2);
  EXPECT_EQ(answer->solved_layout().graph().pinned_placements_size(), 1);
  ASSERT_GE(answer->moved_object_ids_size(), 1);
  EXPECT_EQ(answer->moved_object_ids(0), target.object_id());
  const bool other_moved = answer->moved_object_ids_size() > 1;
  EXPECT_EQ(answer->solved_layout().placements(1).SerializeAsString() ==
                solved->solved_layout().placements(1).SerializeAsString(),
            !other_moved);
}

TEST_F(OptimizerContract, ABadEditIsInvalidArgumentAndNamesTheEdit) {
  const auto solved = Ask(*stub_, &Service::Solve, Request());
  ASSERT_TRUE(solved.ok()) << solved.status();
  v1::ResolveRequest request;
  *request.mutable_solved_layout() = solved->solved_layout();
  request.add_edits()->set_pin_object_id("ghost");
  const auto answer = Ask(*stub_, &Service::Resolve, request);
  EXPECT_EQ(answer.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(answer.status().message()), HasSubstr("edits[0]"));
}

TEST_F(OptimizerContract, PinnedObjectsStayWhereTheyAre) {
  v1::SolveRequest request = Request();
  v1::Placement& pin = *request.mutable_layout_graph()->add_pinned_placements();
  pin.set_object_id(request.layout_graph().object_list().objects(0).id());
  pin.set_x_m(2.25);
  pin.set_y_m(2.5);
  pin.set_theta_rad(0.75);
  const auto answer = Ask(*stub_, &Service::Solve, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  const v1::Placement& placed = answer->solved_layout().placements(0);
  EXPECT_EQ(placed.x_m(), 2.25);
  EXPECT_EQ(placed.y_m(), 2.5);
  EXPECT_EQ(placed.theta_rad(), 0.75);
}

TEST_F(OptimizerContract, ABadGraphIsInvalidArgumentAndNamesTheField) {
  v1::SolveRequest request = Request();
  request.mutable_layout_graph()->mutable_object_list()->mutable_objects(0)->set_width_m(-1);
  const auto answer = Ask(*stub_, &Service::Solve, request);
  EXPECT_EQ(answer.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(answer.status().message()), HasSubstr("objects[0].width_m"));
}

TEST_F(OptimizerContract, AnEdgeOfNoKnownTypeIsNoReasonToFail) {
  v1::SolveRequest request = Request();
  v1::ConstraintEdge& edge = *request.mutable_layout_graph()->add_edges();
  edge.set_id("e1");
  edge.set_type("surely_no_such_type");
  edge.set_weight(1);
  const auto answer = Ask(*stub_, &Service::Solve, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_EQ(answer->solved_layout().edge_outcomes_size(), 1);
  EXPECT_EQ(answer->solved_layout().edge_outcomes(0).status(), v1::OUTCOME_STATUS_DROPPED);
  EXPECT_NE(answer->solved_layout().edge_outcomes(0).reason(), "");
}

// Restarts are a pure function of their numbers: what lets a solve be spread over several servers.
TEST_F(OptimizerContract, RestartsDoNotDependOnHowTheirRangeIsCut) {
  v1::SolveRestartsRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  request.mutable_options()->set_seed(5);
  request.set_stage("primary");
  request.set_restart_count(5);
  const auto whole = Ask(*stub_, &Service::SolveRestarts, request);
  ASSERT_TRUE(whole.ok()) << whole.status();
  ASSERT_EQ(whole->outcomes_size(), 5);
  std::string pieces, together;
  for (const auto& [first, count] : {std::pair(0, 1), std::pair(1, 3), std::pair(4, 1)}) {
    request.set_first_restart(first);
    request.set_restart_count(count);
    const auto piece = Ask(*stub_, &Service::SolveRestarts, request);
    ASSERT_TRUE(piece.ok()) << piece.status();
    for (const v1::RestartOutcome& outcome : piece->outcomes()) pieces += outcome.SerializeAsString();
  }
  for (const v1::RestartOutcome& outcome : whole->outcomes()) together += outcome.SerializeAsString();
  EXPECT_TRUE(pieces == together);
}

TEST_F(OptimizerContract, BadRestartsAreInvalidArgumentAndNameTheField) {
  v1::SolveRestartsRequest good;
  *good.mutable_layout_graph() = BedroomGraph();
  good.set_stage("primary");
  good.set_restart_count(1);
  const auto refused = [&](const v1::SolveRestartsRequest& request, const char* field) {
    const auto answer = Ask(*stub_, &Service::SolveRestarts, request);
    EXPECT_EQ(answer.status().code(), absl::StatusCode::kInvalidArgument) << field;
    EXPECT_THAT(std::string(answer.status().message()), HasSubstr(field));
  };
  v1::SolveRestartsRequest bad = good;
  bad.set_stage("quaternary");
  refused(bad, "stage");
  bad = good;
  bad.set_restart_count(1001);
  refused(bad, "restart_count");
  bad = good;
  bad.set_first_restart(-1);
  refused(bad, "first_restart");
  bad = good;
  bad.set_stage("secondary");
  bad.set_zone_id("nowhere");
  refused(bad, "zone_id");
  bad = good;
  bad.add_placements()->set_object_id("ghost");
  refused(bad, "placements[0].object_id");
}

// Would take minutes.
TEST_F(OptimizerContract, ADeadlineEndsASolve) {
  v1::SolveRequest request = Request();
  request.mutable_options()->set_max_restart_count(10000);
  request.mutable_options()->set_thread_count(1);
  runtime::CallContext call;
  const auto answer =
      runtime::UnaryRequest(*stub_, &Service::Solve, request, call, absl::Now() + absl::Milliseconds(300));
  EXPECT_EQ(answer.status().code(), absl::StatusCode::kDeadlineExceeded) << answer.status();
  // The server is free again at once.
  EXPECT_TRUE(Ask(*stub_, &Service::Solve, Request()).ok());
}

}  // namespace
}  // namespace flair::testing
