// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/resolve_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "google/protobuf/text_format.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// The bedroom with a wardrobe and a desk that carries a lamp.
v1::LayoutGraph Furnished() {
  return Parse(
      RoomText(4.5, 4) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 2.0) +
      ObjectText("nightstand", "SECONDARY", "FLOOR", 0.5, 0.4) +
      ObjectText("wardrobe", "SECONDARY", "FLOOR", 1.5, 0.6) + ObjectText("desk", "SECONDARY", "FLOOR", 1.2, 0.6) +
      ObjectText("picture", "TERTIARY", "WALL", 0.8, 0.05) + ObjectText("lamp", "TERTIARY", "SURFACE", 0.2, 0.2) + "}" +
      EdgeText("e1", "against_wall", Text("object", "bed")) +
      EdgeText("e2", "next_to",
               Text("object", "nightstand") + Text("target", "bed") + Text("object_side", "right") +
                   Text("target_side", "left")) +
      EdgeText("e3", "against_wall", Text("object", "wardrobe")) +
      EdgeText("e4", "against_wall", Text("object", "desk")) +
      EdgeText("e5", "on_wall_above", Text("object", "picture") + Text("target", "bed")) +
      EdgeText("e6", "on_top_center", Text("object", "lamp") + Text("host", "desk")));
}

const v1::SolvedLayout& Start() {
  static const v1::SolvedLayout layout = SolveLayout(Furnished(), {}, NloptSolver())->layout;
  return layout;
}

absl::StatusOr<ResolveResult> TryEdit(const v1::SolvedLayout& layout, const std::vector<std::string>& lines,
                                      int threads = 1) {
  google::protobuf::RepeatedPtrField<v1::LayoutEdit> edits;
  for (const std::string& line : lines) *edits.Add() = *EditFromText(line, layout);
  v1::SolveOptions options;
  options.set_thread_count(threads);
  return ResolveLayout(layout, edits, options, NloptSolver());
}

ResolveResult Edit(const v1::SolvedLayout& layout, const std::vector<std::string>& lines) {
  absl::StatusOr<ResolveResult> result = TryEdit(layout, lines);
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? *std::move(result) : ResolveResult{};
}

// Objects that are not among `moved` stand exactly where they stood.
void ExpectOthersUntouched(const v1::SolvedLayout& before, const ResolveResult& after) {
  const std::set<std::string> moved(after.moved_ids.begin(), after.moved_ids.end());
  for (const v1::Placement& placement : after.layout.placements()) {
    if (moved.contains(placement.object_id())) continue;
    EXPECT_EQ(placement.SerializeAsString(), PlacementOf(before, placement.object_id()).SerializeAsString());
  }
}

int Satisfied(const v1::SolvedLayout& layout) {
  int count = 0;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    count += outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
  }
  return count;
}

TEST(ResolveLayout, WithoutEditsMovesNothing) {
  const ResolveResult result = Edit(Start(), {});
  EXPECT_TRUE(result.moved_ids.empty());
  EXPECT_EQ(result.layout.total_cost(), Start().total_cost());
  ExpectOthersUntouched(Start(), result);
}

bool Tells(const ResolveResult& result, const char* code, const char* words) {
  return std::ranges::any_of(result.layout.diagnostics(), [&](const v1::Diagnostic& diagnostic) {
    return diagnostic.code() == code && diagnostic.message().find(words) != std::string::npos;
  });
}

// The wardrobe and the desk close off the corner that the door leads into.
TEST(ResolveLayout, AWayThatIsLostIsToldWithWhatIsInIt) {
  const ResolveResult result =
      Edit(Start(), {"move wardrobe 0.75 1.55 0", "move desk 1.4 0.6 90", "pin bed", "pin nightstand"});
  EXPECT_TRUE(Tells(result, "way_blocked", "% of the free floor can be reached from the door"))
      << result.layout.DebugString();
  EXPECT_TRUE(Tells(result, "way_blocked", "is in the way"));
  EXPECT_TRUE(Tells(result, "front_blocked", "nobody gets to the front of the bed any more"));
}

