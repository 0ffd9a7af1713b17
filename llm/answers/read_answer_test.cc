// SPDX-License-Identifier: GPL-3.0-or-later
// What is read of an answer, and what else certainly means the same.
#include "llm/answers/read_answer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "llm/testing/read_answer_samples.h"

namespace flair::llm {
namespace {

using model::v1::CallsAnswer;
using model::v1::FloorObjectsAnswer;
using model::v1::TertiariesAnswer;
using model::v1::ZonesAnswer;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ReadAnswer, ReadsWhatTheSchemaAsksFor) {
  FloorObjectsAnswer answer;
  EXPECT_THAT(Sentences(ReadAnswer(Object(""), kZones, answer)), IsEmpty());
  ASSERT_EQ(answer.objects_size(), 1);
  EXPECT_EQ(answer.objects(0).name(), "bed");
  EXPECT_TRUE(answer.objects(0).primary());
  EXPECT_EQ(answer.objects(0).width_m(), 1.6);
  EXPECT_FALSE(answer.objects(0).has_description());
}

TEST(ReadAnswer, TakesWhatCertainlyMeansTheSame) {
  FloorObjectsAnswer answer;
  const std::string text = R"({"Objects":{"Name":" work\n bench ","zone":"Floor-Work","primary":"True","count":"2",
      "width":"120 cm","Length":0.6,"height_m":"0.9"}})";
  EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty());
  ASSERT_EQ(answer.objects_size(), 1);
  EXPECT_EQ(answer.objects(0).name(), "work bench");
  EXPECT_EQ(answer.objects(0).zone(), "floor work");
  EXPECT_TRUE(answer.objects(0).primary());
  EXPECT_EQ(answer.objects(0).count(), 2);
  EXPECT_NEAR(answer.objects(0).width_m(), 1.2, 1e-12);
  EXPECT_EQ(answer.objects(0).depth_m(), 0.6);
}

TEST(ReadAnswer, ARootMayBeWrappedOrBeItsOnlyList) {
  for (const std::string& text :
       std::vector<std::string>{R"({"zones_answer":{"zones":[{"name":"a","purpose":"b"}]}})",
                                R"([{"answer":{"zones":[{"name":"a","purpose":"b"}]}}])",
                                R"([{"name":"a","purpose":"b"}])", R"({"zones":{"name":"a","purpose":"b"}})"}) {
    ZonesAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty()) << text;
    EXPECT_EQ(answer.zones_size(), 1) << text;
  }
}

TEST(ReadAnswer, AnElementMayBeALine) {
  const FieldChoices ids = {{"flair.model.v1.SentenceCallsAnswer.id", {{"s1", "s2"}, {}}}};
  for (const std::string& text : std::vector<std::string>{
           R"x({"sentences":["s1: near(a, b)","s2: none(why: light)"]})x",
           R"x(["- s1 = near(a, b)","[s2] none(why: light)"])x",
           R"x({"sentences":[{"id":"s1","calls":["near(a, b)"]},"S2 none(why: light)"]})x",
       }) {
    CallsAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, ids, answer)), IsEmpty()) << text;
    ASSERT_EQ(answer.sentences_size(), 2) << text;
    EXPECT_EQ(answer.sentences(0).id(), "s1") << text;
    EXPECT_THAT(answer.sentences(0).calls(), ElementsAre("near(a, b)")) << text;
    EXPECT_EQ(answer.sentences(1).id(), "s2") << text;
    EXPECT_THAT(answer.sentences(1).calls(), ElementsAre("none(why: light)")) << text;
  }
  for (const std::string& text :
       std::vector<std::string>{R"x({"sentences":[""]})x", R"x({"sentences":["near(a)"]})x", R"x({"sentences":[7]})x",
                                R"x({"sentences":[": - ["]})x", R"x({"sentences":[null]})x"}) {
    CallsAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, ids, answer)), ElementsAre(HasSubstr("sentences[0]"))) << text;
  }
}

TEST(ReadAnswer, ATextWithANotationOfItsOwnTakesAnyValueAsItsJson) {
  CallsAnswer answer;
  const std::string text = R"({"sentences":[{"id":"s1","calls":[{"function":"near"},["a"],null,"",1]}]})";
  EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty());
  EXPECT_THAT(answer.sentences(0).calls(), ElementsAre(R"({"function":"near"})", R"(["a"])", "null", "", "1"));
}

TEST(ReadAnswer, NamesMayHaveMarksNobodySees) {
  FloorObjectsAnswer answer;
  const std::string text = Object("\"zone\":\"\u200ffloor-work\",\"primary\":\"true\",\"width\\u00a0m\":2");
  EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty());
  EXPECT_EQ(answer.objects(0).zone(), "floor work");
  EXPECT_TRUE(answer.objects(0).primary());
  // What turns the rest of a line round does not get into names.
  FloorObjectsAnswer turned;
  ReadAnswer(Object(R"("name":"b\u202eed\u2028side\u0000 table")"), kZones, turned);
  EXPECT_EQ(turned.objects(0).name(), "bed side table");
}

TEST(ReadAnswer, WhatWasReadIsReadTheSameAgain) {
  // Found by the fuzzer: a text cut behind a word.
  TertiariesAnswer answer;
  const std::string members = R"("kind":"wall","count":1,"width_m":1,"depth_m":0.1,"height_m":1)";
  ReadAnswer("{\"objects\":[{\"name\":\"" + std::string(59, 'a') + " b\",\"placement\":\"There.\"," +
                 "\"description\":\"\x01\"," + members + "}]}",
             {}, answer);
  EXPECT_EQ(answer.objects(0).name(), std::string(59, 'a'));
  EXPECT_FALSE(answer.objects(0).has_description());
}

}  // namespace
}  // namespace flair::llm
