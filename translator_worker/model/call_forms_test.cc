// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of calls that differ from the one that is asked for, and can only be meant in one way.
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "translator_worker/model/testing/test_translation.h"

namespace flair::translator {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

struct Deviation {
  const char* name;
  const char* call;
};
void PrintTo(const Deviation& deviation, std::ostream* out) { *out << deviation.name; }

class DeviationTest : public ModelTranslatorTest, public ::testing::WithParamInterface<Deviation> {};

TEST_P(DeviationTest, IsTakenAsItIsCertainlyMeant) {
  const v1::LayoutGraph graph = TranslateIntra(Answer(Entry("s1", {GetParam().call})));
  EXPECT_THAT(model_->requests(), SizeIs(3)) << "not worth another call";
  ASSERT_THAT(Types(graph), ElementsAre("against_wall", "surround", "on"));
  EXPECT_EQ(graph.edges(0).arguments(0).value().text(), "table");
  EXPECT_EQ(graph.edges(0).arguments(1).value().text(), "north");
  EXPECT_EQ(graph.edges(0).arguments_size(), 2);
}

INSTANTIATE_TEST_SUITE_P(All, DeviationTest,
                         ::testing::Values(Deviation{"as asked", "against_wall(table, wall=north)"},
                                           Deviation{"by place", "against_wall(table, north)"},
                                           Deviation{"capital letters", "AGAINST_WALL(TABLE, WALL=North)"},
                                           Deviation{"camel case", "againstWall(table, wall=north)"},
                                           Deviation{"spaces", "  against wall ( table ,wall = north )  "},
                                           Deviation{"nothing for the side", "against_wall(table, None, north)"},
                                           Deviation{"null for the side",
                                                     "against_wall(table, side=null, wall='north')"},
                                           Deviation{"other order", "against_wall(wall=north, object=table)"},
                                           Deviation{"a list of one", "against_wall([table], wall=[north])"},
                                           Deviation{"no last bracket", "against_wall(table, wall=north"},
                                           Deviation{"released name", "ind_next_to_wall(table, wall=north)"}),
                         [](const auto& info) {
                           std::string name;
                           for (const char c : std::string(info.param.name)) name += c == ' ' ? '_' : c;
                           return name;
                         });

TEST_F(ModelTranslatorTest, ListsAreUnderstoodHoweverTheyAreWritten) {
  for (const char* call : {"surround(table, dining_chair_1, dining_chair_2)", "surround(table, dining chairs)",
                           "surround(object=table, others=dining_chair_1, dining_chair_2)",
                           "surround(table, others=['dining_chair_1', 'dining_chair_2'])"}) {
    model_->Answer("translation.intra", Answer(Entry("s1", {kWallCall})));
    model_->Answer("translation.inter", Answer(Entry("s2", {call})));
    model_->Answer("translation.tertiary", Answer(Entry("s3", {kOnCall})));
    const auto response = translator_->Translate(request_, call_);
    ASSERT_TRUE(response.ok()) << response.status();
    ASSERT_THAT(response->layout_graph().edges(), SizeIs(3)) << call;
    EXPECT_THAT(response->layout_graph().edges(1).arguments(1).value().texts().items(),
                ElementsAre("dining_chair_1", "dining_chair_2"))
        << call;
  }
}

TEST_F(ModelTranslatorTest, AnEntryMayBeALineOrAnObject) {
  for (const char* answer : {R"x({"sentences": ["s1: against_wall(table)"]})x",
                             R"x({"sentences": ["S1 against_wall(table)."]})x", R"x(["- s1: against_wall(table)"])x",
                             R"x({"sentences": [{"id": "s1", "calls": "against_wall(table)", "refusal": null}]})x",
                             R"x({"sentences": [{"id": 1, "calls": ["against_wall(table)"]}]})x",
                             R"x({"sentences": [{"id": "Sentence 1", "calls": ["against_wall(table)"]}]})x"}) {
    const v1::LayoutGraph graph = TranslateIntra(answer);
    EXPECT_THAT(Types(graph), ElementsAre("against_wall", "surround", "on")) << answer;
  }
  EXPECT_THAT(model_->requests(), SizeIs(18)) << "none of them is asked about";
}

TEST_F(ModelTranslatorTest, ACallThatIsJsonIsAskedAboutOnce) {
  const v1::LayoutGraph graph = TranslateIntra(
      Answer(Entry("s1", {R"({"function": "against_wall", "object": "table"})"})), Answer(Entry("s1", {kWallCall})));
  EXPECT_THAT(Types(graph), ElementsAre("against_wall", "surround", "on"));
  EXPECT_THAT(model_->requests(), SizeIs(4));
}

}  // namespace
}  // namespace flair::translator
