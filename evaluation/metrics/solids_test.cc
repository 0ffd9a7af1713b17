// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/testing/furnished.h"

namespace flair::evaluation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

SolidMeasures Of(const std::string& text) { return MeasureSolids(Furnished(text).view()); }

std::vector<std::string> Messages(const std::string& text) {
  std::vector<std::string> messages;
  for (const v1::Finding& finding : Of(text).findings) messages.push_back(finding.message());
  return messages;
}

// A room of 60 m3.
const char kRoom[] = "4x5 room; ";

TEST(Solids, OverlapIsTheVolumeThatTwoPiecesShare) {
  // Half of one, 0.5 m wide, up to the lower one's top of 0.4 m.
  const SolidMeasures found =
      Of(std::string(kRoom) + "a 1x1 at 2,2,0 height 0.4; b 1x1 at 2.5,2,0 height 2; c 1x1 at 3.5,2,0 height 2");
  EXPECT_NEAR(found.overlap_m3, 0.5 * 1 * 0.4, 1e-12);
  EXPECT_NEAR(found.deepest_m, 0.4, 1e-12) << "the shortest push is upwards";
  ASSERT_EQ(found.findings.size(), 1u);
  EXPECT_EQ(found.findings[0].kind(), v1::FINDING_KIND_OVERLAP);
  EXPECT_EQ(found.findings[0].object_id(), "b");
  EXPECT_EQ(found.findings[0].partner_id(), "a");
  EXPECT_EQ(found.findings[0].message(), "the b and the a overlap by 0.40 m");
}

TEST(Solids, PieceOnAWallIsFoundInWhatStandsBeforeIt) {
  const std::string rail = std::string(kRoom) + "rail 0.6x0.1 at 1,0.05,0 wall tertiary height 1 elevation 0.9; ";
  EXPECT_THAT(Messages(rail + "shower 0.9x0.9 at 1,0.45,0 height 2"),
              ElementsAre("the rail and the shower overlap by 0.10 m"));
  EXPECT_THAT(Messages(rail + "tub 0.9x0.9 at 1,0.45,0 height 0.5"), IsEmpty());
}

TEST(Solids, LampOnALowTableIsFoundInTheShelfAboveIt) {
  const std::string table = std::string(kRoom) + "table 1x0.6 at 2,0.3,0 height 0.5; ";
  const std::string shelf = "shelf 1x0.3 at 2,0.15,0 wall tertiary height 0.3 elevation 0.8; ";
  EXPECT_THAT(Messages(table + shelf + "lamp 0.2x0.2 at 2,0.1,0 surface tertiary height 0.5 on table"),
              ElementsAre("the lamp and the shelf overlap by 0.20 m"));
  EXPECT_THAT(Messages(table + shelf + "lamp 0.2x0.2 at 2,0.45,0 surface tertiary height 0.5 on table"), IsEmpty());
  // Nobody says what it stands on; the table is under it.
  EXPECT_THAT(Messages(table + shelf + "lamp 0.2x0.2 at 2,0.1,0 surface tertiary height 0.5"),
              ElementsAre("the lamp and the shelf overlap by 0.20 m"));
}

TEST(Solids, BooksAreInTheirBookcaseAndInNothingElse) {
  const std::string bookcase = std::string(kRoom) + "bookcase 1x0.4 at 2,0.2,0 height 2; ";
  EXPECT_THAT(Messages(bookcase + "books 0.4x0.2 at 2,0.2,0 surface tertiary height 0.3 elevation -1 on bookcase"),
              IsEmpty());
  EXPECT_THAT(Messages(bookcase + "art 0.4x0.1 at 2,0.05,0 wall tertiary height 0.3 elevation 1"),
              ElementsAre("the art and the bookcase overlap by 0.10 m"));
}

