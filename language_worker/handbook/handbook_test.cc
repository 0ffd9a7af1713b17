// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the handbook's answers, over its own data: every kind of room, many sizes, many seeds.
#include "language_worker/handbook/handbook.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/handbook/testing/test_handbook.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

struct Answers {
  v1::Room room;
  v1::ZonePlan zones;
  v1::ObjectList objects;
  v1::StyleSheet style;
  v1::ConstraintList raw, cleaned;

  bool Has(const std::string& name) const { return Count(name) > 0; }
  int Count(const std::string& name) const {
    return static_cast<int>(std::count_if(objects.objects().begin(), objects.objects().end(),
                                          [&](const v1::Object& object) { return object.name() == name; }));
  }
};

Answers Ask(const std::string& text, std::int64_t seed = 0) {
  v1::Brief brief;
  brief.set_text(text);
  brief.set_seed(seed);
  Answers a;
  const auto room = DescribeRoom(brief, TheHandbook());
  EXPECT_TRUE(room.ok()) << room.status();
  if (!room.ok()) return a;
  a.room = *room;
  a.zones = *PlanZones(brief, a.room, TheHandbook());
  a.objects = *ListObjects(brief, a.room, a.zones, TheHandbook());
  a.style = *ChooseStyle(brief, a.room, a.objects, TheHandbook());
  a.raw = *ListConstraints(brief, a.room, a.zones, a.objects, TheHandbook());
  a.cleaned = CleanConstraints(a.raw);
  return a;
}

void ExpectSound(const Answers& a) {
  EXPECT_TRUE(Validate(a.room).ok()) << Validate(a.room);
  EXPECT_TRUE(Validate(a.zones).ok()) << Validate(a.zones);
  EXPECT_TRUE(Validate(a.objects, a.zones).ok()) << Validate(a.objects, a.zones);
  EXPECT_TRUE(Validate(a.style, a.room, a.objects).ok()) << Validate(a.style, a.room, a.objects);
  EXPECT_TRUE(Validate(a.cleaned, a.objects).ok()) << Validate(a.cleaned, a.objects);
  double covered_m2 = 0;
  for (const v1::Object& object : a.objects.objects()) {
    if (object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over())
      covered_m2 += object.width_m() * object.depth_m();
  }
  const int floor_count =
      static_cast<int>(std::count_if(a.objects.objects().begin(), a.objects.objects().end(),
                                     [](const auto& o) { return o.role() != v1::OBJECT_ROLE_TERTIARY; }));
  if (floor_count > 1) EXPECT_LE(covered_m2, 0.46 * FloorArea(a.room));
  for (const v1::Sentence& sentence : a.cleaned.sentences()) {
    EXPECT_GT(sentence.subject_ids_size(), 0) << sentence.text();
    EXPECT_EQ(sentence.text().find('{'), std::string::npos) << sentence.text();
  }
}

// A test for each size, so that they run beside each other.
class HandbookOfSize : public ::testing::TestWithParam<const char*> {};

