// SPDX-License-Identifier: GPL-3.0-or-later
// A model that writes all its lengths in a unit of its own is asked for metres once, then understood, and the artifact
// says so. What might be meant in two ways is not converted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "flair/model/v1/object_answers.pb.h"
#include "language_worker/service/testing/model_session.h"

namespace flair::language {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// All lengths of a value divided by `metres`, to a tenth, as people write them.
json InUnit(const json& value, double metres, const std::string& key = "") {
  if (value.is_number() && key.ends_with("_m")) return std::round(value.get<double>() / metres * 10) / 10;
  if (!value.is_structured()) return value;
  json written = value;
  for (auto& [name, member] : written.items()) member = InUnit(member, metres, value.is_array() ? key : name);
  return written;
}

std::string GoodIn(const std::string& step, double metres) {
  return InUnit(json::parse(GoodAnswers().at(step)), metres).dump();
}

template <typename WithDiagnostics>
std::vector<std::string> UnitRemarks(const WithDiagnostics& artifact) {
  std::vector<std::string> remarks;
  for (const v1::Diagnostic& diagnostic : artifact.diagnostics()) {
    if (diagnostic.code() == "unit_assumed") remarks.push_back(diagnostic.message());
  }
  return remarks;
}

// Every step about lengths in that unit, the repairs as `repair` has it.
void Script(double metres, const std::function<std::string(const std::string& step)>& repair, ModelSession& session) {
  for (const char* step : {"room", "objects.floor", "objects.tertiary"}) {
    session.model().Forget(step);
    session.model().Answer(step, GoodIn(step, metres));
    session.model().Answer(std::string(step) + "/repair", repair(step));
  }
}

class LengthUnits : public ::testing::TestWithParam<llm::LengthUnit> {};

TEST_P(LengthUnits, AnswersThatStayInThemAreConvertedAndTheArtifactsSayIt) {
  const llm::LengthUnit unit = GetParam();
  ModelSession session, metric;
  Script(
      unit.metres, [&](const std::string& step) { return GoodIn(step, unit.metres); }, session);
  for (ModelSession* each : {&session, &metric}) {
    ASSERT_TRUE(each->DescribeRoom().ok());
    ASSERT_TRUE(each->PlanZones().ok());
    ASSERT_TRUE(each->ListObjects().ok());
  }
  ASSERT_EQ(session.room().openings_size(), metric.room().openings_size());
  EXPECT_NEAR(session.room().openings(1).width_m(), metric.room().openings(1).width_m(), 0.02);
  EXPECT_THAT(UnitRemarks(session.room()), SizeIs(1));
  ASSERT_EQ(session.objects().objects_size(), metric.objects().objects_size()) << "nothing is lost";
  for (int i = 0; i < metric.objects().objects_size(); ++i) {
    const v1::Object &object = session.objects().objects(i), &wanted = metric.objects().objects(i);
    EXPECT_EQ(object.id(), wanted.id());
    EXPECT_NEAR(object.width_m(), wanted.width_m(), 0.02) << object.id();
    EXPECT_NEAR(object.depth_m(), wanted.depth_m(), 0.02) << object.id();
    EXPECT_NEAR(object.height_m(), wanted.height_m(), 0.02) << object.id();
  }
  const std::vector<std::string> remarks = UnitRemarks(session.objects());
  ASSERT_THAT(remarks, SizeIs(2));
  EXPECT_THAT(remarks[0], HasSubstr("\"objects.floor\": gives its lengths in " + std::string(unit.name)));
}

TEST_P(LengthUnits, ARepairInMetresIsTakenAsItIs) {
  ModelSession session;
  Script(
      GetParam().metres, [](const std::string& step) { return GoodAnswers().at(step); }, session);
  ASSERT_TRUE(session.DescribeRoom().ok());
  ASSERT_TRUE(session.PlanZones().ok());
  const auto objects = session.ListObjects();
  ASSERT_TRUE(objects.ok()) << objects.status();
  EXPECT_THAT(UnitRemarks(session.room()), IsEmpty());
  EXPECT_THAT(UnitRemarks(session.objects()), IsEmpty());
  EXPECT_EQ(session.objects().objects(0).width_m(), 1.6);
  EXPECT_THAT(session.model().requests()[1].messages.back().text, HasSubstr("all of them in metres would be right"));
}

TEST_P(LengthUnits, AUselessRepairLeavesTheConvertedAnswer) {
  ModelSession session;
  Script(
      GetParam().metres, [](const std::string&) { return std::string("I cannot."); }, session);
  ASSERT_TRUE(session.DescribeRoom().ok());
  ASSERT_TRUE(session.PlanZones().ok());
  const auto objects = session.ListObjects();
  ASSERT_TRUE(objects.ok()) << objects.status();
  EXPECT_NEAR(session.objects().objects(0).width_m(), 1.6, 0.02);
  EXPECT_THAT(UnitRemarks(session.objects()), SizeIs(2));
}

INSTANTIATE_TEST_SUITE_P(All, LengthUnits, ::testing::Values(llm::kLengthUnits[0], llm::kLengthUnits[2]),
                         [](const auto& info) { return std::string(info.param.name); });

// A room's worth of furniture as people write it, `share` of it in the unit and the rest in metres.
std::string RandomAnswer(double metres, double share, std::mt19937& random) {
  const auto unit = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()); };
  const auto& furniture = ModelSession::handbook().contents().furniture();
  json answer = {{"objects", json::array()}};
  const int count = 3 + static_cast<int>(random() % 8);
  while (static_cast<int>(answer["objects"].size()) < count) {
    const hb::Furniture& one = furniture[static_cast<int>(random() % static_cast<unsigned>(furniture.size()))];
    if (one.kind() != hb::FURNITURE_KIND_FLOOR && one.kind() != hb::FURNITURE_KIND_UNSPECIFIED) continue;
    const double factor = unit() < share ? metres : 1;
    const auto length = [&](const hb::Extent& extent) {
      const double low = extent.min() > 0 ? extent.min() : extent.typical();
      const double high = extent.max() > 0 ? extent.max() : extent.typical();
      return (low + unit() * (high - low)) / factor;
    };
    answer["objects"].push_back({{"name", one.name()},
                                 {"zone", "a"},
                                 {"primary", false},
                                 {"count", 1},
                                 {"width_m", length(one.width_m())},
                                 {"depth_m", length(one.depth_m())},
                                 {"height_m", length(one.height_m())},
                                 {"requested", false}});
  }
  return answer.dump();
}