// Nothing asks for the shelf's place; that it leans on a wall is worth keeping all the same.
TEST(ResolveLayout, APieceWithoutACallStaysAtItsWall) {
  const v1::LayoutGraph graph =
      Parse(RoomText(4.5, 4) + "object_list {" + ObjectText("table", "PRIMARY", "FLOOR", 1.6, 0.9) +
            ObjectText("shelf", "SECONDARY", "FLOOR", 1.0, 0.3) + "}" +
            EdgeText("e1", "near", Text("object", "shelf") + Text("target", "table")));
  v1::SolvedLayout layout = SolveLayout(graph, {}, NloptSolver())->layout;
  for (v1::Placement& placement : *layout.mutable_placements()) {
    const bool shelf = placement.object_id() == "shelf";
    placement.set_x_m(2.2);
    placement.set_y_m(shelf ? 3.85 : 2);
    placement.set_theta_rad(shelf ? kPi : 0);
  }
  for (const char* move : {"move table 2.2 3.3 0", "move table 2.5 3.15 90", "move table 1.9 3.25 20"}) {
    const ResolveResult result = Edit(layout, {move});
    EXPECT_LT(result.layout.metrics().deepest_overlap_m(), 1e-6) << move;
    const v1::Placement& shelf = PlacementOf(result.layout, "shelf");
    const double off_m = std::min({4 - shelf.y_m(), shelf.y_m(), shelf.x_m(), 4.5 - shelf.x_m()}) - 0.15;
    EXPECT_LT(off_m, 0.03) << move;
    EXPECT_FALSE(Tells(result, "off_wall", "")) << move;
  }
}

TEST(ResolveLayout, WhatIsWedgedBesideAMovedPieceGoesElsewhereAndNothingElseDoes) {
  const v1::LayoutGraph graph = Parse(
      RoomText(4.5, 4) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 2.0) +
      ObjectText("chest", "SECONDARY", "FLOOR", 0.8, 0.8) + ObjectText("lamp", "SECONDARY", "FLOOR", 0.4, 0.4) +
      ObjectText("desk", "SECONDARY", "FLOOR", 1.2, 0.6) + "}" + EdgeText("e1", "against_wall", Text("object", "bed")) +
      EdgeText("e2", "against_wall", Text("object", "lamp")) + EdgeText("e3", "against_wall", Text("object", "desk")));
  v1::SolvedLayout layout = SolveLayout(graph, {}, NloptSolver())->layout;
  const std::map<std::string, std::array<double, 2>> places = {
      {"bed", {0.8, 3.0}}, {"chest", {2.4, 3.6}}, {"lamp", {3.0, 3.8}}, {"desk", {3.85, 3.7}}};
  for (v1::Placement& placement : *layout.mutable_placements()) {
    placement.set_x_m(places.at(placement.object_id())[0]);
    placement.set_y_m(places.at(placement.object_id())[1]);
    placement.set_theta_rad(kPi);
  }
  for (const char* move : {"move chest 2.5 3.6", "move chest 2.6 3.6", "move chest 2.6 3.4 200"}) {
    const ResolveResult result = Edit(layout, {move});
    EXPECT_EQ(result.moved_ids, (std::vector<std::string>{"chest", "lamp"})) << move;
    EXPECT_LT(result.layout.metrics().deepest_overlap_m(), 1e-6) << move;
  }
}

TEST(ResolveLayout, PinningMovesNothingAndIsRemembered) {
  const ResolveResult result = Edit(Start(), {"pin bed"});
  EXPECT_TRUE(result.moved_ids.empty());
  ASSERT_EQ(result.layout.graph().pinned_placements_size(), 1);
  const ResolveResult free = Edit(result.layout, {"unpin bed"});
  EXPECT_EQ(free.layout.graph().pinned_placements_size(), 0);
}