TEST(Solids, SeatReachesUnderATopAsFarAsKneesDo) {
  const std::string table = std::string(kRoom) + "table 1x0.8 at 2,2,0 height 0.75; ";
  // Its front is at y = 1.6 + reach, below the table's edge at 1.6.
  EXPECT_THAT(Messages(table + "chair 0.5x0.5 at 2,1.6,0 height 0.9"), IsEmpty());
  EXPECT_THAT(Messages(table + "chair 0.5x0.5 at 2,1.7,0 height 0.9"),
              ElementsAre("the chair and the table overlap by 0.35 m"));
  EXPECT_THAT(Messages(table + "chair 0.5x0.5 at 2,1.6,180 height 0.9"),
              ElementsAre("the chair and the table overlap by 0.25 m"))
      << "its back is no seat";
  EXPECT_THAT(Messages(std::string(kRoom) + "bed 1x0.8 at 2,2,0 height 0.5; chair 0.5x0.5 at 2,1.6,0 height 0.9"),
              ElementsAre("the chair and the bed overlap by 0.25 m"));
}

TEST(Solids, OnlySeatsArePushedUnder) {
  SceneText text =
      *ParseScene(std::string(kRoom) + "dresser 1x0.5 at 2,2,0 height 0.8; box 0.5x0.4 at 2,1.7,0 height 0.5");
  EXPECT_TRUE(MeasureSolids({text.scene, text.layout}).findings.empty()) << "nobody knows what it is";
  text.scene.objects[1].category = "nightstand";
  EXPECT_EQ(MeasureSolids({text.scene, text.layout}).findings.size(), 1u);
  text.scene.objects[1].seat = true;
  EXPECT_TRUE(MeasureSolids({text.scene, text.layout}).findings.empty());
  text.scene.objects[0].category = "dresser";
  EXPECT_EQ(MeasureSolids({text.scene, text.layout}).findings.size(), 1u) << "no knees are within a closed dresser";
  text.scene.objects[0].sat_at = true;
  EXPECT_TRUE(MeasureSolids({text.scene, text.layout}).findings.empty());
}

// Points of one rectangle, a centimetre apart, that satisfy `within`, as an area.
template <typename Within>
double SharedArea_m2(const Footprint& footprint, const Pose<double>& pose, const Within& within) {
  constexpr double kStep_m = 0.01;
  int shared = 0;
  for (double u = (kStep_m - footprint.width_m) / 2; u < footprint.width_m / 2; u += kStep_m) {
    for (double v = (kStep_m - footprint.depth_m) / 2; v < footprint.depth_m / 2; v += kStep_m) {
      shared += within(FrameOf(pose).ToRoom(u, v)) ? 1 : 0;
    }
  }
  return shared * kStep_m * kStep_m;
}

