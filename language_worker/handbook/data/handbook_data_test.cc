// SPDX-License-Identifier: GPL-3.0-or-later
// A designer's checks of the data: sizes that fit, enough sentences about every piece, a full set of rooms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

bool StandsOnFloor(const hb::Furniture& item) { return item.kind() == hb::FURNITURE_KIND_FLOOR && !item.walk_over(); }

// Whether a rule that looks only at back, height, clearance and names speaks of a floor piece.
bool Speaks(const hb::Selector& rule, const hb::Furniture& item) {
  const auto has = [](const auto& list, const auto& value) {
    return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
  };
  const auto& not_these = rule.except_furniture();
  return rule.kinds().empty() && has(rule.backs(), item.back()) && has(rule.categories(), item.category()) &&
         has(rule.furniture(), item.name()) && item.height_m().typical() >= rule.min_height_m() &&
         item.clear_front_m() >= rule.min_clear_front_m() &&
         std::find(not_these.begin(), not_these.end(), item.name()) == not_these.end();
}

TEST(HandbookData, EveryFloorPieceHasOneToEightSentences) {
  for (const hb::Furniture& item : TheHandbook().contents().furniture()) {
    if (!StandsOnFloor(item)) continue;
    int sentences = item.relations_size();
    for (const hb::GeneralRule& rule : TheHandbook().contents().general_rules()) {
      // Those about neighbours and sets are of several, where sentences about walls and windows are not written; those
      // about a partner of rooms that have one.
      const hb::Relation& relation = rule.relation();
      const bool alone = relation.pairing() != hb::PAIRING_NEIGHBOUR && relation.pairing() != hb::PAIRING_TOGETHER &&
                         relation.targets().empty() && !rule.selector().in_rows();
      sentences += alone && Speaks(rule.selector(), item);
    }
    EXPECT_GE(sentences, 1) << item.name();
    EXPECT_LE(sentences, 8) << item.name();
    EXPECT_LE(item.relations_size(), 5) << item.name();
  }
}

// A reason stands beside its sentence in any room: what is only usual near a piece "can hang", "fits" or has room.
TEST(HandbookData, NoReasonSpeaksOfAPieceThatMayBeMissing) {
  constexpr std::array kUsual = {"mirror",     "picture", "curtain",    "lamp",
                                 "nightstand", "cushion", "chandelier", "camera"};
  const auto check = [&](const std::string& owner, const hb::Relation& relation) {
    const std::string& reason = relation.reason();
    std::string about = owner + " " + relation.text();
    for (const std::string& target : relation.targets()) about += " " + target;
    for (const char* possible : {"can ", "fit", "room for", "at the head", "customer looks", "face"}) {
      if (reason.find(possible) != reason.npos) return;
    }
    for (const char* word : kUsual) {
      if (about.find(word) == about.npos) EXPECT_EQ(reason.find(word), reason.npos) << owner << ": " << reason;
    }
  };
  for (const hb::Furniture& item : TheHandbook().contents().furniture()) {
    for (const hb::Relation& relation : item.relations()) check(item.name(), relation);
  }
  for (const hb::GeneralRule& rule : TheHandbook().contents().general_rules()) check(rule.name(), rule.relation());
}

TEST(HandbookData, EveryPieceIsDescribedAndMadeOfSomething) {
  for (const hb::Furniture& item : TheHandbook().contents().furniture()) {
    EXPECT_GT(item.descriptions_size(), 0) << item.name();
    EXPECT_FALSE(item.material_group().empty()) << item.name();
    EXPECT_FALSE(item.category().empty()) << item.name();
  }
}

TEST(HandbookData, NothingSoftPrintedOrElectricIsCeramic) {
  constexpr std::array kWords = {"cushion", "blanket", "towel", "runner", "book",   "magazine", "music",   "map",
                                 "bear",    "basket",  "box",   "rack",   "phone",  "console",  "printer", "machine",
                                 "monitor", "toaster", "clock", "lamp",   "bottle", "frame"};
  for (const hb::Furniture& item : TheHandbook().contents().furniture()) {
    if (item.material_group() != "ceramic") continue;
    for (const char* word : kWords) EXPECT_EQ(item.name().find(word), std::string::npos) << item.name();
  }
}

