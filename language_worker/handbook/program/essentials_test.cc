// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/program/essentials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct Listed {
  v1::Brief brief;
  v1::Room room;
  v1::ZonePlan zones;
  v1::ObjectList objects;
};

Listed List(const std::string& text) {
  Listed listed;
  listed.brief.set_text(text);
  listed.room = *DescribeRoom(listed.brief, TheHandbook());
  listed.zones = *PlanZones(listed.brief, listed.room, TheHandbook());
  listed.objects = *ListObjects(listed.brief, listed.room, listed.zones, TheHandbook());
  return listed;
}

bool Serves(const hb::Essential& essential, const v1::Object& object) {
  return std::ranges::find(essential.furniture(), object.name()) != essential.furniture().end() ||
         std::ranges::find(essential.categories(), object.category()) != essential.categories().end();
}

std::vector<std::string> Missing(const v1::ObjectList& objects) {
  std::vector<std::string> messages;
  for (const v1::Diagnostic& remark : objects.diagnostics()) {
    if (remark.code() == "essential_missing") messages.push_back(remark.message());
  }
  return messages;
}

TEST(Essentials, EveryKindOfRoomNamesSome) {
  for (const hb::Archetype& room : TheHandbook().contents().archetypes()) {
    if (room.fallback() || room.name() == "practice room") continue;  // a practice room's is its instrument
    EXPECT_GT(room.essentials_size(), 0) << room.name();
  }
}

TEST(Essentials, AreInEveryRoomOfUsualSize) {
  for (const hb::Archetype& room : TheHandbook().contents().archetypes()) {
    const Listed listed = List("A " + room.name() + ".");
    EXPECT_THAT(Missing(listed.objects), IsEmpty()) << room.name();
    for (const hb::Essential& essential : room.essentials()) {
      if (essential.condition().min_area_m2() > 0) continue;
      EXPECT_TRUE(std::ranges::any_of(listed.objects.objects(),
                                      [&](const v1::Object& object) { return Serves(essential, object); }))
          << room.name() << ": " << essential.furniture(0);
    }
  }
}

// On a floor that is too small the lesser things go first: while anything else stands there, no essential is left out.
TEST(Essentials, AreLeftOutAfterEverythingElse) {
  for (const hb::Archetype& room : TheHandbook().contents().archetypes()) {
    constexpr std::array kTooLarge = {"roman bath",         "garage",        "car workshop", "gymnastics hall",
                                      "swimming pool hall", "bowling alley", "imaging room"};
    if (std::ranges::find(kTooLarge, room.name()) != kTooLarge.end()) continue;
    const v1::ObjectList objects = List("A " + room.name() + ", 2.2 m x 2.2 m.").objects;
    if (Missing(objects).empty()) continue;
    for (const v1::Object& object : objects.objects()) {
      if (object.role() == v1::OBJECT_ROLE_TERTIARY) continue;
      const bool essential =
          std::ranges::any_of(room.essentials(), [&](const auto& one) { return Serves(one, object); });
      EXPECT_TRUE(essential) << room.name() << " keeps a " << object.name() << " and lacks: " << Missing(objects)[0];
    }
  }
}

TEST(Essentials, KnownGapsAreClosed) {
  const std::pair<const char*, const char*> cases[] = {{"A bunker for a family of four.", "bunk_bed"},
                                                       {"Ein Schlafzimmer, 4 m x 4,5 m.", "bed"},
                                                       {"A tiny studio flat.", "kitchen_counter"},
                                                       {"A laundry for two dogs, 1.6 m x 2 m.", "washing_machine"},
                                                       {"A practice room for a drummer.", "drum_kit"}};
  for (const auto& [text, category] : cases) {
    const v1::ObjectList objects = List(text).objects;
    EXPECT_TRUE(std::ranges::any_of(objects.objects(), [&](const auto& one) { return one.category() == category; }))
        << text;
  }
}

TEST(Essentials, ABunkBedIsABedForEachOfTwo) {
  const auto count = [](const std::string& text, const char* category) {
    const v1::ObjectList objects = List(text).objects;
    return std::ranges::count_if(objects.objects(), [&](const auto& one) { return one.category() == category; });
  };
  const std::string two = "Children's room for a boy and a girl, 4 x 4 m, with a bunk bed and two desks.";
  EXPECT_EQ(count(two, "bunk_bed"), 1);
  EXPECT_EQ(count(two, "bed"), 0);
  const std::string three = "A room for three children with a bunk bed, 4 x 4 m.";
  EXPECT_EQ(count(three, "bunk_bed"), 1);
  EXPECT_EQ(count(three, "bed"), 1);
}

TEST(Essentials, NothingElseThatIsLargeComesWithTwoPiecesOfTheBrief) {
  const std::pair<const char*, const char*> cases[] = {
      {"A games room with a poker table and a bar cabinet.", "billiard table"},
      {"A living room with a piano and two armchairs.", "sofa"},
      {"A waiting room with a fish tank and six chairs.", "reception desk"}};
  for (const auto& [text, name] : cases) {
    const v1::ObjectList objects = List(text).objects;
    EXPECT_TRUE(std::ranges::none_of(objects.objects(), [&](const auto& one) { return one.name() == name; })) << text;
  }
  const v1::ObjectList kitchen = List("A kitchen, 5 x 4 m, with an island and a round table.").objects;
  EXPECT_TRUE(std::ranges::any_of(kitchen.objects(), [](const auto& one) { return one.name() == "kitchen counter"; }));
}

TEST(Essentials, WhatTheBriefRefusesIsToldBeforeAllElse) {
  const v1::ObjectList objects = List("A bedroom of 4 m x 5 m without a bed, with a proofing cabinet.").objects;
  ASSERT_THAT(objects.diagnostics(), Not(IsEmpty()));
  EXPECT_EQ(objects.diagnostics(0).code(), "essential_missing");
  EXPECT_EQ(objects.diagnostics(0).severity(), v1::SEVERITY_WARNING);
  EXPECT_THAT(objects.diagnostics(0).message(), HasSubstr("a bed"));
}

// Those of a model, or of somebody's own list.
TEST(Essentials, AreLookedForAmongNamesOfStrangers) {
  Listed listed = List("A bedroom that is 4m x 5m.");
  v1::ObjectList strangers;
  strangers.add_objects()->set_name("PAX wardrobe");
  ASSERT_TRUE(TellMissing(listed.brief, listed.room, TheHandbook(), strangers).ok());
  EXPECT_EQ(Missing(strangers).size(), 1U);
  strangers.clear_diagnostics();
  strangers.add_objects()->set_name("Malm bed");
  ASSERT_TRUE(TellMissing(listed.brief, listed.room, TheHandbook(), strangers).ok());
  EXPECT_THAT(Missing(strangers), IsEmpty());
}

}  // namespace
}  // namespace flair::language
