// SPDX-License-Identifier: GPL-3.0-or-later
// What is read of an answer, and what else certainly means the same.
#include "llm/answers/read_answer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/model/v1/style_answers.pb.h"
#include "llm/answers/read_answer_samples.h"

namespace flair::llm {
namespace {

using model::v1::CallsAnswer;
using model::v1::FloorObjectsAnswer;
using model::v1::IntraAnswer;
using model::v1::RoomAnswer;
using model::v1::StyleAnswer;
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
  const std::string text = R"({"Objects":{"Name":" work\n bench ","zone":"Floor-Work","primary":"yes","count":"two",
      "width":"120 cm","DepthM":"2 ft","height_m":"0.9","requested":0}})";
  EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty());
  ASSERT_EQ(answer.objects_size(), 1);
  EXPECT_EQ(answer.objects(0).name(), "work bench");
  EXPECT_EQ(answer.objects(0).zone(), "floor work");
  EXPECT_TRUE(answer.objects(0).primary());
  EXPECT_EQ(answer.objects(0).count(), 2);
  EXPECT_NEAR(answer.objects(0).width_m(), 1.2, 1e-12);
  EXPECT_NEAR(answer.objects(0).depth_m(), 0.6096, 1e-12);
}

TEST(ReadAnswer, ARootMayBeWrappedOrBeItsOnlyList) {
  for (const std::string& text :
       std::vector<std::string>{R"({"zones_answer":{"zones":[{"name":"a","purpose":"b"}]}})",
                                R"({"notes":"Done.","plan":{"zones":[{"name":"a","purpose":"b"}]},"x":{"y":1}})",
                                R"([{"name":"a","purpose":"b"}])", R"({"zones":{"name":"a","purpose":"b"}})"}) {
    ZonesAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty()) << text;
    EXPECT_EQ(answer.zones_size(), 1) << text;
  }
}

TEST(ReadAnswer, AListMayBeByNamesGroupedOrAlone) {
  const std::string bed = R"("width_m":1.6,"depth_m":2,"height_m":0.5)";
  for (const std::string& text : std::vector<std::string>{
           R"([{"name":"bed","zone":"sleeping",)" + bed + "}]",
           R"({"name":"bed","zone":"sleeping",)" + bed + "}",
           R"({"objects":{"bed":{"zone":"sleeping",)" + bed + "}}}",
           R"({"objects":{"sleeping":[{"name":"bed",)" + bed + "}]}}",
           R"({"sleeping":[{"name":"bed",)" + bed + "}]}",
           R"({"note":"For you.","furniture":[{"name":"bed","zone":"sleeping",)" + bed + "}]}",
           R"({"result":{"answer":{"objects":[{"name":"bed","zone":"sleeping",)" + bed + "}]}}}",
           std::string(R"({"answer":"{\"objects\":[{\"name\":\"bed\",\"zone\":\"sleeping\",\"width_m\":1.6,)"
                       R"(\"depth_m\":2,\"height_m\":0.5}]}"})"),
       }) {
    FloorObjectsAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), ElementsAre("objects[0].count: is missing; taken as 1"))
        << text;
    ASSERT_EQ(answer.objects_size(), 1) << text;
    EXPECT_EQ(answer.objects(0).name(), "bed") << text;
    EXPECT_EQ(answer.objects(0).zone(), "sleeping") << text;
    EXPECT_EQ(answer.objects(0).count(), 1) << text;
    EXPECT_EQ(answer.objects(0).width_m(), 1.6) << text;
  }
}

