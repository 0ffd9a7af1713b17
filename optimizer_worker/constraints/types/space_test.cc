// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

v1::LayoutGraph GraphOf(const std::vector<v1::ConstraintEdge>& edges) {
  v1::LayoutGraph graph;
  graph.mutable_edges()->Assign(edges.begin(), edges.end());
  return graph;
}

TEST(Accessible, CostIsTheSquaredIntrusion) {
  const char* scene = "5x5 room; bed 1.6x2 at 2,1,0; box 1.6x1 at 2,3,0";
  EXPECT_NEAR(CostAt(scene, "accessible", "object=bed"), 0.01, 1e-12);
  EXPECT_NEAR(CostAt(scene, "accessible", "object=bed min_clearance_m=0.5"), 0, 1e-12);
}

TEST(Accessible, RugsAndThingsThatBelongThereMayLieInFront) {
  EXPECT_EQ(CostAt("5x5 room; bed 1.6x2 at 2,1,0; rug 2x2 at 2,2.2,0 rug", "accessible", "object=bed"), 0);
  const std::string scene = "5x5 room; desk 1.2x0.6 at 2,0.3,0; chair 0.5x0.5 at 2,0.85,180";
  EXPECT_GT(CostAt(scene, "accessible", "object=desk"), 0.1);
  LinkedPairs linked;
  linked.Link(1, 0);
  EXPECT_EQ(CostAt(scene, "accessible", "object=desk", &linked), 0);
}

TEST(Accessible, CallsThatPutTwoTogetherLinkThem) {
  const auto text = ParseScene("5x5 room; desk 1.2x0.6 at 2,0.3,0; chair 0.5x0.5 at 2,0.85,180; bed 1x2 at 4,1,0");
  ASSERT_TRUE(text.ok());
  const std::vector<v1::ConstraintEdge> edges = {EdgeFromText("next_to", "object=chair target=desk"),
                                                 EdgeFromText("away_from", "object=bed target=desk")};
  const LinkedPairs linked(text->scene, GraphOf(edges));
  EXPECT_TRUE(linked.BelongsAt(0, 1, Side::kLeft));
  EXPECT_FALSE(linked.BelongsAt(0, 2, Side::kLeft));
  EXPECT_FALSE(linked.BelongsAt(2, 0, Side::kLeft));
}

TEST(Accessible, AThingBelongsOnlyWhereItsCallPutsIt) {
  const auto text = ParseScene("5x5 room; sofa 2x1 at 2,0.5,0; stand 0.5x0.5 at 3,0.5,0");
  ASSERT_TRUE(text.ok());
  const std::vector<v1::ConstraintEdge> edges = {EdgeFromText("next_to", "object=stand target=sofa target_side=right")};
  const LinkedPairs linked(text->scene, GraphOf(edges));
  EXPECT_TRUE(linked.BelongsAt(0, 1, Side::kRight));
  EXPECT_FALSE(linked.BelongsAt(0, 1, Side::kFront));
  const char* in_the_way = "5x5 room; sofa 2x1 at 2,0.5,0; stand 0.5x0.5 at 2.5,1.4,0";
  EXPECT_GT(CostAt(in_the_way, "accessible", "object=sofa", &linked), 0.01);
  EXPECT_EQ(CostAt("5x5 room; sofa 2x1 at 2,0.5,0; stand 0.5x0.5 at 3.2,0.5,0", "accessible", "object=sofa sides=right",
                   &linked),
            0);
}

TEST(Accessible, BesideWithoutASideIsAnywhereButBeforeTheFront) {
  const auto text = ParseScene("5x5 room; sink 1x0.6 at 2,0.3,0; cooker 0.6x0.6 at 2.8,0.3,0");
  ASSERT_TRUE(text.ok());
  const std::vector<v1::ConstraintEdge> edges = {EdgeFromText("next_to", "object=cooker target=sink")};
  const LinkedPairs linked(text->scene, GraphOf(edges));
  for (const Side side : {Side::kLeft, Side::kRight, Side::kBack}) EXPECT_TRUE(linked.BelongsAt(0, 1, side));
  EXPECT_FALSE(linked.BelongsAt(0, 1, Side::kFront));
  EXPECT_FALSE(linked.BelongsAt(1, 0, Side::kFront));
}

TEST(Accessible, WhatIsOnlyLookedAtBlocksTheFloorBeforeAFront) {
  const char* scene = "5x5 room; bed 1.6x2 at 2,1,0; dresser 1x0.5 at 2,2.79,180";
  const auto text = ParseScene(scene);
  ASSERT_TRUE(text.ok());
  const LinkedPairs linked(text->scene, GraphOf({EdgeFromText("facing", "object=dresser target=bed")}));
  EXPECT_NEAR(CostAt(scene, "accessible", "object=dresser min_clearance_m=0.9", &linked), 0.36 * 0.36, 1e-9);
  EXPECT_GT(CostAt(scene, "accessible", "object=bed", &linked), 0);
  // Nor does it belong there when it is said to stand far before it.
  const LinkedPairs far(text->scene,
                        GraphOf({EdgeFromText("in_front_of", "object=dresser target=bed distance_m=1.5")}));
  EXPECT_FALSE(far.BelongsAt(1, 0, Side::kFront));
}

TEST(Accessible, WhatIsFacedAndBesideBelongsBeforeTheFrontWhicheverCallComesFirst) {
  const auto text = ParseScene("5x5 room; desk 1.2x0.6 at 2,0.3,0; chair 0.5x0.5 at 2,0.85,180");
  ASSERT_TRUE(text.ok());
  const v1::ConstraintEdge facing = EdgeFromText("facing", "object=chair target=desk");
  const v1::ConstraintEdge beside = EdgeFromText("next_to", "object=chair target=desk");
  for (const v1::LayoutGraph& graph : {GraphOf({facing, beside}), GraphOf({beside, facing})}) {
    const LinkedPairs linked(text->scene, graph);
    EXPECT_TRUE(linked.BelongsAt(0, 1, Side::kFront));
    EXPECT_TRUE(linked.BelongsAt(1, 0, Side::kFront));
  }
}

TEST(Accessible, WhereUsesAreKnownOnlyTheyLetSomethingBeforeAFront) {
  const auto text = ParseScene("5x5 room; sofa 2x1 at 2,0.5,0; table 1x0.5 at 2,1.6,0; shelf 1x0.3 at 2,2.3,180");
  ASSERT_TRUE(text.ok());
  v1::LayoutGraph graph = GraphOf({EdgeFromText("in_front_of", "object=table target=sofa distance_m=0.4"),
                                   EdgeFromText("in_front_of", "object=shelf target=sofa distance_m=1")});
  v1::Sentence& use = *graph.mutable_constraint_list()->add_sentences();
  use.set_id("s1");
  use.set_use(true);
  graph.mutable_edges(0)->set_sentence_id("s1");
  const LinkedPairs linked(text->scene, graph);
  EXPECT_TRUE(linked.BelongsAt(0, 1, Side::kFront));
  EXPECT_FALSE(linked.BelongsAt(0, 2, Side::kFront));
  EXPECT_FALSE(linked.BelongsAt(2, 0, Side::kFront));
}

TEST(Accessible, TheStripMustBeInsideTheRoom) {
  EXPECT_NEAR(CostAt("5x5 room; bed 1.6x2 at 2,3.5,0", "accessible", "object=bed"), 2 * 0.01, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
