// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "language_worker/service/make_language_service.h"
#include "language_worker/service/testing/model_session.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using ::testing::HasSubstr;

// A bedroom as the handbook has it, to bring in briefs.
struct Bedroom {
  Bedroom() : handlers(ModelSession::handbook()) {
    brief.set_text("A bedroom that is 4m x 5m.");
    room = handlers.Handle(Ask<v1::DescribeRoomRequest>(), call)->room();
    zones = handlers.Handle(Ask<v1::PlanZonesRequest>(), call)->zone_plan();
    objects = handlers.Handle(Ask<v1::ListObjectsRequest>(), call)->object_list();
  }

  template <typename Request>
  Request Ask() const {
    Request request;
    *request.mutable_brief() = brief;
    if constexpr (requires { request.mutable_room(); }) *request.mutable_room() = room;
    if constexpr (requires { request.mutable_zone_plan(); }) *request.mutable_zone_plan() = zones;
    if constexpr (requires { request.mutable_object_list(); }) *request.mutable_object_list() = objects;
    return request;
  }

  LanguageHandlers handlers;
  runtime::CallContext call;
  v1::Brief brief;
  v1::Room room;
  v1::ZonePlan zones;
  v1::ObjectList objects;
};

TEST(HandbookAnswers, ABriefsOwnPartsComeBackAsTheyAre) {
  Bedroom bedroom;
  v1::ObjectList own = bedroom.objects;
  own.mutable_objects(0)->set_name("box bed");
  *bedroom.brief.mutable_object_list() = own;
  const auto objects = bedroom.handlers.Handle(bedroom.Ask<v1::ListObjectsRequest>(), bedroom.call);
  ASSERT_TRUE(objects.ok()) << objects.status();
  EXPECT_EQ(objects->object_list().SerializeAsString(), own.SerializeAsString());
  EXPECT_EQ(objects->producer().method(), "brief");
  v1::Sentence& sentence = *bedroom.brief.mutable_constraint_list()->add_sentences();
  sentence.set_id("mine");
  sentence.set_text("The box bed is in a corner.");
  sentence.set_scope(v1::SENTENCE_SCOPE_INTRA);
  sentence.set_weight(3);
  const auto constraints = bedroom.handlers.Handle(bedroom.Ask<v1::ListConstraintsRequest>(), bedroom.call);
  ASSERT_TRUE(constraints.ok()) << constraints.status();
  EXPECT_EQ(constraints->constraint_list().sentences(0).id(), "mine");
  sentence.add_subject_ids("piano");
  const auto refused = bedroom.handlers.Handle(bedroom.Ask<v1::ListConstraintsRequest>(), bedroom.call);
  EXPECT_EQ(refused.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(refused.status().message(), HasSubstr("brief.constraint_list.sentences[0].subject_ids[0]: \"piano\""));
}

TEST(HandbookAnswers, OwnConstraintsLeaveTheTertiariesTheirPlaces) {
  Bedroom bedroom;
  v1::Sentence& sentence = *bedroom.brief.mutable_constraint_list()->add_sentences();
  sentence.set_id("t1");
  sentence.set_text("The double bed is in a corner.");
  sentence.set_scope(v1::SENTENCE_SCOPE_INTRA);
  sentence.set_weight(1);
  const auto constraints = bedroom.handlers.Handle(bedroom.Ask<v1::ListConstraintsRequest>(), bedroom.call);
  ASSERT_TRUE(constraints.ok()) << constraints.status();
  const v1::ConstraintList& list = constraints->constraint_list();
  EXPECT_EQ(list.sentences(0).id(), "t1");
  EXPECT_EQ(list.diagnostics(0).code(), "placements_added");
  int tertiaries = 0;
  for (const v1::Object& object : bedroom.objects.objects()) tertiaries += object.role() == v1::OBJECT_ROLE_TERTIARY;
  EXPECT_GE(list.sentences_size(), tertiaries);
  for (int i = 1; i < list.sentences_size(); ++i) EXPECT_EQ(list.sentences(i).scope(), v1::SENTENCE_SCOPE_TERTIARY);
  EXPECT_TRUE(Validate(list, bedroom.objects).ok());
}

TEST(HandbookAnswers, ZonesOfOwnObjectsArePlanned) {
  Bedroom bedroom;
  v1::ObjectList own = bedroom.objects;
  for (v1::Object& object : *own.mutable_objects()) object.set_zone_id("music");
  *bedroom.brief.mutable_object_list() = own;
  const auto zones = bedroom.handlers.Handle(bedroom.Ask<v1::PlanZonesRequest>(), bedroom.call);
  ASSERT_TRUE(zones.ok()) << zones.status();
  const v1::ZonePlan& plan = zones->zone_plan();
  EXPECT_EQ(plan.zones(plan.zones_size() - 1).id(), "music");
  EXPECT_EQ(plan.diagnostics(plan.diagnostics_size() - 1).code(), "zone_of_objects");
}

TEST(HandbookAnswers, PlacementsOfTheListerReplaceTheHandbooks) {
  Bedroom bedroom;
  const auto before = bedroom.handlers.Handle(bedroom.Ask<v1::ListConstraintsRequest>(), bedroom.call);
  ASSERT_TRUE(before.ok()) << before.status();
  std::string placed;
  for (v1::Object& object : *bedroom.objects.mutable_objects()) {
    if (object.role() != v1::OBJECT_ROLE_TERTIARY || !placed.empty()) continue;
    placed = object.id();
    object.set_placement("It goes to the far end of the room.");
  }
  const auto after = bedroom.handlers.Handle(bedroom.Ask<v1::ListConstraintsRequest>(), bedroom.call);
  ASSERT_TRUE(after.ok()) << after.status();
  int about = 0;
  for (const v1::Sentence& sentence : after->constraint_list().sentences()) {
    if (sentence.subject_ids().empty() || sentence.subject_ids(0) != placed) continue;
    ++about;
    EXPECT_EQ(sentence.text(), "It goes to the far end of the room.");
  }
  EXPECT_EQ(about, 1);
  EXPECT_EQ(after->constraint_list().sentences_size(), before->constraint_list().sentences_size());
}

}  // namespace
}  // namespace flair::language