TEST(ReadAnswer, SizesMayBeApartInOtherUnitsAndUnderOtherNames) {
  for (
      const std::string size :
      {R"("size":{"width":1.6,"depth":2,"height":0.5})", R"("width_cm":160,"length_cm":200,"height_cm":50)",
       R"x("width_mm":"1600","Length":"200cm","Height (m)":".5")x",
       R"("width_m":{"value":160,"unit":"cm"},"depth_m":{"unit":"m","value":"2"},"height_m":{"value":0.5,"unit":"metres"})"}) {
    FloorObjectsAnswer answer;
    const std::string text = R"({"objects":[{"name":"bed","zone":"the sleeping area","quantity":1,)" + size + "}]}";
    EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty()) << text;
    EXPECT_EQ(answer.objects(0).zone(), "sleeping");
    EXPECT_NEAR(answer.objects(0).width_m(), 1.6, 1e-12);
    EXPECT_NEAR(answer.objects(0).depth_m(), 2, 1e-12);
    EXPECT_NEAR(answer.objects(0).height_m(), 0.5, 1e-12);
  }
}

TEST(ReadAnswer, ANumberThatNeedNotBeThereMayBeSaidNotToBe) {
  for (const char* word : {"N/A", "none", "", " - ", "Unknown"}) {
    FloorObjectsAnswer answer;
    const auto faults = ReadAnswer(fmt::format(R"({{"objects":[{{"name":"bed","zone":"sleeping","count":"{0}",)"
                                               R"("width_m":1.6,"depth_m":2,"height_m":"{0}"}}]}})",
                                               word),
                                   kZones, answer);
    EXPECT_EQ(answer.objects(0).count(), 1) << word;
    EXPECT_THAT(Sentences(faults), ElementsAre(HasSubstr("count: is missing; taken as 1"),
                                               HasSubstr("height_m: is \"" + std::string(word))));
  }
}

TEST(ReadAnswer, ValuesMayBeDressedUp) {
  FloorObjectsAnswer answer;
  const std::string text = R"({"objects":[{"🛏️ name":["bed"],"zone":["Sleeping"],"count":"2x","📏 width":[1.6],)"
                           R"("depth_m":["200 cm"],"height_m":0.5,"description":"None"}]})";
  EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty());
  EXPECT_EQ(answer.objects(0).name(), "bed");
  EXPECT_EQ(answer.objects(0).zone(), "sleeping");
  EXPECT_EQ(answer.objects(0).count(), 2);
  EXPECT_EQ(answer.objects(0).width_m(), 1.6);
  EXPECT_EQ(answer.objects(0).depth_m(), 2);
  EXPECT_FALSE(answer.objects(0).has_description());
  const std::string several = R"({"objects":[{"name":"bed","zone":"sleeping","count":1,"width_m":[1.6,2],"depth_m":2,)"
                              R"("height_m":0.5}]})";
  EXPECT_THAT(Sentences(ReadAnswer(several, kZones, answer)), ElementsAre(HasSubstr("width_m: is a list of 2")));
}

TEST(ReadAnswer, LinesWithoutAnyJsonAreReadWhereLinesWereAskedFor) {
  const FieldChoices ids = {{"flair.model.v1.SentenceCallsAnswer.id", {{"s1", "s2"}, {}}}};
  CallsAnswer calls;
  const auto faults = ReadAnswer("Here you are:\ns1: near(a, b)\n- **s2**: none(light)\nNote: done.", ids, calls);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, FaultKind::kMended);
  ASSERT_EQ(calls.sentences_size(), 2);
  EXPECT_THAT(calls.sentences(1).calls(), ElementsAre("none(light)"));
  CallsAnswer none;
  EXPECT_THAT(Sentences(ReadAnswer("Sorry: I cannot.", ids, none)), ElementsAre(HasSubstr("has no JSON")));
}