TEST_P(HandbookOfSize, AnswersAreSoundForEveryRoomAndSeed) {
  for (const hb::Archetype& archetype : TheHandbook().contents().archetypes()) {
    for (const std::int64_t seed : {0, 1, 7}) {
      const std::string text = fmt::format("A {} {}", archetype.name(), GetParam());
      SCOPED_TRACE(fmt::format("{} seed {}", text, seed));
      ExpectSound(Ask(text, seed));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllSizes, HandbookOfSize,
                         ::testing::Values("2m x 2m", "2.5m x 3m", "3m x 4m", "6m x 3m", "5m x 5m", "9m x 8m", ""));

TEST(Handbook, AnswersAreSoundForEveryTheme) {
  for (const hb::Theme& theme : TheHandbook().contents().themes()) {
    SCOPED_TRACE(theme.name());
    ExpectSound(Ask(fmt::format("A bedroom for a {}", theme.keywords(0))));
    ExpectSound(Ask(fmt::format("A small {} kitchen", theme.keywords(0)), 3));
  }
}

TEST(Handbook, FindsItsOwnRoomByEveryName) {
  for (const hb::Archetype& archetype : TheHandbook().contents().archetypes()) {
    if (archetype.fallback()) continue;
    EXPECT_EQ(Ask("A " + archetype.name() + ".").room.room_type(), archetype.name());
  }
}

TEST(Handbook, APieceThatStandsWithAnotherDoesNotReplaceIt) {
  const Answers island = Ask("A 5 x 5 m kitchen with a kitchen island.");
  EXPECT_TRUE(island.Has("kitchen island"));
  EXPECT_TRUE(island.Has("kitchen counter"));
}

TEST(Handbook, ARoomWithoutASizeHasRoomForWhatIsAskedFor) {
  for (const char* text : {"A small office with four desks and a meeting table with six chairs.",
                           "A bedroom with three double beds and two wardrobes.",
                           "A living room with a billiard table, three sofas and a grand piano."}) {
    for (const std::int64_t seed : {0, 1, 7}) {
      const Answers a = Ask(text, seed);
      ExpectSound(a);
      for (const v1::Omission& omission : a.objects.omissions()) EXPECT_FALSE(omission.requested()) << omission.name();
    }
  }
  // The usual one where that is enough.
  EXPECT_EQ(FloorArea(Ask("A bedroom with a double bed and a wardrobe.").room), FloorArea(Ask("A bedroom.").room));
  EXPECT_LT(FloorArea(Ask("A small bedroom with a double bed.").room), FloorArea(Ask("A bedroom.").room));
}

TEST(Handbook, SameSeedSameAnswerOtherSeedsOtherDesigns) {
  std::set<std::string> rooms;
  for (std::int64_t seed = 0; seed < 8; ++seed) {
    const Answers a = Ask("A living room that is 4m x 6m.", seed);
    EXPECT_EQ(a.room.SerializeAsString(), Ask("A living room that is 4m x 6m.", seed).room.SerializeAsString());
    EXPECT_EQ(a.cleaned.SerializeAsString(), Ask("A living room that is 4m x 6m.", seed).cleaned.SerializeAsString());
    rooms.insert(a.room.SerializeAsString() + a.style.SerializeAsString());
  }
  EXPECT_GE(rooms.size(), 6u);
}

TEST(Handbook, HearsWishesCountsAndRefusals) {
  const Answers a = Ask("A 5m x 6m living room with a piano and two armchairs, no tv.");
  EXPECT_TRUE(a.Has("upright piano"));
  EXPECT_TRUE(a.Has("piano bench"));
  EXPECT_EQ(a.Count("armchair"), 2);
  EXPECT_FALSE(a.Has("television"));
}

TEST(Handbook, AVampireSleepsInACoffin) {
  const Answers a = Ask("A bedroom for a vampire.");
  EXPECT_TRUE(a.Has("coffin"));
  EXPECT_FALSE(a.Has("double bed"));
  EXPECT_EQ(a.style.name(), "vampire");
}

TEST(Handbook, APainterGetsAnEaselAtTheWindow) {
  const Answers a = Ask("A bedroom that is 5x5 for a young girl who likes to paint whilst looking out of her window.");
  EXPECT_TRUE(a.Has("easel"));
  EXPECT_EQ(a.room.room_type(), "child's bedroom");
  EXPECT_TRUE(std::any_of(a.cleaned.sentences().begin(), a.cleaned.sentences().end(), [](const v1::Sentence& sentence) {
    return sentence.text().find("easel") != std::string::npos && sentence.text().find("window") != std::string::npos;
  }));
}

TEST(Handbook, ColoursOfTheBriefLeadTheStyle) {
  const Answers a = Ask("A small green boho dining room.");
  EXPECT_EQ(a.style.name(), "green boho");
  EXPECT_EQ(a.style.palette(0).name(), "green");
  EXPECT_TRUE(a.Has("dining table") || a.Has("round dining table"));
}

TEST(Handbook, SaysWhatThingsAreMadeOfAsOneWould) {
  const Answers a = Ask("A living room of 6 x 5 m with a television, a bookshelf and books on it.");
  int seen = 0;
  for (int i = 0; i < a.objects.objects_size(); ++i) {
    const v1::Object& object = a.objects.objects(i);
    const std::string& material = a.style.objects(i).material();
    if (object.name() == "books") EXPECT_FALSE(object.description().starts_with("A ")) << object.description();
    if (object.name() == "books") EXPECT_EQ(material, "cloth and paper");
    if (object.name() == "television") EXPECT_EQ(a.style.objects(i).colour().name(), "charcoal");
    seen += object.name() == "books" || object.name() == "television";
  }
  EXPECT_GE(seen, 2);
}

TEST(Handbook, NamesWhatDoesNotFit) {
  const Answers a =
      Ask("A 2m x 2m bedroom with a piano, a sofa, two desks, a pool table, a bathtub, an easel, a bookshelf, "
          "a wardrobe, a treadmill and a fireplace");
  ExpectSound(a);
  EXPECT_GT(a.objects.omissions_size(), 3);
  for (const v1::Omission& omission : a.objects.omissions()) EXPECT_FALSE(omission.reason().empty());
  EXPECT_GT(a.objects.objects_size(), 0);
}

TEST(Handbook, SurvivesHostileText) {
  for (const std::string& text :
       {std::string(4000, 'x'), std::string("\xf0\x9f\x9b\x8f\xf0\x9f\x9b\x8f"), std::string("\"'; DROP"),
        std::string("{object} {target} %s %n"), std::string(2000, '-')}) {
    ExpectSound(Ask(text));
  }
}

TEST(LoadHandbook, SaysWhereAFolderIsWrong) {
  const auto handbook = LoadHandbook("/nonexistent");
  ASSERT_FALSE(handbook.ok());
  EXPECT_NE(std::string(handbook.status().message()).find("/nonexistent"), std::string::npos);
}

TEST(Handbook, RoomsOfAnEarlierTimeHoldWhatThereWasThen) {
  const Answers today = Ask("A study of 4 m x 4 m."), then = Ask("A study of 4 m x 4 m around 1750.");
  EXPECT_GT(today.Count("office chair"), 0);
  EXPECT_EQ(then.Count("office chair"), 0);
  EXPECT_GT(then.Count("dining chair"), 0) << "instead of the office chair";
  EXPECT_EQ(then.Count("laptop") + then.Count("computer monitor") + then.Count("printer"), 0);
  EXPECT_EQ(Ask("A study of 4 m x 4 m around 1750 with a laptop.").Count("laptop"), 1) << "who asks for it gets it";
}

TEST(HandbookPeople, EveryoneHasADeskAndAChairAtIt) {
  const Answers team = Ask("An office for six people, 8 m x 6 m.");
  EXPECT_EQ(team.room.room_type(), "team office");
  EXPECT_EQ(team.Count("desk"), 6);
  EXPECT_EQ(team.Count("office chair"), 6);
  EXPECT_EQ(Ask("A home office of 20 m2 with two desks.").Count("office chair"), 2);
}

TEST(HandbookPeople, ATableHasTheSeatsThatWereAskedForAndDesksKeepTheirs) {
  const Answers a = Ask("A home office, 7 m x 6 m, with a meeting table for eight.");
  EXPECT_EQ(a.Count("conference table"), 1);
  EXPECT_EQ(a.Count("round dining table"), 0);
  EXPECT_EQ(a.Count("office chair"), 9);
  int at_desk = 0, round_table = 0;
  for (const v1::Sentence& sentence : a.cleaned.sentences()) {
    at_desk += sentence.text().ends_with("office chair is next to the front of the desk.") ? 1 : 0;
    if (sentence.text().find("surround the conference table") != std::string::npos) {
      round_table = sentence.subject_ids_size();
    }
  }
  EXPECT_EQ(at_desk, 1);
  EXPECT_EQ(round_table, 9) << "eight chairs and the table";
}

TEST(HandbookPeople, ATableKeepsItsSeatsWhereverItStands) {
  for (const char* text : {"A kitchen, 6 x 4 m, table for six by the window.", "A kitchen with a table for six",
                           "A kitchen-diner with a dining table for 6 under the window",
                           "A kitchen, table for six in the corner, with an island"}) {
    EXPECT_EQ(Ask(text).Count("dining chair"), 6) << text;
  }
}

TEST(HandbookPeople, MakeARoomLargerWhenItsSizeIsNotGiven) {
  EXPECT_GT(FloorArea(Ask("A dining room for 12 people.").room), 1.3 * FloorArea(Ask("A dining room.").room));
  EXPECT_NEAR(FloorArea(Ask("A dining room of 20 m2 for 12 people.").room), 20, 0.5);
}

TEST(Handbook, GivesPiecesTheSizeThatIsAskedFor) {
  const Answers a = Ask("A study of 4 m x 5 m with a 1.4 m x 0.7 m desk.");
  for (const v1::Object& object : a.objects.objects()) {
    if (object.name() != "desk") continue;
    EXPECT_DOUBLE_EQ(object.width_m(), 1.4);
    EXPECT_DOUBLE_EQ(object.depth_m(), 0.7);
  }
  EXPECT_EQ(a.Count("desk"), 1);
}

TEST(Handbook, PutsAPieceIntoTheCornerThatIsNamed) {
  const Answers a = Ask("A living room of 5 m x 4 m with an armchair in the far right corner.");
  const auto at_walls = std::ranges::count_if(a.cleaned.sentences(), [](const v1::Sentence& sentence) {
    return sentence.text().starts_with("The armchair's") &&
           sentence.text().find(" is against the ") != std::string::npos;
  });
  EXPECT_EQ(at_walls, 2) << "its back and a side";
}

TEST(Handbook, TellsWhatIsNotInTheRoomAsAsked) {
  for (const char* text :
       {"A study, 3 m x 3 m, with a desk and nine table lamps.", "A bedroom, 3 m x 3 m, with a bed and thirty books.",
        "A dining room, 3 m x 3 m, with three tables for eight."}) {
    const Answers a = Ask(text);
    EXPECT_GT(a.objects.omissions_size() + a.objects.diagnostics_size(), 0) << text;
  }
}

TEST(Handbook, SaysWhatItDidNotUnderstand) {
  const auto codes = [](const Answers& a) {
    std::set<std::string> codes;
    for (const v1::Diagnostic& remark : a.room.diagnostics()) codes.insert(remark.code());
    return codes;
  };
  EXPECT_TRUE(codes(Ask("A bedroom, 4m x 5m, with a zither.")).contains("thing_made_plain"));
  EXPECT_TRUE(codes(Ask("A dining room, 9m x 9m, with a hundred stools.")).contains("too_many_asked"));
  EXPECT_TRUE(codes(Ask("Ein Schlafzimmer mit einem Doppelbett, 4 m x 5 m.")).contains("language_not_known"));
  EXPECT_EQ(codes(Ask("A bedroom that is 4m x 5m with a desk and two nightstands.")), std::set<std::string>());
}

}  // namespace
}  // namespace flair::language
