// SPDX-License-Identifier: GPL-3.0-or-later
// Which kind of room a brief means, and what it is besides.
#include "language_worker/handbook/reading/room_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

// "living dining room + kitchen; bathroom": the room, what it is too, what it has.
std::string KindIn(const std::string& text) {
  const RoomKind kind = ReadRoomKind(TokensOf(text), TheHandbook());
  if (kind.room.archetype == nullptr) return "";
  std::string told = kind.room.archetype->name();
  for (const NamedRoom& one : kind.also) told += " + " + one.archetype->name();
  for (const NamedRoom& one : kind.named) told += "; " + one.archetype->name();
  return told;
}

bool Remarks(const v1::Room& room, const std::string& code) {
  return std::ranges::any_of(room.diagnostics(), [&](const v1::Diagnostic& one) { return one.code() == code; });
}

struct KindCase {
  const char* text;
  const char* kind;
};

TEST(RoomKind, WhatComesBeforeWithIsTheRoom) {
  const KindCase kCases[] = {
      {"Master bedroom with walk-in closet and ensuite", "bedroom; dressing room; bathroom"},
      {"Master suite: bedroom, walk-in closet, bathroom", "bedroom; dressing room; bathroom"},
      {"A large family bathroom with dressing room", "bathroom; dressing room"},
      {"Bedroom with an en-suite door on the west wall", "bedroom"},
      {"A hotel room that has a balcony", "hotel bedroom; conservatory"},
      {"Garage conversion into a guest room for my in-laws", "guest room"},
      {"Turning the garage into a bedroom for my father", "bedroom"},
      {"The entrance is in the middle of the south wall.", ""},
      {"Hall with a reading nook", "entrance hall; reading nook"},
      {"A bedroom with a view of the church", "bedroom"},
      {"Small living area beside the dining room", "living room"},
      {"A lounge that should feel like a library, not like a waiting room", "living room"},
      {"I would like a library", "library"},
      {"A bedroom with living plants", "bedroom"},
      {"A dining room next to the kitchen", "dining room"},
      {"Office with a kitchen table", "home office"},
      {"I live with my mother and need a home office", "home office"},
      {"A bedroom with a home office in the corner", "bedroom; home office"},
  };
  for (const auto& [text, kind] : kCases) EXPECT_EQ(KindIn(text), kind) << text;
}

TEST(RoomKind, ARoomMayBeSeveralKindsInOne) {
  const KindCase kCases[] = {
      {"Open plan kitchen/living/dining 9m x 6m", "living dining room + kitchen"},
      {"An open-plan living, dining and kitchen space", "living dining room + kitchen"},
      {"Lounge/diner 7 x 4 m", "living dining room"},
      {"A kitchen and dining room 6x5", "dining room + kitchen"},
      {"Kitchen diner for a family", "kitchen + dining room"},
      {"A bedroom and study for a student", "bedroom + home office"},
      {"Guest room / home office", "guest room + home office"},
      {"A study that doubles as a guest room", "guest room + home office"},
      {"Kitchen, dining table for six", "kitchen"},
      {"A living room, a bed in the corner", "living room"},
  };
  for (const auto& [text, kind] : kCases) EXPECT_EQ(KindIn(text), kind) << text;
}

TEST(RoomKind, IsWrittenInManyWays) {
  const KindCase kCases[] = {
      {"bed room for 2 teenagers, 2 single beds", "bedroom"},
      {"A bed-room", "bedroom"},
      {"A living-room with a sofa", "living room"},
      {"livingroom", "living room"},
      {"bed-sitting room, single bed", "studio flat"},
      {"A bedsitter", "studio flat"},
      {"A bed-sit", "studio flat"},
      {"A bath-room", "bathroom"},
      {"home-office", "home office"},
  };
  for (const auto& [text, kind] : kCases) EXPECT_EQ(KindIn(text), kind) << text;
}

