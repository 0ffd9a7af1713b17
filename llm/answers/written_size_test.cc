// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/written_size.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "flair/model/v1/object_answers.pb.h"
#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using model::v1::FloorObjectAnswer;
using model::v1::FloorObjectsAnswer;

// The bed's only object of an answer with these members besides its name.
std::vector<Fault> ReadBed(const std::string& members, FloorObjectsAnswer& answer) {
  return ReadAnswer(R"({"objects":[{"name":"bed","zone":"sleeping","primary":true,"count":1,)" + members + "}]}", {},
                    answer);
}

TEST(WrittenSize, IsReadWhereItsMeaningIsPlain) {
  for (const char* members : {
           R"("dimensions": "1.6 x 2 x 0.5 m")",
           R"("size": "160x200x50 cm")",
           R"("size": "1.6m × 2m × 0.5m")",
           R"("Dimensions": "1,6 x 2,0 x 0,5")",
           R"("dimensions": "1.6 by 2 by 0.5 metres")",
           R"("dimensions_cm": "160 x 200 x 50")",
           R"("size_in_cm": [160, 200, 50])",
           R"("dimensions_m": [1.6, 2.0, 0.5])",
           R"("dims": ["1.6 m", "2 m", "50 cm"])",
           R"("size": {"w": 1.6, "d": 2, "h": 0.5})",
           R"("size": {"W": "160 cm", "L": "200 cm", "H": "50 cm"})",
           R"("w": 1.6, "d": 2, "h": 0.5)",
           R"("size": "W 1.6 m, D 2 m, H 0.5 m")",
           R"("size": "H 0.5 m x W 1.6 m x D 2 m")",
           R"("size": "1.6 m wide, 2 m deep, 0.5 m high")",
           R"("footprint": "1.6 x 2 m", "height_m": 0.5)",
           R"("size": "1600 x 2000 x 500 mm")",
           R"x("Dimensions (HxWxD)": "0.5 x 1.6 x 2 m")x",
           R"x("size_lwh": [2, 1.6, 0.5])x",
           R"("dimensions_height_width_depth": "50 x 160 x 200 cm")",
       }) {
    FloorObjectsAnswer answer;
    const std::vector<Fault> faults = ReadBed(members, answer);
    EXPECT_TRUE(faults.empty()) << members << ": " << (faults.empty() ? "" : faults[0].Sentence());
    ASSERT_EQ(answer.objects_size(), 1) << members;
    EXPECT_NEAR(answer.objects(0).width_m(), 1.6, 1e-9) << members;
    EXPECT_NEAR(answer.objects(0).depth_m(), 2, 1e-9) << members;
    EXPECT_NEAR(answer.objects(0).height_m(), 0.5, 1e-9) << members;
  }
}

TEST(WrittenSize, StaysAFaultWhereItMightMeanSomethingElse) {
  for (const char* members : {
           R"("dimensions": "1.6 m x 200 x 50")",
           R"("dimensions": "1.6 x 2 x 0.5 x 3 m")",
           R"("dimensions": "1,600 x 2,000 x 500")",
           R"("dimensions": "about the size of a door")",
           R"("dimensions": "1.2-1.6 x 2 x 0.5 m")",
           R"("dimensions": "W 1.6 x 2 x 0.5 m")",
           R"("dimensions": "W 1.6 x W 2 x H 0.5 m")",
           R"("dimensions": {"a": 1.6, "b": 2, "c": 0.5})",
           R"("dimensions": [1.6, null, 0.5])",
           R"("dimensions": [[1.6], [2], [0.5]])",
           R"("size": "queen")",
           R"x("size (HxWxD)": "1.6 x 2")x",
           R"x("size (HxWxH)": "1.6 x 2 x 0.5")x",
           R"("size": 3.2)",
       }) {
    FloorObjectsAnswer answer;
    const std::vector<Fault> faults = ReadBed(members, answer);
    EXPECT_EQ(faults.size(), 3u) << members << ": width, depth and height are asked for";
  }
}

TEST(WrittenSize, YieldsToMembersOfTheirOwn) {
  FloorObjectsAnswer answer;
  EXPECT_TRUE(ReadBed(R"("width_m":1.4,"depth_m":2,"height_m":0.5,"size":"9 x 9 x 9 m")", answer).empty());
  EXPECT_EQ(answer.objects(0).width_m(), 1.4);
}

// Numbers without any unit are those of the whole answer, as if they stood in members of their own.
TEST(WrittenSize, WithoutAUnitFollowsTheAnswersOwn) {
  const nlohmann::json bed = {{"size", "160 x 200 x 50"}};
  const auto sized = WithWrittenSize(bed, *FloorObjectAnswer::descriptor());
  ASSERT_TRUE(sized);
  EXPECT_EQ(sized->at("width_m"), "160");
  constexpr LengthUnit kCentimetres = {"centimetres", 0.01};
  FloorObjectsAnswer answer;
  const std::string text = R"({"objects":[{"name":"bed","zone":"z","count":1,"size":"160 x 200 x 50"}]})";
  const std::vector<Fault> faults = ReadAnswer(text, {}, answer, &kCentimetres);
  EXPECT_TRUE(faults.empty()) << faults[0].Sentence();
  EXPECT_NEAR(answer.objects(0).width_m(), 1.6, 1e-9);
}

}  // namespace
}  // namespace flair::llm
