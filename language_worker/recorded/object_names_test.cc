// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "language_worker/recorded/recorded_text.h"

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ObjectNamesTest : public ::testing::Test {
 protected:
  ObjectNamesTest() {
    Add("desk", 1.4, 0.7, "working");
    Add("desk chair", 0.5, 0.5, "working");
    Add("bookshelf", 1.0, 0.3, "reading");
    Add("bookshelf", 0.6, 0.3, "working");
    Add("nightstand", 0.4, 0.4, "sleeping");
    Add("nightstand", 0.4, 0.4, "sleeping");
    Add("alchemy table", 1.5, 1.0, "working");
    Add("tv_stand", 1.2, 0.4, "reading");
  }
  void Add(const std::string& name, double width_m, double depth_m, const std::string& zone) {
    v1::Object& object = objects_.emplace_back();
    object.set_name(name);
    object.set_width_m(width_m);
    object.set_depth_m(depth_m);
    object.set_zone_id(zone);
    pointers_.push_back(&object);
  }
  // The objects of all mentions, in order.
  std::vector<int> Find(std::string_view text, std::string_view zone = "") const {
    std::vector<int> all;
    for (const Mention& mention : ObjectNames(pointers_).Find(text, zone)) {
      all.insert(all.end(), mention.objects.begin(), mention.objects.end());
    }
    return all;
  }

  std::deque<v1::Object> objects_;
  std::vector<const v1::Object*> pointers_;
};

TEST_F(ObjectNamesTest, TheLongestNameCounts) {
  EXPECT_THAT(Find("The Desk Chair should be before the desk."), ElementsAre(1, 0));
}

TEST_F(ObjectNamesTest, PluralsAndOtherSpellingsAreTheSame) {
  EXPECT_THAT(Find("Both nightstands, the TV-stand and bookshelves"), ElementsAre(4, 5, 7, 2, 3));
}

TEST_F(ObjectNamesTest, NoPartOfALongerWordIsAName) { EXPECT_THAT(Find("deskside desktops"), IsEmpty()); }

TEST_F(ObjectNamesTest, ASizeBehindTheNameChooses) {
  EXPECT_THAT(Find("Bookshelf (0.6m x 0.3m)"), ElementsAre(3));
  EXPECT_THAT(Find("Bookshelf - Width: 1m, Length: 0.3m"), ElementsAre(2));
  EXPECT_THAT(Find("Bookshelf (0.3m length x 0.6m width)"), ElementsAre(3));
  EXPECT_THAT(Find("the bookshelf is at least 0.6m from 0.3m"), ElementsAre(2, 3)) << "words stand between";
  EXPECT_THAT(Find("Bookshelf (7m x 9m)"), ElementsAre(2, 3)) << "no size of any";
}

TEST_F(ObjectNamesTest, ANumberBehindTheNameChooses) {
  EXPECT_THAT(Find("Nightstand 2 is on the right"), ElementsAre(5));
  EXPECT_THAT(Find("Nightstand (1)"), ElementsAre(4));
  EXPECT_THAT(Find("Nightstand 0.4m"), ElementsAre(4, 5));
  EXPECT_THAT(Find("Nightstand 9"), ElementsAre(4, 5));
}

TEST_F(ObjectNamesTest, TheZoneChoosesAmongEqualNames) {
  EXPECT_THAT(Find("the bookshelf", "working"), ElementsAre(3));
  EXPECT_THAT(Find("the bookshelf", "sleeping"), ElementsAre(2, 3));
}

TEST_F(ObjectNamesTest, AWordOfOneNameIsEnoughWhereNoNameIs) {
  const ObjectNames names(pointers_);
  const auto loose = names.FindLoosely("The Alchemical table");
  ASSERT_EQ(loose.size(), 1u);
  EXPECT_THAT(loose[0].objects, ElementsAre(6));
  EXPECT_THAT(names.FindLoosely("the chair by the table"), ::testing::SizeIs(2));
  EXPECT_THAT(names.FindLoosely("by the wall"), IsEmpty());
}

TEST_F(ObjectNamesTest, KeysOfNamesAndIdsAreEqual) {
  EXPECT_EQ(NameKey("dining chairs"), NameKey("dining_chair_3"));
  EXPECT_EQ(NameKey("Night stand"), NameKey("nightstand_12"));
  EXPECT_NE(NameKey("desk"), NameKey("desk chair"));
  EXPECT_EQ(NameKey("4 chairs"), "4chair") << "a number before the name belongs to it";
}

TEST(FindZone, FindsItAmongTheFirstWords) {
  const std::vector<std::string> zones = {"living_area", "work"};
  EXPECT_EQ(FindZone("Living Area:", zones), "living_area");
  EXPECT_EQ(FindZone("Work: Desk", zones), "work");
  EXPECT_EQ(FindZone("A place to rest after work", zones), "");
}

}  // namespace
}  // namespace flair::language
