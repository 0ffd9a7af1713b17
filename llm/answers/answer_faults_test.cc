// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of answers that cannot be read, and what is left of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "llm/answers/read_answer.h"
#include "llm/testing/read_answer_samples.h"

namespace flair::llm {
namespace {

using model::v1::FloorObjectsAnswer;
using model::v1::RoomAnswer;
using model::v1::ZonesAnswer;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct FaultCase {
  std::string name;
  std::string members;
  std::string fault;
};

class FaultTest : public ::testing::TestWithParam<FaultCase> {};

// The later of two members of one name counts.
TEST_P(FaultTest, SaysWhereWhatAndWhatWouldBeRight) {
  FloorObjectsAnswer answer;
  EXPECT_THAT(Sentences(ReadAnswer(Object(GetParam().members), kZones, answer)), ElementsAre(GetParam().fault));
  EXPECT_EQ(answer.objects_size(), 1) << "elements keep their places";
}

INSTANTIATE_TEST_SUITE_P(
    Members, FaultTest,
    ::testing::ValuesIn(std::vector<FaultCase>{
        {"NoNumber", R"("width_m":"very wide")",
         R"(objects[0].width_m: is "very wide"; a number in metres, 0.05 to 20 would be right)"},
        {"TooLarge", R"("width_m":160)",
         "objects[0].width_m: is 160; a number in metres, 0.05 to 20 would be right"},
        {"Negative", R"("depth_m":-2)", "objects[0].depth_m: is -2; a number in metres, 0.05 to 20 would be right"},
        {"ZeroCount", R"("count":0)", "objects[0].count: is 0; a whole number, 1 to 40 would be right"},
        {"HalfCount", R"("count":1.5)", "objects[0].count: is 1.5; a whole number, 1 to 40 would be right"},
        {"UnknownZone", R"("zone":"attic")",
         R"(objects[0].zone: is "attic"; one of "sleeping", "floor work" would be right)"},
        {"NullName", R"("name":null)", "objects[0].name: is missing; a text would be right"},
        {"EmptyName", R"("name":"  ")", R"(objects[0].name: is "  "; a text would be right)"},
        {"ListForText", R"("name":["bed","cot"])", "objects[0].name: is a list of 2; a text would be right"},
        {"ObjectForNumber", R"("height_m":{"m":1})",
         "objects[0].height_m: is an object; a number in metres, 0.01 to 12 would be right"},
        {"ThingsInANumber", R"("count":"two")",
         R"(objects[0].count: is "two"; a whole number, 1 to 40 would be right)"},
        {"ForeignUnit", R"("width_m":"5'6")",
         R"(objects[0].width_m: is "5'6"; a number in metres, 0.05 to 20 would be right)"},
        {"Range", R"("count":"2-3")", R"(objects[0].count: is "2-3"; a whole number, 1 to 40 would be right)"},
        {"ZoneInAPhrase", R"("zone":"the sleeping area")",
         R"(objects[0].zone: is "the sleeping area"; one of "sleeping", "floor work" would be right)"},
        {"WordForBool", R"("primary":"maybe")", R"(objects[0].primary: is "maybe"; true or false would be right)"},
    }),
    [](const auto& info) { return info.param.name; });

TEST(ReadAnswer, ElementsThatAreNoObjectsKeepTheirPlaces) {
  ZonesAnswer answer;
  const auto faults = ReadAnswer(R"({"zones":["sleeping",{"name":"a","purpose":"b"},null]})", {}, answer);
  EXPECT_THAT(Sentences(faults), ElementsAre(R"(zones[0]: is "sleeping"; an object with name, purpose would be right)",
                                             "zones[2]: is null; an object with name, purpose would be right"));
  EXPECT_EQ(answer.zones_size(), 3);
}

TEST(ReadAnswer, LongListsAndTextsAreCut) {
  std::string text = "{\"zones\":[";
  for (int i = 0; i < 500; ++i) text += R"({"name":"a","purpose":"b"},)";
  ZonesAnswer zones;
  EXPECT_THAT(Sentences(ReadAnswer(text + "]}", {}, zones)),
              ElementsAre("zones: has 500 elements; at most 12, the first are taken"));
  EXPECT_EQ(zones.zones_size(), 12);
  ZonesAnswer one;
  const auto faults = ReadAnswer(R"({"zones":[{"name":"a","purpose":")" + std::string(5000, 'x') + "\"}]}", {}, one);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, FaultKind::kMended);
  EXPECT_EQ(one.zones(0).purpose().size(), 300U);
}

TEST(ReadAnswer, AnEmptyListIsMissedWhereOneElementIsNeeded) {
  ZonesAnswer answer;
  EXPECT_THAT(Sentences(ReadAnswer(R"({"zones":[]})", {}, answer)), ElementsAre("zones: has 0 elements; at least 1"));
}

TEST(ReadAnswer, AnObjectWithNothingThatWasAskedForIsNoAnswer) {
  for (const std::string& text :
       std::vector<std::string>{"{}", R"({"error":{"code":529}})", R"({"error":"overloaded"})"}) {
    FloorObjectsAnswer answer;
    EXPECT_THAT(Sentences(ReadAnswer(text, kZones, answer)),
                ElementsAre("has none of what was asked for; an object with objects, left_out would be right"))
        << text;
  }
}

TEST(DropFaulty, RemovesTheElementsAndKeepsTheOthers) {
  ZonesAnswer answer;
  auto faults = ReadAnswer(R"({"zones":[{"name":"a","purpose":"1"},{"name":5,"purpose":{}},{"name":"c","purpose":"3"},
                              {"name":"d"},{"name":"e","purpose":"5"}]})",
                           {}, answer);
  EXPECT_THAT(DropFaulty(faults, answer), IsEmpty());
  ASSERT_EQ(answer.zones_size(), 3);
  EXPECT_EQ(answer.zones(1).name(), "c");
  EXPECT_EQ(answer.zones(2).name(), "e");
}

TEST(DropFaulty, ReturnsWhatIsInNoElement) {
  RoomAnswer answer;
  const auto faults = ReadAnswer(R"({"room_type":"bedroom","width_m":4,"openings":[{"kind":"hatch"}]})", {}, answer);
  const auto useless = DropFaulty(faults, answer);
  EXPECT_THAT(Sentences(useless), ElementsAre("depth_m: is missing; a number in metres, 1 to 100 would be right"));
  EXPECT_EQ(answer.openings_size(), 0);
}

TEST(DropFaulty, TakesAnyPath) {
  ZonesAnswer answer;
  answer.add_zones()->set_name("a");
  const std::vector<Fault> odd = {
      {"zones[7].name", "x"},    {"zones[-1]", "x"}, {"zones[a]", "x"}, {"nothing[0].b", "x"}, {"]", "x"},
      {"zones[0].name[3]", "x"}, {"[0]", "x"}};
  DropFaulty(odd, answer);
  EXPECT_EQ(answer.zones_size(), 1);
}

}  // namespace
}  // namespace flair::llm