// The unit that an answer is converted from; null for metres.
const llm::LengthUnit* UnitOf(const std::string& answer) {
  ModelSession session;
  session.DescribeRoom().IgnoreError();
  static const FurnitureIndex index(ModelSession::handbook());
  const FloorExtent floor = ExtentOf(session.room());
  const llm::LengthJudge judge = [&](const google::protobuf::Message& message) {
    llm::LengthEvidence evidence;
    for (const auto& object : static_cast<const model::v1::FloorObjectsAnswer&>(message).objects()) {
      evidence.Add(
          EvidenceOf({object.width_m(), object.depth_m(), object.height_m()}, index.Find(object.name()), floor));
    }
    return evidence;
  };
  return llm::ReadInClearUnit(answer, {}, model::v1::FloorObjectsAnswer::default_instance(), judge).unit;
}

TEST(LengthUnitsOfRandomRooms, MetresAndMixturesAreNeverConvertedAndNoUnitIsTakenForAnother) {
  std::mt19937 random(20);
  int converted = 0, of = 0;
  for (int round = 0; round < 60; ++round) {
    EXPECT_EQ(UnitOf(RandomAnswer(1, 1, random)), nullptr) << "round " << round;
    for (const llm::LengthUnit& unit : llm::kLengthUnits) {
      const std::string answer = RandomAnswer(unit.metres, 1, random);
      const llm::LengthUnit* const found = UnitOf(answer);
      EXPECT_TRUE(found == nullptr || found->name == unit.name) << found->name << " for " << unit.name << " " << answer;
      converted += found != nullptr ? 1 : 0;
      ++of;
    }
  }
  EXPECT_GT(converted, of * 2 / 3) << "things of odd classes alone leave it open";
}

TEST(LengthUnitsOfRandomRooms, HalfMetresHalfInchesStayAsTheyAre) {
  std::mt19937 random(21);
  for (int round = 0; round < 60; ++round) {
    const std::string answer = RandomAnswer(0.0254, 0.5, random);
    json mixed = json::parse(answer);
    // At least a third of the things on either side.
    int metric = 0;
    for (const json& object : mixed["objects"]) metric += object["width_m"].get<double>() < 5 ? 1 : 0;
    const int count = static_cast<int>(mixed["objects"].size());
    if (3 * metric <= count + 1 || 3 * (count - metric) <= count) continue;
    EXPECT_EQ(UnitOf(answer), nullptr) << answer;
  }
}

}  // namespace
}  // namespace flair::language
