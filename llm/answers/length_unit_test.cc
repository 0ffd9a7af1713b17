// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/length_unit.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "flair/model/v1/object_answers.pb.h"
#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using Evidence = std::array<LengthEvidence, kLengthUnits.size()>;

constexpr size_t kInches = 2;

// As when ten lengths are known, none is plausible in metres, nine are in inches and `other` in feet.
const LengthUnit* WithOther(int in_metres, int in_inches, int in_feet) {
  return ClearUnit({10, in_metres}, Evidence{{{10, 0}, {10, 0}, {10, in_inches}, {10, in_feet}}});
}

TEST(ClearUnit, IsTheOnlyOneInWhichTheLengthsMakeSense) {
  EXPECT_EQ(WithOther(0, 9, 0), &kLengthUnits[kInches]);
  EXPECT_EQ(WithOther(3, 8, 4), &kLengthUnits[kInches]);
}

TEST(ClearUnit, IsNoneWhenMetresOrTwoUnitsOrNoneMakeSense) {
  EXPECT_EQ(WithOther(4, 10, 0), nullptr) << "metres";
  EXPECT_EQ(WithOther(0, 10, 5), nullptr) << "inches or feet";
  EXPECT_EQ(WithOther(0, 7, 0), nullptr) << "some of this, some of that";
  EXPECT_EQ(WithOther(0, 0, 0), nullptr);
}

TEST(ClearUnit, TakesFourKnownLengths) {
  EXPECT_EQ(ClearUnit({3, 0}, Evidence{{{3, 0}, {3, 0}, {3, 3}, {3, 0}}}), nullptr);
  EXPECT_EQ(ClearUnit({4, 0}, Evidence{{{4, 0}, {4, 0}, {4, 4}, {4, 0}}}), &kLengthUnits[kInches]);
  EXPECT_EQ(ClearUnit({}, Evidence{}), nullptr);
}

TEST(ReadAnswer, TakesLengthsWithoutAUnitInTheGivenOneAndLeavesOthers) {
  const std::string answer = R"({"objects":[{"name":"bed","zone":"a","primary":true,"count":2,
    "width_m":63,"depth_m":"200 cm","height_m":"20","requested":false}]})";
  model::v1::FloorObjectsAnswer message;
  EXPECT_TRUE(ReadAnswer(answer, {}, message, &kLengthUnits[kInches]).empty());
  EXPECT_NEAR(message.objects(0).width_m(), 1.6002, 1e-9);
  EXPECT_NEAR(message.objects(0).depth_m(), 2, 1e-9) << "it has a unit of its own";
  EXPECT_NEAR(message.objects(0).height_m(), 0.508, 1e-9);
  EXPECT_EQ(message.objects(0).count(), 2) << "no length";
}

TEST(ReadAnswer, AsksAboutThicknessesOfNothingAndTakesTheLeast) {
  model::v1::TertiariesAnswer message;
  const auto faults = ReadAnswer(R"({"objects":[{"name":"rug","kind":"floor","at":null,"count":1,"width_m":2,
    "depth_m":1.5,"height_m":0,"placement":"It lies in the middle.","requested":false}]})",
                                 {}, message);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].Sentence(),
            "objects[0].height_m: is 0; a number in metres, 0.001 to 12 would be right; taken as 0.001");
  EXPECT_EQ(faults[0].kind, FaultKind::kDoubtful);
  EXPECT_EQ(message.objects(0).height_m(), 0.001);
}

TEST(ReadAnswer, GuessesNoSecondUnitWhereOneIsGiven) {
  model::v1::FloorObjectsAnswer message;
  const auto faults = ReadAnswer(R"({"objects":[{"name":"bed","zone":"a","primary":true,"count":1,
    "width_m":6300,"depth_m":80,"height_m":20,"requested":false}]})",
                                 {}, message, &kLengthUnits[kInches]);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].Sentence(), "objects[0].width_m: is 6300; a number in metres, 0.05 to 20 would be right");
}

}  // namespace
}  // namespace flair::llm