TEST(ReadAnswer, AnElementMayBeALine) {
  const FieldChoices ids = {{"flair.model.v1.SentenceCallsAnswer.id", {{"s1", "s2"}, {}}}};
  for (const std::string& text : std::vector<std::string>{
           R"x({"sentences":["s1: near(a, b)","s2: none(why: light)"]})x",
           R"x(["- s1 = near(a, b)","[s2] none(why: light)"])x",
           R"x({"sentences":[{"id":"s1","calls":["near(a, b)"]},"S2 none(why: light)"]})x",
           R"x({"sentences":{"s1":"near(a, b)","s2":["none(why: light)"]}})x",
           R"x({"sentences":"s1: near(a, b)\n\n\"s2\": none(why: light)"})x",
           R"x({"sentences":["{\"id\":\"s1\",\"calls\":[\"near(a, b)\"]}","s2: none(why: light)"]})x",
           R"x({"sentences":"[\"s1: near(a, b)\",\"s2: none(why: light)\"]"})x"}) {
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

TEST(ReadAnswer, AnElementMayBeATextAboutIt) {
  for (
      const std::string& text : std::vector<std::string>{
          R"({"zones":["sleeping: bed and rest","work - a desk"]})",
          R"({"zones":"[{\"name\":\"sleeping\",\"purpose\":\"bed and rest\"},{\"name\":\"work\",\"purpose\":\"a desk\"}]"})",
          R"({"zones":["{\"name\":\"sleeping\",\"purpose\":\"bed and rest\"}","work — a desk"]})"}) {
    ZonesAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty()) << text;
    ASSERT_EQ(answer.zones_size(), 2) << text;
    EXPECT_EQ(answer.zones(0).name(), "sleeping") << text;
    EXPECT_EQ(answer.zones(0).purpose(), "bed and rest") << text;
    EXPECT_EQ(answer.zones(1).purpose(), "a desk") << text;
  }
}

TEST(ReadAnswer, TextsMayBeInObjectsOrInLines) {
  const FieldChoices objects = {{"flair.model.v1.ObjectSentencesAnswer.object", {{"bed", "desk"}, {}}}};
  for (const std::string& text : std::vector<std::string>{
           R"({"objects":[{"object":{"id":"bed"},"must":[{"text":"It is a."},{"sentence":"It is b.","why":"so"}]}]})",
           R"({"objects":[{"object":"bed","must":"- It is a.\n- It is b.\n"}]})",
           R"({"objects":[{"object":"bed","must":"1. It is a.\n\n2) It is b."}]})",
           R"({"objects":[{"object":["bed"],"must":[{"type":"string","value":"It is a."},{"only":"It is b."}]}]})"}) {
    IntraAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, objects, answer)), IsEmpty()) << text;
    ASSERT_EQ(answer.objects_size(), 1) << text;
    EXPECT_EQ(answer.objects(0).object(), "bed") << text;
    EXPECT_THAT(answer.objects(0).must(), ElementsAre("It is a.", "It is b.")) << text;
  }
}

TEST(ReadAnswer, ASchemaMayBeFilledIn) {
  RoomAnswer answer;
  const std::string text = R"({"type":"object","properties":{"room_type":{"type":"string","value":"bedroom"},)"
                           R"("width_m":{"type":"number","value":4},"depth_m":{"value":"5 m","description":"d"}}})";
  EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty());
  EXPECT_EQ(answer.room_type(), "bedroom");
  EXPECT_EQ(answer.width_m(), 4);
  EXPECT_EQ(answer.depth_m(), 5);
}

TEST(ReadAnswer, AListMayBeInPartsByItsKinds) {
  RoomAnswer answer;
  const std::string text = R"({"room_type":"bedroom","width_m":4,"depth_m":5,"height_m":null,)"
                           R"("doors":[{"wall":"south","position":"center","width_m":0.9}],)"
                           R"("windows":[{"wall":"North wall","position":"25%","width_m":1.2},)"
                           R"({"wall":"east","position":0.5,"width_m":1}],"sockets":[]})";
  EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty());
  ASSERT_EQ(answer.openings_size(), 3);
  EXPECT_EQ(answer.openings(0).kind(), "door");
  EXPECT_EQ(answer.openings(0).position(), 0.5);
  EXPECT_EQ(answer.openings(1).kind(), "window");
  EXPECT_EQ(answer.openings(1).wall(), "north");
  EXPECT_EQ(answer.openings(1).position(), 0.25);
}