// Random rooms against points counted one by one: whatever shares room with something else is told.
TEST(Solids, EveryOverlapOfRandomPosesIsTold) {
  const char* kPieces =
      "4x5 room; door south 0.1 0.9; bed 1.6x2 at 0,0,0 height 0.5; desk 1.2x0.6 at 0,0,0 height 0.75; dresser 1x0.5 "
      "at "
      "0,0,0 height 0.8; wardrobe 1.5x0.6 at 0,0,0 height 2.1; nightstand 0.5x0.4 at 0,0,0 height 0.55; shelf 0.9x0.3 "
      "at "
      "0,0,0 wall tertiary height 0.4 elevation 0.6; picture 1x0.1 at 0,0,0 wall tertiary height 0.6 elevation 1.5";
  constexpr double kSeen_m2 = 0.003;
  SceneText text = *ParseScene(kPieces);
  std::mt19937 random(7);
  const auto draw = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  int expected = 0;
  for (int round = 0; round < 60; ++round) {
    for (size_t i = 0; i < text.scene.objects.size(); ++i) {
      text.scene.objects[i].category = "piece";
      text.layout[i] = {draw(0.3, 3.7), draw(0.3, 4.7), round % 2 == 0 ? draw(0, 6.28) : kPi / 2 * (random() % 4)};
    }
    std::set<std::pair<std::string, std::string>> told;
    for (const v1::Finding& finding : MeasureSolids({text.scene, text.layout}).findings) {
      told.insert(std::minmax(finding.object_id(), finding.partner_id()));
    }
    const Scene& scene = text.scene;
    for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
      const Object& object = scene.objects[i];
      const double swept = SharedArea_m2(object.footprint, text.layout[i], [](const Vec2<double>& p) {
        return p.x > 0.1 && p.y > 0 && std::hypot(p.x - 0.1, p.y) < 0.9;
      });
      if (swept > kSeen_m2) EXPECT_TRUE(told.contains(std::minmax(object.id, std::string("door_1")))) << object.id;
      for (int k = 0; k < i; ++k) {
        const Object& other = scene.objects[k];
        const double up_m = std::min(scene.TopOf(i), scene.TopOf(k)) - std::max(scene.BottomOf(i), scene.BottomOf(k));
        const double shared = SharedArea_m2(object.footprint, text.layout[i], [&](const Vec2<double>& p) {
          const Vec2<double> q = FrameOf(text.layout[k]).ToObject(p);
          return std::abs(q.x) < other.footprint.width_m / 2 && std::abs(q.y) < other.footprint.depth_m / 2;
        });
        if (up_m <= 0.02 || shared <= kSeen_m2) continue;
        ++expected;
        EXPECT_TRUE(told.contains(std::minmax(object.id, other.id))) << object.id << " and " << other.id;
      }
    }
  }
  EXPECT_GT(expected, 100);
}

TEST(Solids, WallShelfIsInTheWayOfAnOpenDoor) {
  // Hinged at x = 0.1, the leaf comes to lie at the west wall's shelf, which is 0.2 m deep.
  const std::string door = std::string(kRoom) + "door south 0.1 0.9; ";
  const SolidMeasures found = Of(door + "shelf 0.6x0.2 at 0.1,0.5,270 wall tertiary height 0.3 elevation 1.5");
  ASSERT_EQ(found.findings.size(), 1u);
  EXPECT_EQ(found.findings[0].kind(), v1::FINDING_KIND_DOOR_LEAF);
  EXPECT_EQ(found.findings[0].partner_id(), "door_1");
  EXPECT_NEAR(found.findings[0].amount(), 0.1, 1e-9);
  EXPECT_NEAR(found.overlap_m3, 0.1 * 0.6 * 0.3, 1e-9);
  EXPECT_EQ(found.findings[0].message(), "the door in the south wall hits the shelf when it opens, 0.10 m deep");
  EXPECT_THAT(Messages(door + "shelf 0.6x0.2 at 0.1,0.5,270 wall tertiary height 0.3 elevation 2.2"), IsEmpty())
      << "above the leaf";
  EXPECT_THAT(Messages(door + "mat 0.6x0.4 at 0.5,0.3,0 rug height 0.02"), IsEmpty());
}

TEST(Solids, PictureBeforeAWindowCoversIt) {
  EXPECT_THAT(
      Messages(std::string(kRoom) + "window south 1.5 1; art 1x0.1 at 2.2,0.05,0 wall tertiary height 0.5 elevation 1"),
      ElementsAre("the art covers 0.80 m of the window in the south wall"));
}

TEST(Solids, OutsideIsBesideTheFloorOrAboveTheCeiling) {
  const SolidMeasures beside = Of(std::string(kRoom) + "desk 1x0.6 at 2,0.2,0 height 0.7");
  EXPECT_NEAR(beside.outside_m3, 0.1 * 1 * 0.7, 1e-12);
  EXPECT_NEAR(beside.deepest_m, 0.1, 1e-12);
  const SolidMeasures above = Of(std::string(kRoom) + "column 1x1 at 2,2,0 height 3.5");
  EXPECT_NEAR(above.outside_m3, 0.5, 1e-12);
  ASSERT_EQ(above.findings.size(), 1u);
  EXPECT_EQ(above.findings[0].message(), "0.50 m of the column is above the ceiling");
}

