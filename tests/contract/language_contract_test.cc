// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "room/validation/validate.h"
#include "tests/contract/contract.h"

namespace flair::testing {
namespace {

using Service = v1::LanguageService::StubInterface;
using ::testing::HasSubstr;

class LanguageContract : public ::testing::Test {
 protected:
  ServerUnderTest server_{"language"};
  std::unique_ptr<v1::LanguageService::Stub> stub_ = v1::LanguageService::NewStub(server_.channel());
};

TEST_F(LanguageContract, EachStepsAnswerValidatesAndFeedsTheNext) {
  v1::DescribeRoomRequest describe;
  describe.set_request_id("r1");
  *describe.mutable_brief() = BedroomBrief();
  const auto room = Ask(*stub_, &Service::DescribeRoom, describe);
  ASSERT_TRUE(room.ok()) << room.status();
  EXPECT_TRUE(Validate(room->room()).ok()) << Validate(room->room());
  EXPECT_NE(room->producer().program(), "");
  EXPECT_NE(room->producer().method(), "");

  v1::PlanZonesRequest plan;
  plan.set_request_id("r2");
  *plan.mutable_brief() = BedroomBrief();
  *plan.mutable_room() = room->room();
  const auto zones = Ask(*stub_, &Service::PlanZones, plan);
  ASSERT_TRUE(zones.ok()) << zones.status();
  EXPECT_TRUE(Validate(zones->zone_plan()).ok()) << Validate(zones->zone_plan());

  v1::ListObjectsRequest list;
  list.set_request_id("r3");
  *list.mutable_brief() = BedroomBrief();
  *list.mutable_room() = room->room();
  *list.mutable_zone_plan() = zones->zone_plan();
  const auto objects = Ask(*stub_, &Service::ListObjects, list);
  ASSERT_TRUE(objects.ok()) << objects.status();
  EXPECT_TRUE(Validate(objects->object_list(), zones->zone_plan()).ok())
      << Validate(objects->object_list(), zones->zone_plan());

  v1::ChooseStyleRequest choose;
  choose.set_request_id("r4");
  *choose.mutable_brief() = BedroomBrief();
  *choose.mutable_room() = room->room();
  *choose.mutable_zone_plan() = zones->zone_plan();
  *choose.mutable_object_list() = objects->object_list();
  const auto style = Ask(*stub_, &Service::ChooseStyle, choose);
  ASSERT_TRUE(style.ok()) << style.status();
  EXPECT_TRUE(Validate(style->style_sheet(), room->room(), objects->object_list()).ok());

  v1::ListConstraintsRequest constraints;
  constraints.set_request_id("r5");
  *constraints.mutable_brief() = BedroomBrief();
  *constraints.mutable_room() = room->room();
  *constraints.mutable_zone_plan() = zones->zone_plan();
  *constraints.mutable_object_list() = objects->object_list();
  const auto sentences = Ask(*stub_, &Service::ListConstraints, constraints);
  ASSERT_TRUE(sentences.ok()) << sentences.status();
  EXPECT_TRUE(Validate(sentences->constraint_list(), objects->object_list()).ok());

  v1::CleanConstraintsRequest clean;
  clean.set_request_id("r6");
  *clean.mutable_room() = room->room();
  *clean.mutable_object_list() = objects->object_list();
  *clean.mutable_constraint_list() = sentences->constraint_list();
  const auto cleaned = Ask(*stub_, &Service::CleanConstraints, clean);
  ASSERT_TRUE(cleaned.ok()) << cleaned.status();
  EXPECT_TRUE(Validate(cleaned->constraint_list(), objects->object_list()).ok());
}

TEST_F(LanguageContract, TheSameRequestGetsTheSameAnswer) {
  v1::DescribeRoomRequest request;
  *request.mutable_brief() = BedroomBrief();
  request.set_request_id("first");
  const auto first = Ask(*stub_, &Service::DescribeRoom, request);
  request.set_request_id("second");
  const auto second = Ask(*stub_, &Service::DescribeRoom, request);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first->SerializeAsString(), second->SerializeAsString());
}

TEST_F(LanguageContract, ABadBriefIsInvalidArgumentAndNamesTheField) {
  const auto answer = Ask(*stub_, &Service::DescribeRoom, v1::DescribeRoomRequest());
  EXPECT_EQ(answer.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(answer.status().message()), HasSubstr("brief.text"));
}

TEST_F(LanguageContract, AGivenRoomIsKept) {
  v1::DescribeRoomRequest request;
  *request.mutable_brief() = BedroomBrief();
  *request.mutable_brief()->mutable_room() = BedroomRoom();
  const auto answer = Ask(*stub_, &Service::DescribeRoom, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->room().floor().SerializeAsString(), BedroomRoom().floor().SerializeAsString());
}

}  // namespace
}  // namespace flair::testing