TEST(ResolveLayout, WhatBelongsToAMovedObjectComesAlong) {
  ASSERT_EQ(Satisfied(Start()), 6);
  const double x_m = PlacementOf(Start(), "bed").x_m() > 2.25 ? 0.8 : 3.7;
  const ResolveResult result = Edit(Start(), {fmt::format("move bed {} 3.0 180", x_m)});
  const v1::Placement& bed = PlacementOf(result.layout, "bed");
  EXPECT_EQ(bed.x_m(), x_m);
  EXPECT_EQ(bed.y_m(), 3.0);
  EXPECT_EQ(result.layout.diagnostics_size(), 0) << result.layout.diagnostics(0).message();
  EXPECT_LT(result.layout.metrics().deepest_overlap_m(), 1e-6);
  // Its headboard is at the north wall, so everything can hold again.
  EXPECT_EQ(Satisfied(result.layout), 6);
  ExpectOthersUntouched(Start(), result);
}

TEST(ResolveLayout, ThingsOnTopRideAlong) {
  const v1::Placement& desk = PlacementOf(Start(), "desk");
  const v1::Placement& lamp = PlacementOf(Start(), "lamp");
  const v1::SolvedLayout bigger = Edit(Start(), {"remove wardrobe", "remove bed", "remove nightstand"}).layout;
  const ResolveResult result = Edit(bigger, {"move desk 2.2 2.0 37"});
  const v1::Placement& after = PlacementOf(result.layout, "lamp");
  EXPECT_NEAR(std::hypot(after.x_m() - 2.2, after.y_m() - 2.0),
              std::hypot(lamp.x_m() - desk.x_m(), lamp.y_m() - desk.y_m()), 1e-9);
}

TEST(ResolveLayout, AResizedObjectFitsAgain) {
  const ResolveResult result = Edit(Start(), {"resize wardrobe 1.9x0.7x2.2"});
  EXPECT_EQ(result.layout.diagnostics_size(), 0) << result.layout.diagnostics(0).message();
  EXPECT_LT(result.layout.metrics().deepest_overlap_m(), 1e-6);
  EXPECT_EQ(Satisfied(result.layout), 6);
  ExpectOthersUntouched(Start(), result);
}

TEST(ResolveLayout, AnAddedObjectIsPlacedAndARemovedOneTakesItsEdges) {
  const ResolveResult added = Edit(Start(), {"add plant 0.3x0.3x1 near desk"});
  EXPECT_EQ(added.layout.placements_size(), 7);
  EXPECT_EQ(added.layout.edge_outcomes_size(), 7);
  EXPECT_EQ(added.moved_ids.front(), "plant") << added.moved_ids.size();
  EXPECT_LT(added.layout.metrics().deepest_overlap_m(), 1e-6);
  const ResolveResult removed = Edit(added.layout, {"remove plant"});
  EXPECT_EQ(removed.layout.placements_size(), 6);
  EXPECT_EQ(removed.layout.edge_outcomes_size(), 6);
  ASSERT_EQ(removed.layout.diagnostics_size(), 1);
  EXPECT_EQ(removed.layout.diagnostics(0).code(), "edge_removed");
  EXPECT_TRUE(removed.moved_ids.empty());
}

TEST(ResolveLayout, WhatWasSaidOfARemovedObjectIsGoneWithIt) {
  v1::SolvedLayout layout = Start();
  const auto say = [&](const std::string& id, const char* text) {
    v1::Sentence& sentence = *layout.mutable_graph()->mutable_constraint_list()->add_sentences();
    sentence.set_id(id);
    sentence.set_text(text);
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    sentence.set_weight(1);
  };
  for (v1::ConstraintEdge& edge : *layout.mutable_graph()->mutable_edges()) {
    edge.set_sentence_id("of_" + edge.id());
    say(edge.sentence_id(), edge.id() == "e5" ? "The picture hangs above the bed." : "The room is furnished.");
  }
  say("not_understood", "The room is as I like it.");
  const ResolveResult removed = Edit(layout, {"remove picture"});
  EXPECT_EQ(removed.layout.graph().constraint_list().sentences_size(), 6);
  ASSERT_EQ(removed.layout.diagnostics_size(), 1);
  EXPECT_EQ(removed.layout.diagnostics(0).message(),
            "\"The picture hangs above the bed.\" is gone with \"picture\", which it names");
}

