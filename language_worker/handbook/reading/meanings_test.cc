// SPDX-License-Identifier: GPL-3.0-or-later
// What WordNet tells of nouns that the handbook does not list.
#include "language_worker/handbook/reading/meanings.h"

#include <gtest/gtest.h>

#include <string>

#include "language_worker/handbook/reading/vocabulary.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

const Meanings& TheMeanings() { return *TheHandbook().vocabulary().meanings; }

std::string LikeOf(const char* noun) {
  const Thing thing = TheMeanings().ThingOf(noun);
  return thing.like == nullptr ? thing.is_thing ? "a thing" : "no thing" : thing.like->name();
}

TEST(Meanings, AThingIsMadeLikeItsKin) {
  EXPECT_EQ(LikeOf("honey extractor"), "plain machine");
  EXPECT_EQ(LikeOf("zither"), "plain musical instrument");
  EXPECT_EQ(LikeOf("hive boxes"), "plain chest");
  EXPECT_EQ(LikeOf("overalls"), "plain garments");
  EXPECT_EQ(LikeOf("lemon tree"), "floor plant");
  EXPECT_EQ(LikeOf("mangle"), "plain machine");
  EXPECT_EQ(LikeOf("astrolabe"), "plain implement");
}

TEST(Meanings, PartsOfTheRoomStuffsAndMoodsAreNoThings) {
  for (const char* noun : {"wall", "corner", "velvet", "atmosphere", "view", "gardener", "afternoon", "brick floor"}) {
    EXPECT_EQ(LikeOf(noun), "no thing") << noun;
  }
  EXPECT_FALSE(TheMeanings().ThingOf("gloop").known);
}

TEST(Meanings, KindsOfRoomAreTheirKin) {
  const auto room_of = [](const char* noun) {
    const hb::Archetype* room = TheMeanings().RoomOf(noun);
    return room == nullptr ? "" : room->name();
  };
  EXPECT_EQ(room_of("triclinium"), "dining room");
  EXPECT_EQ(room_of("haberdashery"), "shop");
  EXPECT_EQ(room_of("museum"), "art gallery");
  EXPECT_EQ(room_of("velvet"), "");
  EXPECT_EQ(TheMeanings().RoomFor("breakfast")->name(), "dining room");
  EXPECT_EQ(TheMeanings().RoomFor("gloop"), nullptr);
}

TEST(Meanings, PeopleAreToldFromThings) {
  EXPECT_TRUE(MeansPeople("gardeners"));
  EXPECT_TRUE(MeansPeople("children"));
  EXPECT_FALSE(MeansPeople("computers"));
  EXPECT_FALSE(MeansPeople("flowers"));
}

}  // namespace
}  // namespace flair::language