TEST(ReadAnswer, AUnitMayBeSaidOnce) {
  const std::string bed = R"("name":"bed","zone":"sleeping","count":1,"width":160,"depth":200,"height":50)";
  for (const std::string& text : std::vector<std::string>{R"({"units":"cm","objects":[{)" + bed + "}]}",
                                                          R"({"objects":[{"unit":"Centimetres",)" + bed + "}]}"}) {
    FloorObjectsAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty()) << text;
    EXPECT_NEAR(answer.objects(0).width_m(), 1.6, 1e-12) << text;
    EXPECT_NEAR(answer.objects(0).height_m(), 0.5, 1e-12) << text;
  }
  // Of that object alone.
  FloorObjectsAnswer two;
  const std::string metres = R"("name":"bed","zone":"sleeping","count":1,"width":1.6,"depth":2,"height":0.5)";
  const std::string text = R"({"objects":[{"unit":"cm",)" + bed + "},{" + metres + "}]}";
  EXPECT_THAT(Sentences(ReadAnswer(text, kZones, two)), IsEmpty());
  EXPECT_EQ(two.objects(1).width_m(), 1.6);
}

TEST(ReadAnswer, ACallIsItsArguments) {
  for (const std::string arguments : {"arguments", "parameters", "input"}) {
    StyleAnswer answer;
    const std::string text = R"({"name":"choose_style",")" + arguments +
                             R"(":{"name":"calm","summary":"Oak.","palette":[],"surfaces":[],"looks":[]}})";
    EXPECT_THAT(Sentences(ReadAnswer(text, {}, answer)), IsEmpty()) << text;
    EXPECT_EQ(answer.name(), "calm");
    EXPECT_EQ(answer.summary(), "Oak.");
  }
}

TEST(ReadAnswer, ARangeIsTakenAndTold) {
  FloorObjectsAnswer answer;
  EXPECT_THAT(Sentences(ReadAnswer(Object(R"("count":"2-3","width_m":"1.4 to 1.8 m")"), kZones, answer)),
              ElementsAre(R"(objects[0].count: is "2-3"; one number would be right; taken as 2)",
                          R"(objects[0].width_m: is "1.4 to 1.8 m"; one number would be right; taken as 1.6)"));
  EXPECT_EQ(answer.objects(0).count(), 2);
  EXPECT_NEAR(answer.objects(0).width_m(), 1.6, 1e-12);
}

TEST(ReadAnswer, NamesMayHaveMarksNobodySeesAndOtherHyphens) {
  FloorObjectsAnswer answer;
  const std::string text = Object("\"zone\":\"\u200ffloor\u2011work\",\"primary\":\"1\",\"width\\u00a0m\":2");
  EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)), IsEmpty());
  EXPECT_EQ(answer.objects(0).zone(), "floor work");
  EXPECT_TRUE(answer.objects(0).primary());
  // What turns the rest of a line round does not get into names.
  FloorObjectsAnswer turned;
  ReadAnswer(Object(R"("name":"b\u202eed\u2028side\u0000 table")"), kZones, turned);
  EXPECT_EQ(turned.objects(0).name(), "bed side table");
}

TEST(ReadAnswer, WhatWasReadIsReadTheSameAgain) {
  // Found by the fuzzer: a text cut behind a word, and one that says nothing but for a control character.
  TertiariesAnswer answer;
  const std::string members = R"("kind":"wall","count":1,"width_m":1,"depth_m":0.1,"height_m":1)";
  ReadAnswer("{\"objects\":[{\"name\":\"" + std::string(59, 'a') + " b\",\"placement\":\"There.\"," +
                 "\"description\":\"\x01null\"," + members + "}]}",
             {}, answer);
  EXPECT_EQ(answer.objects(0).name(), std::string(59, 'a'));
  EXPECT_FALSE(answer.objects(0).has_description());
}

}  // namespace
}  // namespace flair::llm