TEST(HandbookData, SurfacePiecesHaveHostsWithRoomOnTop) {
  for (const hb::Furniture& item : TheHandbook().contents().furniture()) {
    if (item.kind() != hb::FURNITURE_KIND_SURFACE) continue;
    const bool possible = std::any_of(item.hosts().begin(), item.hosts().end(), [](const std::string& host) {
      return TheHandbook().FindFurniture(host)->top_places() > 0;
    });
    EXPECT_TRUE(possible) << item.name();
  }
}

// The band that applies to the room's usual size.
const hb::Band& UsualBand(const hb::Archetype& room) {
  const double area_m2 = room.width_m().typical() * room.depth_m().typical();
  for (const hb::Band& band : room.bands()) {
    if (band.max_area_m2() == 0 || area_m2 < band.max_area_m2()) return band;
  }
  return room.bands(room.bands_size() - 1);
}

TEST(HandbookData, FurnitureFitsTheUsualRoomAndCoversAtMostFortyFivePercent) {
  for (const hb::Archetype& room : TheHandbook().contents().archetypes()) {
    const double width_m = room.width_m().typical();
    const double depth_m = room.depth_m().typical();
    double covered_m2 = 0;
    for (const hb::ObjectEntry& entry : UsualBand(room).objects()) {
      const hb::Furniture& item = *TheHandbook().FindFurniture(entry.furniture());
      const double long_m = std::max(item.width_m().typical(), item.depth_m().typical());
      EXPECT_LE(long_m, std::max(width_m, depth_m)) << room.name() << ": " << item.name();
      EXPECT_LE(item.depth_m().typical() + item.clear_front_m(), std::max(width_m, depth_m))
          << room.name() << ": " << item.name();
      covered_m2 += item.width_m().typical() * item.depth_m().typical() * std::max(1, entry.count());
    }
    EXPECT_LE(covered_m2, 0.45 * width_m * depth_m) << room.name();
  }
}

TEST(HandbookData, EveryZoneOfABandHasItsPrimaryAndEveryPieceItsZone) {
  for (const hb::Archetype& room : TheHandbook().contents().archetypes()) {
    for (const hb::Band& band : room.bands()) {
      const std::string where = fmt::format("{}, below {} m2", room.name(), band.max_area_m2());
      for (const hb::ObjectEntry& entry : band.objects()) {
        EXPECT_TRUE(std::find(band.zones().begin(), band.zones().end(), entry.zone()) != band.zones().end())
            << where << ": " << entry.furniture() << " in zone \"" << entry.zone() << "\"";
      }
      for (const std::string& name : band.zones()) {
        const auto zone = std::find_if(room.zones().begin(), room.zones().end(),
                                       [&](const hb::ZoneSpec& spec) { return spec.name() == name; });
        const bool served =
            std::any_of(band.objects().begin(), band.objects().end(), [&](const hb::ObjectEntry& entry) {
              return std::find(zone->primaries().begin(), zone->primaries().end(), entry.furniture()) !=
                     zone->primaries().end();
            });
        EXPECT_TRUE(served) << where << ": zone " << name << " has no primary";
      }
    }
  }
}

TEST(HandbookData, KnowsThePromisedRooms) {
  for (const char* name :
       {"bedroom",     "child's bedroom", "nursery",     "dorm room",   "living room", "living dining room",
        "dining room", "kitchen",         "bathroom",    "home office", "library",     "home gym",
        "sewing room", "music room",      "art studio",  "workshop",    "laundry",     "entrance hall",
        "studio flat", "meeting room",    "waiting room"}) {
    EXPECT_NE(TheHandbook().FindArchetype(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace flair::language
