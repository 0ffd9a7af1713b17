// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/compare/trial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A bed that is to stand against a wall, and to glow, which no catalogue of ours knows.
v1::SolveRequest Request() {
  v1::SolveRequest request;
  v1::LayoutGraph& graph = *request.mutable_layout_graph();
  *graph.mutable_room() = testing::BedroomRoom();
  *graph.mutable_zone_plan() = testing::BedroomZones();
  *graph.mutable_object_list()->add_objects() = testing::BedroomBed();
  *graph.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
  *graph.add_edges() = testing::BedroomEdge();
  v1::ConstraintEdge& glow = *graph.add_edges() = testing::BedroomEdge();
  glow.set_id("e2");
  glow.set_type("glow");
  return request;
}

// The bed in the middle of the room; the optimizer says that both calls hold.
v1::SolveResponse Boast(const v1::SolveRequest& request) {
  v1::SolveResponse response;
  v1::SolvedLayout& layout = *response.mutable_solved_layout();
  *layout.mutable_graph() = request.layout_graph();
  v1::Placement& place = *layout.add_placements();
  place.set_object_id("bed");
  place.set_x_m(2);
  place.set_y_m(2.5);
  for (const v1::ConstraintEdge& edge : request.layout_graph().edges()) {
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_edge_id(edge.id());
    outcome.set_status(v1::OUTCOME_STATUS_SATISFIED);
  }
  return response;
}

TEST(Trial, WhatHoldsIsJudgedHereWhateverTheOptimizerSays) {
  const v1::SolveRequest request = Request();
  const absl::StatusOr<Trial> trial = Judge(request, Boast(request));
  ASSERT_TRUE(trial.ok()) << trial.status();
  ASSERT_EQ(trial->verdicts.size(), 2u);
  EXPECT_EQ(trial->verdicts[0].outcome.status(), v1::OUTCOME_STATUS_VIOLATED);
  EXPECT_FALSE(trial->verdicts[0].is_its_own);
  EXPECT_EQ(trial->claimed_count, 2);
  EXPECT_EQ(trial->held_count, 1);
  EXPECT_GT(trial->layout.total_cost(), 0);
}

TEST(Trial, ATypeThatWeDoNotKnowKeepsTheOptimizersVerdictAndIsMarked) {
  const v1::SolveRequest request = Request();
  const absl::StatusOr<Trial> trial = Judge(request, Boast(request));
  ASSERT_TRUE(trial.ok()) << trial.status();
  EXPECT_TRUE(trial->verdicts[1].is_its_own);
  EXPECT_EQ(trial->verdicts[1].outcome.status(), v1::OUTCOME_STATUS_SATISFIED);
  EXPECT_EQ(trial->unknown_count, 1);
  const Contest contest{.name = "g", .graph = request.layout_graph(), .seed = 5, .trials = {*trial, *trial}};
  EXPECT_THAT(ContestText(contest, {"own", "theirs"}, true),
              AllOf(HasSubstr("g: 1 object, 2 constraints, seed 5"), HasSubstr("holds*"),
                    HasSubstr("* the optimizer's own verdict: our catalogue does not have the type of 1")));
}

TEST(Trial, AnAnswerWithAnotherGraphIsJudgedOnTheGraphThatWasGiven) {
  const v1::SolveRequest request = Request();
  v1::SolveResponse response = Boast(request);
  response.mutable_solved_layout()->mutable_graph()->clear_edges();
  response.mutable_solved_layout()->clear_edge_outcomes();
  const absl::StatusOr<Trial> trial = Judge(request, response);
  ASSERT_TRUE(trial.ok()) << trial.status();
  EXPECT_EQ(trial->verdicts.size(), 2u);
  EXPECT_EQ(trial->claimed_count, 0);
}

TEST(Trial, AnAnswerThatIsNoLayoutIsRefused) {
  const v1::SolveRequest request = Request();
  v1::SolveResponse response = Boast(request);
  response.mutable_solved_layout()->mutable_placements(0)->set_x_m(1e9);
  const absl::Status status = Judge(request, response).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInternal);
  EXPECT_THAT(std::string(status.message()), HasSubstr("its layout"));
}

}  // namespace
}  // namespace flair::cli