TEST(RoomKind, SeveralKindsHaveTheFurnitureOfAll) {
  const auto pieces = [](const std::string& text, double area_m2) {
    v1::Brief brief;
    brief.set_text(text);
    const absl::StatusOr<BriefFacts> facts = ReadBrief(brief, TheHandbook());
    std::set<std::string> names;
    for (const ProgramItem& item : MakeRoomProgram(*facts, TheHandbook(), area_m2, Choice(0, text)).floor_items) {
      names.insert(item.furniture->name());
    }
    return names;
  };
  const std::set<std::string> open_plan = pieces("Open plan kitchen/living/dining", 54);
  for (const char* piece : {"sofa", "dining table", "refrigerator", "cooker"})
    EXPECT_TRUE(open_plan.contains(piece)) << piece;
  EXPECT_FALSE(open_plan.contains("round dining table")) << "a second one";
  const std::set<std::string> bedroom = pieces("A bedroom with a home office", 24);
  for (const char* piece : {"double bed", "desk"}) EXPECT_TRUE(bedroom.contains(piece)) << piece;
  EXPECT_FALSE(pieces("A living room", 24).contains("refrigerator"));
  // There is floor for it.
  EXPECT_GT(FloorArea(RoomOf("Open plan kitchen/living/dining")), FloorArea(RoomOf("A living and dining room")) + 5);
}

TEST(RoomKind, SaysWhereAUseLies) {
  EXPECT_EQ(FactsOf("Kitchen/dining room, kitchen at the east end").places_not_known,
            std::vector<std::string>{"kitchen at the east end"});
  EXPECT_TRUE(FactsOf("A restaurant with a bar along the back wall").places_not_known.empty()) << "a piece";
}

TEST(RoomKind, WhatIsNoPartOfTheRoomIsReported) {
  EXPECT_TRUE(Remarks(RoomOf("Master bedroom with walk-in closet and ensuite."), "other_rooms_named"));
  EXPECT_FALSE(Remarks(RoomOf("A living room with a bar."), "other_rooms_named"));
  EXPECT_TRUE(Remarks(RoomOf("Open plan kitchen/living/dining, kitchen at the east end."), "place_not_understood"));
}

TEST(RoomKind, OtherLanguagesAreTold) {
  for (const char* text : {"Wohnzimmer 5m x 4m", "Ein Wohnzimmer mit Sofa", "Une chambre avec un grand lit",
                           "Salon avec canapé", "Cozinha com mesa", "Slaapkamer met een bed"}) {
    EXPECT_TRUE(IsForeign(TokensOf(text))) << text;
    EXPECT_TRUE(Remarks(RoomOf(text), "language_not_known")) << text;
  }
  for (const char* text : {"Bedroom 4x4 m", "A salon with a sofa", "sofa, bed", "Living room, chaise longue, 5 x 4 m",
                           "A room for a Wohnzimmer fan"}) {
    EXPECT_FALSE(IsForeign(TokensOf(text))) << text;
  }
}

TEST(RoomKind, IsLinear) {
  const auto seconds = [](std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += "kitchen/living/dining with a bar, ";
    const auto start = std::chrono::steady_clock::now();
    KindIn(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  seconds(10);
  EXPECT_LT(seconds(1000), 40 * seconds(100) + 0.05);
}

TEST(RoomKind, IsNotTheHomeThatItIsIn) {
  const KindCase kCases[] = {
      {"We rent a flat with a 5.5 x 4.2 m living room.", "living room"},
      {"Bathroom in an old flat, about 2.2 x 2.6 m.", "bathroom"},
      {"A flat of 28 m2 with a sofa bed.", "studio flat"},
      {"A bookshop with the entrance and a display window at the front.", "bookshop"},
      {"Converting the garage (5.5 x 3 m) into a home gym.", "home gym"},
      {"A medieval scribe's chamber with a writing desk.", "scriptorium"},
  };
  for (const auto& [text, kind] : kCases) EXPECT_EQ(KindIn(text), kind) << text;
}

TEST(RoomKind, FollowsWhomItIsFor) {
  const KindCase kCases[] = {
      {"My son is 15 and his room is 3.2 m by 4 m.", "teenager's room"},
      {"A room for our six-year-old girl.", "child's bedroom"},
      {"Standard twin room for a three-star hotel.", "hotel bedroom"},
      {"Physiotherapy treatment room in our clinic.", "physiotherapy room"},
  };
  for (const auto& [text, kind] : kCases) EXPECT_EQ(RoomOf(text).room_type(), kind) << text;
}

}  // namespace
}  // namespace flair::language