TEST(ResolveLayout, AnAddedPictureIsHungAndNothingElseMoves) {
  google::protobuf::RepeatedPtrField<v1::LayoutEdit> edits;
  v1::AddObject& add = *edits.Add()->mutable_add_object();
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(
      R"(id: "mirror" name: "mirror" role: OBJECT_ROLE_TERTIARY kind: OBJECT_KIND_WALL zone_id: "sleeping"
         width_m: 0.5 depth_m: 0.03 height_m: 0.7 elevation_m: 1.4)",
      add.mutable_object()));
  const absl::StatusOr<ResolveResult> result = ResolveLayout(Start(), edits, {}, NloptSolver());
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_EQ(result->moved_ids, std::vector<std::string>{"mirror"});
  EXPECT_EQ(result->layout.diagnostics_size(), 0) << result->layout.diagnostics(0).message();
  EXPECT_EQ(PlacementOf(result->layout, "mirror").z_m(), 1.4);
  ExpectOthersUntouched(Start(), *result);
}

TEST(ResolveLayout, WhatStoodOnARemovedObjectFindsAnotherPlace) {
  const ResolveResult result = Edit(Start(), {"remove desk"});
  EXPECT_EQ(result.layout.placements_size(), 5);
  EXPECT_EQ(result.layout.edge_outcomes_size(), 4);
  // On top of something that is left, not in the air.
  EXPECT_GT(PlacementOf(result.layout, "lamp").z_m(), 0.1);
  EXPECT_EQ(result.moved_ids, std::vector<std::string>{"lamp"});
}

v1::SolvedLayout WithBooks(const std::string& more_furniture) {
  const v1::LayoutGraph graph =
      Parse(RoomText(4.5, 4) + "object_list {" + ObjectText("bookshelf", "PRIMARY", "FLOOR", 1.0, 0.4) +
            ObjectText("armchair", "SECONDARY", "FLOOR", 0.8, 0.8) + more_furniture +
            ObjectText("books", "TERTIARY", "SURFACE", 0.2, 0.2) + "}" +
            EdgeText("e1", "on_top_center", Text("object", "books") + Text("host", "bookshelf")));
  return SolveLayout(graph, {}, NloptSolver())->layout;
}

TEST(ResolveLayout, BooksOfARemovedShelfGoToATableAndNotToAnArmchair) {
  const v1::SolvedLayout start = WithBooks(ObjectText("side_table", "SECONDARY", "FLOOR", 0.5, 0.5));
  const ResolveResult result = Edit(start, {"remove bookshelf"});
  const v1::Placement& books = PlacementOf(result.layout, "books");
  const v1::Placement& table = PlacementOf(result.layout, "side_table");
  EXPECT_LE(std::abs(books.x_m() - table.x_m()), 0.25);
  EXPECT_LE(std::abs(books.y_m() - table.y_m()), 0.25);
}

TEST(ResolveLayout, BooksWithoutAnotherShelfOrTableAreLeftOutAndNamed) {
  const ResolveResult result = Edit(WithBooks(""), {"remove bookshelf"});
  EXPECT_EQ(result.layout.placements_size(), 1);
  bool named = false;
  for (const v1::Diagnostic& diagnostic : result.layout.diagnostics()) {
    named |= diagnostic.code() == "left_out" && diagnostic.subject_id() == "books" &&
             diagnostic.message().find("the bookshelf, which is gone") != std::string::npos;
  }
  EXPECT_TRUE(named) << result.layout.ShortDebugString();
}

