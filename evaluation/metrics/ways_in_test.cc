// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/testing/furnished.h"

namespace flair::evaluation {
namespace {

constexpr char kRoom[] = "4x5 room; door south 1 0.9; bed 1.6x2 at 2,3.9,180 seat; ";

TEST(UsesOfWays, OneGetsIntoTheRoomAndToTheBed) {
  const UsesOfWays uses = FindUsesOfWays(Furnished(kRoom).view());
  EXPECT_EQ(uses.asked, 2);
  EXPECT_EQ(uses.met, 2);
  EXPECT_TRUE(uses.unmet.empty());
}

TEST(UsesOfWays, ABlockedDoorIsToldAloneWithWhatIsInItsWay) {
  const UsesOfWays uses = FindUsesOfWays(Furnished(std::string(kRoom) + "crate 1.2x0.8 at 1.45,0.6,0").view());
  EXPECT_EQ(uses.asked, 2);
  EXPECT_EQ(uses.met, 0);
  ASSERT_EQ(uses.unmet.size(), 1u);
  EXPECT_EQ(uses.unmet[0].message(), "nobody gets into the room: the crate is in the way of the door");
  EXPECT_EQ(uses.unmet[0].object_id(), "crate");
}

TEST(UsesOfWays, ABedThatNobodyGetsToIsToldWithWhatIsInTheWay) {
  const UsesOfWays uses = FindUsesOfWays(Furnished(std::string(kRoom) + "shelf 3.5x0.4 at 1.75,2,180").view());
  EXPECT_EQ(uses.asked, 2);
  EXPECT_EQ(uses.met, 1);
  ASSERT_EQ(uses.unmet.size(), 1u);
  EXPECT_EQ(uses.unmet[0].message(), "nobody gets to the bed: the shelf is in the way");
  EXPECT_EQ(uses.unmet[0].object_id(), "bed");
  EXPECT_EQ(uses.unmet[0].partner_id(), "shelf");
}

}  // namespace
}  // namespace flair::evaluation