TEST(Solids, WhatHangsTouchesAWallWithAllItsBack) {
  EXPECT_THAT(Messages(std::string(kRoom) + "art 1x0.1 at 2,0.1,0 wall tertiary height 0.5 elevation 1"),
              ElementsAre("between the art and the walls there is a gap of 0.05 m"));
  EXPECT_THAT(Messages(std::string(kRoom) + "art 1x0.1 at 2,0.05,0 wall tertiary height 0.5 elevation 1"), IsEmpty());
}

TEST(Solids, WhatStandsOnATopFitsIt) {
  const std::string table = std::string(kRoom) + "table 1x0.6 at 2,2,0 height 0.5; ";
  const SolidMeasures found = Of(table + "lamp 0.2x0.2 at 2.45,2,0 surface tertiary height 0.4 on table");
  EXPECT_EQ(found.unsupported_count, 1);
  ASSERT_EQ(found.findings.size(), 1u);
  EXPECT_EQ(found.findings[0].message(), "0.05 m of the lamp is over the edge of the table");
  // A cloth hangs over.
  EXPECT_THAT(Messages(table + "cloth 1.2x0.8 at 2,2,0 surface tertiary height 0.01 on table"), IsEmpty());
  EXPECT_THAT(Messages(table + "vase 0.2x0.2 at 0.5,0.5,0 surface tertiary height 0.4"),
              ElementsAre("no piece carries the vase, on the floor"));
}

TEST(Solids, WhatStandsOnABasinStandsOnItsRim) {
  // Of 1 m, 0.2 m carries at either side; of 0.6 m, 0.1 m in front and behind.
  const std::string basin = std::string(kRoom) + "basin 1x0.6 at 2,2,0 height 0.85 rim 0.2 0.1; ";
  EXPECT_THAT(Messages(basin + "plant 0.2x0.2 at 2,2,0 surface tertiary height 0.3 on basin"),
              ElementsAre("0.30 m of the plant is over the opening of the basin"));
  EXPECT_THAT(Messages(basin + "plant 0.2x0.2 at 1.6,2,0 surface tertiary height 0.3 on basin"), IsEmpty());
  EXPECT_THAT(Messages(basin + "board 0.3x0.5 at 2,2,0 surface tertiary height 0.1 on basin"), IsEmpty())
      << "lies across it";
  EXPECT_THAT(Messages(basin + "duck 0.1x0.1 at 2,2,0 surface tertiary height 0.1 elevation -0.1 on basin"), IsEmpty());
}

TEST(Solids, LampHangsOverATableOrAboveHeads) {
  const std::string room = "4x5 room; table 1x1 at 2,2,0 height 0.75; ";
  EXPECT_THAT(Messages(room + "lamp 0.5x0.5 at 2,2,0 ceiling tertiary height 0.5 elevation 1.5"), IsEmpty());
  EXPECT_THAT(Messages(room + "lamp 0.5x0.5 at 2,4,0 ceiling tertiary height 0.5 elevation 1.5"),
              ElementsAre("under the lamp there is 1.50 m above free floor; a person needs 1.90 m"));
  EXPECT_THAT(Messages(room + "lamp 0.5x0.5 at 2,4,0 ceiling tertiary height 0.5"), IsEmpty())
      << "it hangs from the ceiling itself";
}

TEST(Solids, RugsRunnersAndTouchingPiecesAreNoOverlap) {
  EXPECT_THAT(Messages(std::string(kRoom) + "carpet 2x2 at 2,2,0 rug height 0.02; a 1x1 at 2,2,0 height 0.75; "
                                            "b 1x1 at 3,2,0 height 0.75; "
                                            "runner 0.9x0.3 at 2,2,0 surface tertiary height 0.02 on a; "
                                            "vase 0.2x0.2 at 2,2,0 surface tertiary height 0.3 on a"),
              IsEmpty());
}

}  // namespace
}  // namespace flair::evaluation