TEST(ResolveLayout, LeavesOutWhatNoLongerFitsWhenAskedTo) {
  google::protobuf::RepeatedPtrField<v1::LayoutEdit> edits;
  *edits.Add() = *EditFromText("resize wardrobe 4.4x3.9", Start());
  v1::SolveOptions options;
  options.set_misfit_policy(v1::MISFIT_POLICY_LEAVE_OUT);
  const absl::StatusOr<ResolveResult> result = ResolveLayout(Start(), edits, options, NloptSolver());
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_LT(result->layout.metrics().deepest_overlap_m(), 1e-6);
  EXPECT_LT(result->layout.placements_size(), 6);
}

TEST(ResolveLayout, ANewConstraintIsMetAndADroppedOneIsGone) {
  const std::string wall = PlacementOf(Start(), "desk").y_m() > 2 ? "east" : "north";
  const ResolveResult added = Edit(Start(), {"edge against_wall object=desk wall=" + wall});
  const v1::EdgeOutcome& outcome = added.layout.edge_outcomes(6);
  EXPECT_EQ(outcome.status(), v1::OUTCOME_STATUS_SATISFIED) << outcome.ShortDebugString();
  EXPECT_EQ(Satisfied(added.layout), 7);
  const ResolveResult dropped = Edit(added.layout, {"drop e7", "weight e1 3"});
  EXPECT_EQ(dropped.layout.edge_outcomes_size(), 6);
  EXPECT_EQ(dropped.layout.graph().edges(0).weight(), 3);
}

TEST(ResolveLayout, IsBitIdenticalForAnyNumberOfThreads) {
  const auto one = TryEdit(Start(), {"move desk 2.2 2.0", "resize bed 1.8x2.1"}, 1);
  const auto four = TryEdit(Start(), {"move desk 2.2 2.0", "resize bed 1.8x2.1"}, 4);
  ASSERT_TRUE(one.ok() && four.ok());
  EXPECT_EQ(one->layout.SerializeAsString(), four->layout.SerializeAsString());
  EXPECT_EQ(one->moved_ids, four->moved_ids);
}

TEST(ResolveLayout, NamesTheEditThatIsWrong) {
  struct Case {
    const char* line;
    const char* says;
  };
  const Case cases[] = {
      {"move ghost 1 1", "edits[1].move_object: \"ghost\""},
      {"move bed 90 1", "edits[1].move_object"},
      {"pin ghost", "edits[1].pin_object_id"},
      {"unpin wardrobe", "edits[1].unpin_object_id: \"wardrobe\" is not pinned"},
      {"resize bed 0x2", "edits[1].resize_object"},
      {"add bed 1x1x1", "edits[1].add_object.object.id"},
      {"add plant -1x1x1", "edits[1].add_object"},
      {"remove ghost", "edits[1].remove_object_id"},
      {"drop e99", "edits[1].remove_edge_id: \"e99\""},
      {"weight e1 0", "edits[1].set_edge_weight.weight: 0"},
      {"edge no_such_type object=bed", "edits[1].add_edge"},
      {"edge against_wall object=bed wall=up", "edits[1].add_edge"},
  };
  for (const Case& c : cases) {
    const absl::Status status = TryEdit(Start(), {"pin bed", c.line}).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << c.line;
    EXPECT_NE(status.message().find(c.says), absl::string_view::npos) << c.line << ": " << status;
  }
}

TEST(ResolveLayout, AnEditWithoutContentIsRejected) {
  google::protobuf::RepeatedPtrField<v1::LayoutEdit> edits;
  edits.Add();
  const absl::Status status = ResolveLayout(Start(), edits, {}, NloptSolver()).status();
  EXPECT_NE(status.message().find("edits[0]: is not set"), absl::string_view::npos) << status;
}

TEST(ResolveLayout, StopsWhenCancelled) {
  google::protobuf::RepeatedPtrField<v1::LayoutEdit> edits;
  *edits.Add() = *EditFromText("move desk 2.2 2.0", Start());
  const auto result = ResolveLayout(Start(), edits, {}, NloptSolver(), [] { return true; });
  EXPECT_EQ(result.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace flair::optimizer
