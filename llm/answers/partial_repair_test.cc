// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/partial_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"

namespace flair::llm {
namespace {

using model::v1::FloorObjectsAnswer;
using model::v1::InterAnswer;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

FloorObjectsAnswer Objects(const std::vector<std::string>& names) {
  FloorObjectsAnswer answer;
  for (const std::string& name : names) answer.add_objects()->set_name(name);
  return answer;
}

std::vector<std::string> Names(const FloorObjectsAnswer& answer) {
  std::vector<std::string> names;
  for (const auto& object : answer.objects()) names.push_back(object.name());
  return names;
}

TEST(PartialRepair, IsOfTheElementsWithFaultsWorthAskingAbout) {
  const FloorObjectsAnswer answer = Objects({"bed", "desk", "chair"});
  const std::vector<Fault> faults = {{"objects[2].width_m", "is odd", FaultKind::kDoubtful},
                                     {"objects[0].height_m", "cut", FaultKind::kMended},
                                     {"objects[1]", "is bad"}};
  const auto elements = FaultyElements(faults, answer);
  ASSERT_TRUE(elements.has_value());
  EXPECT_THAT(*elements, ElementsAre(std::pair<const std::string, std::set<int>>("objects", {1, 2})));
}

TEST(PartialRepair, IsOfTheWholeWhenAFaultIsInNoElement) {
  const FloorObjectsAnswer answer = Objects({"bed"});
  for (const char* path : {"", "objects", "name", "objects[7].name", "objects[-1].name", "objects[x]", "none[0]",
                           "left_out[0].name", "objects[99999999999].name", "objects[0"}) {
    EXPECT_FALSE(FaultyElements(std::vector<Fault>{{"objects[0]", "is bad"}, {path, "is bad"}}, answer)) << path;
  }
  EXPECT_FALSE(FaultyElements(std::vector<Fault>{{"objects[0]", "cut", FaultKind::kMended}}, answer));
}

TEST(PartialRepair, ShowsElementsAsTheyWereWrittenAndCountsThemAnew) {
  const FloorObjectsAnswer answer = Objects({"bed", "desk", "chair", "shelf"});
  const json written =
      json::parse(R"({"objects": [{"name": "bed"}, {"name": "desk", "width_m": "wide"}, {"name": "chair"}]})");
  const Elements elements = {{"objects", {1, 3}}};
  EXPECT_EQ(PartOf(written, answer, elements), R"({"objects":[{"name":"desk","width_m":"wide"},{"name":"shelf"}]})")
      << "what was appended is as it was read";
  EXPECT_EQ(PartOf(written["objects"], answer, {{"objects", {0}}}), R"({"objects":[{"name":"bed"}]})")
      << "a list alone stands for its answer";
  const std::vector<Fault> faults = {
      {"objects[3].width_m", "is odd"}, {"objects[2].width_m", "is odd"}, {"objects", "x"}};
  const std::vector<Fault> numbered = NumberedInPart(faults, elements);
  ASSERT_EQ(numbered.size(), 1U);
  EXPECT_EQ(numbered[0].path, "objects[1].width_m");
}

TEST(PartialRepair, ElementsGoWhereTheyAreNamedInAnyOrderAndOthersStay) {
  FloorObjectsAnswer answer = Objects({"bed", "desk", "chair", "shelf"});
  FloorObjectsAnswer repair = Objects({"Shelf", "desk", "bed"});
  repair.mutable_objects(0)->set_width_m(2);
  repair.mutable_objects(2)->set_width_m(9);
  const Merged merged =
      MergeElements(repair, std::vector<Fault>{{"objects[0].depth_m", "is missing"}, {"objects[2].x", "y"}},
                    {{"objects", {1, 3}}}, answer);
  EXPECT_THAT(Names(answer), ElementsAre("bed", "desk", "chair", "Shelf"));
  EXPECT_EQ(answer.objects(3).width_m(), 2);
  EXPECT_EQ(answer.objects(0).width_m(), 0) << "what was right already is not replaced";
  ASSERT_EQ(merged.faults.size(), 1U);
  EXPECT_EQ(merged.faults[0].path, "objects[3].depth_m");
}

TEST(PartialRepair, ElementsWithNewNamesGoToWhatIsLeftAndNamelessOnesNowhere) {
  FloorObjectsAnswer answer = Objects({"bed", "grand piano", "chair"});
  MergeElements(Objects({"upright piano"}), {}, {{"objects", {1}}}, answer);
  EXPECT_THAT(Names(answer), ElementsAre("bed", "upright piano", "chair"));
  const Merged merged = MergeElements(Objects({""}), {}, {{"objects", {1}}}, answer);
  EXPECT_THAT(merged.replaced, IsEmpty());
  EXPECT_THAT(Names(answer), ElementsAre("bed", "upright piano", "chair"));
}

TEST(PartialRepair, ElementsWithoutANameGoByTheirOrder) {
  const auto pairs = [](const std::vector<std::string>& sentences) {
    InterAnswer answer;
    for (const std::string& sentence : sentences) answer.add_constraints()->add_must(sentence);
    return answer;
  };
  const auto merged = [&](const std::vector<std::string>& repair) {
    InterAnswer answer = pairs({"a", "b", "c"});
    MergeElements(pairs(repair), {}, {{"constraints", {0, 2}}}, answer);
    std::string sentences;
    for (const auto& pair : answer.constraints()) sentences += pair.must(0);
    return sentences;
  };
  EXPECT_EQ(merged({"x", "y"}), "xby");
  EXPECT_EQ(merged({"x", "y", "z"}), "xbz") << "the whole answer again";
  EXPECT_EQ(merged({"x"}), "abc");
  EXPECT_EQ(merged({}), "abc");
}

}  // namespace
}  // namespace flair::llm
