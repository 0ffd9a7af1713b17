// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/graph/layout_diagram.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

void AddCall(v1::LayoutGraph& graph, const std::string& type, const std::vector<std::string>& texts) {
  v1::ConstraintEdge& edge = *graph.add_edges();
  edge.set_id("e" + std::to_string(graph.edges_size()));
  edge.set_type(type);
  edge.set_weight(1);
  for (const std::string& text : texts) {
    v1::Argument& argument = *edge.add_arguments();
    argument.set_name("a" + std::to_string(edge.arguments_size()));
    argument.mutable_value()->set_text(text);
  }
}

// Three things of one zone and calls of every arity.
v1::LayoutGraph Graph() {
  v1::LayoutGraph graph;
  *graph.mutable_room() = testing::BedroomRoom();
  *graph.mutable_zone_plan() = testing::BedroomZones();
  for (const char* id : {"bed", "lamp", "desk"}) *graph.mutable_object_list()->add_objects() = testing::BedroomBed(id);
  AddCall(graph, "against_wall", {"bed", "back"});
  AddCall(graph, "next_to", {"bed", "lamp"});
  AddCall(graph, "facing", {"lamp", "bed"});
  AddCall(graph, "far_from", {"desk", "door"});
  AddCall(graph, "on_wall", {"desk", "north"});
  AddCall(graph, "balanced", {});
  AddCall(graph, "in_line", {"bed", "lamp", "desk"});
  return graph;
}

const DiagramNode& NodeOf(const Diagram& diagram, const std::string& id) {
  for (const DiagramNode& node : diagram.nodes) {
    if (node.id == id) return node;
  }
  ADD_FAILURE() << "no node " << id;
  return diagram.nodes.front();
}

TEST(LayoutDiagram, EveryCallHasAPlaceByWhatItNames) {
  const Diagram diagram = DiagramOf(Graph());
  EXPECT_EQ(diagram.nodes.size(), 6u) << "three objects, the door, a wall, the room";
  ASSERT_EQ(NodeOf(diagram, "bed").rows.size(), 1u);
  EXPECT_EQ(NodeOf(diagram, "bed").rows[0].words, "against wall (back)");
  EXPECT_EQ(NodeOf(diagram, "the room").rows[0].words, "balanced");
  EXPECT_EQ(NodeOf(diagram, "door").facts, "door_1");
  EXPECT_EQ(NodeOf(diagram, "wall north").kind, DiagramKind::kWall);
  ASSERT_EQ(diagram.links.size(), 3u) << "calls between the same two are one link";
  EXPECT_EQ(diagram.links[0].calls.size(), 2u);
  ASSERT_EQ(diagram.groups.size(), 1u);
  EXPECT_EQ(diagram.groups[0].members.size(), 3u);
}

TEST(LayoutDiagram, VerdictsComeWithTheLayoutAlone) {
  EXPECT_EQ(NodeOf(DiagramOf(Graph()), "bed").rows[0].status, v1::OUTCOME_STATUS_UNSPECIFIED);
  v1::SolvedLayout layout;
  *layout.mutable_graph() = Graph();
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_edge_id(edge.id());
    outcome.set_status(v1::OUTCOME_STATUS_SATISFIED);
  }
  layout.mutable_edge_outcomes(2)->set_status(v1::OUTCOME_STATUS_VIOLATED);
  layout.mutable_edge_outcomes(2)->set_missed_by(0.25);
  layout.mutable_edge_outcomes(2)->set_unit("m");
  const Diagram diagram = DiagramOf(layout);
  EXPECT_EQ(WorstOf(diagram.links[0].calls), v1::OUTCOME_STATUS_VIOLATED);
  EXPECT_THAT(diagram.links[0].calls[1].words, HasSubstr("off by 0.25 m"));
  EXPECT_THAT(DotText(diagram), AllOf(HasSubstr("#C62F26"), HasSubstr("does not hold")));
}

TEST(DotText, NamesOfAnyScriptAndAnySignAreEscaped) {
  v1::LayoutGraph graph = Graph();
  graph.mutable_room()->set_title("A <b>room</b> & \"more\"\x01");
  graph.mutable_object_list()->mutable_objects(0)->set_name("寝台 \\N <TABLE> & \"x\"");
  graph.mutable_object_list()->mutable_objects(1)->set_name("سرير");
  const std::string dot = DotText(DiagramOf(graph));
  EXPECT_THAT(dot, AllOf(HasSubstr("A &lt;b&gt;room&lt;/b&gt; &amp; &quot;more&quot; "), HasSubstr("寝台"),
                         HasSubstr("\\\\N <TABLE> &amp; \\\"x\\\""), Not(HasSubstr("\x01"))));
  const absl::StatusOr<std::string> svg = RunDot(dot, "svg");
  ASSERT_TRUE(svg.ok()) << svg.status();
  EXPECT_THAT(*svg, AllOf(HasSubstr("寝台"), HasSubstr("سرير"), HasSubstr("</svg>")));
}

TEST(DotText, TheSentenceBehindACallIsItsTooltipInRowsAndOnLinks) {
  v1::LayoutGraph graph = Graph();
  for (const int edge : {0, 1}) {
    v1::Sentence& sentence = *graph.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
    sentence.set_id("s" + std::to_string(edge));
    sentence.set_text(edge == 0 ? "It leans on a wall." : "Both are close.");
    graph.mutable_edges(edge)->set_sentence_id(sentence.id());
  }
  const absl::StatusOr<std::string> svg = RunDot(DotText(DiagramOf(graph)), "svg");
  ASSERT_TRUE(svg.ok()) << svg.status();
  EXPECT_THAT(*svg, AllOf(HasSubstr("xlink:title=\"It leans on a wall."), HasSubstr("xlink:title=\"Both are close.")));
}

TEST(RunDot, TheSameTextGivesTheSameBytes) {
  const std::string dot = DotText(DiagramOf(Graph()));
  for (const char* format : {"svg", "png", "pdf"}) {
    const absl::StatusOr<std::string> once = RunDot(dot, format), again = RunDot(dot, format);
    ASSERT_TRUE(once.ok() && again.ok()) << once.status();
    EXPECT_TRUE(*once == *again) << format;
  }
}

TEST(RunDot, WhatGraphvizCannotReadIsItsErrorInWords) {
  const absl::StatusOr<std::string> svg = RunDot("digraph { a -> ", "svg");
  EXPECT_EQ(svg.status().code(), absl::StatusCode::kInternal);
  EXPECT_THAT(std::string(svg.status().message()), HasSubstr("dot: failed: Error: <stdin>: syntax error"));
}

}  // namespace
}  // namespace flair::cli
