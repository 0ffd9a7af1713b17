// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the handbook's answers over briefs as people write them.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

constexpr std::array<const char*, 60> kBriefs = {
    "A reading room with two desks back to back and a lamp between them.",
    "A library for forty readers, 10 by 8 m, with a reception desk near the door.",
    "A 12ft x 14ft bedroom with a king bed under the window, a wardrobe on the left as you enter and no nightstands.",
    "An L-shaped living room, 6 by 5 metres, with a fireplace on the north wall and two sofas facing each other.",
    "studio flat",
    "A kichen with an iland and four stools, 4.5x3.5",
    "Living room 5 x 4 m. The door is on the south wall and there are two windows on the east wall. Put the sofa "
    "opposite the TV. I want a reading chair in the corner by the window, and a floor lamp beside it.",
    "A dining room for twelve with a sideboard near the kitchen door.",
    "A child's room for twins: bunk beds, two small desks side by side, and a rug in the middle.",
    "A home office, 3 by 3, with a desk facing the door, a bookshelf behind the desk, and a sofa bed for guests if "
    "there is room.",
    "Bedroom 4x5m, door in the middle of the west wall, one large window on the north wall.",
    "Make me a cosy little lounge with a log burner, two armchairs with a small table between them, and somewhere to "
    "keep my vinyl records.",
    "A classroom for 24 students with the teacher's desk at the front and a whiteboard behind it",
    "open plan kitchen/living/dining 9m x 6m, kitchen at the east end, sofa facing the garden doors on the south wall",
    "A nursery for a newborn. Crib away from the window, changing table next to the crib, rocking chair in the corner "
    "with a lamp. 3.2 x 3 m.",
    "I need a meeting room for 8 people: table in the centre, screen on the short wall, whiteboard opposite the "
    "windows, small credenza for coffee.",
    "A very small bathroom, 2m by 1.5m, with a shower, toilet and sink",
    "Master bedroom with walk-in closet and ensuite, 20' x 16'",
    "A vampire's bedroom with a coffin instead of a bed and no windows",
    "bed room for 2 teenagers, 2 single beds on opposite walls, a shared desk under the window between the beds",
    "A teenage gamer's bedroom in a 10' by 11' room. He wants an L-shaped desk with two monitors, a gaming chair, a "
    "loft bed over the desk, posters, and absolutely no wardrobe.",
    "Wohnzimmer",
    "an art studio with north light, an easel by the window, a long work table in the middle, a sink on the east wall "
    "and plenty of storage along the walls",
    "A dental waiting room seating ten, with a toy corner for children, a reception counter facing the entrance and a "
    "water cooler next to the reception.",
    "Grandma's bed-sitting room: single bed in the left corner, recliner facing the television, a walking frame space "
    "of at least 90 cm beside the bed, and a commode chair.",
    "A 5m x 5m bedroom without a desk but with a desk.",
    "A living room, 18 feet long and 12 feet wide, with a grand piano in the bay window, a three-seat sofa against the "
    "long wall, two wingback chairs flanking the fireplace, and a console table behind the sofa.",
    "A tiny cabin for a sea captain with a bunk, a chart table under the porthole and a sea chest at the foot of the "
    "bunk",
    "Home gym 4 x 4: treadmill facing the window, weight bench in the centre, mirror on the left wall, yoga mat, and "
    "keep the door clear.",
    "Office for 6 developers: desks in two rows of three facing each other, a meeting corner with a round table for "
    "four, lockers near the entrance, plants between the desks and the meeting corner. 9x6m",
    "A square bedroom of twenty square metres with twin beds and a nightstand between the beds",
    "Design a sitting room (420cm x 360cm). There is a radiator under the window, so keep furniture off that wall. Two "
    "sofas at right angles around a square coffee table.",
    "kids bedroom 3mx4m pirate theme, ship bed, toy storage under the window, reading nook in the far left corner",
    "Living room: sofa with a side table on both sides, each with a lamp; TV on the wall opposite; bookshelves on "
    "either side of the TV; a rug under the coffee table.",
    "A doctor's consulting room with an exam couch along the left wall, desk with two patient chairs in front of it, "
    "hand basin by the door, privacy screen around the couch",
    "A hotel room for a business traveller: queen-size bed facing the window, luggage rack near the wardrobe, minibar, "
    "small desk, no tv please",
    "I'm moving into a 28 m2 bedsit and I'd like a sleeping corner hidden behind a bookcase, a tiny kitchenette along "
    "one wall and a table for 2.",
    "a gray colored family room w/ sectional couch, 65\" TV, play area for toddlers; approx. 15 by 20 feet; the french "
    "doors open onto the patio",
    "Bedroom, 5m long by 3.5m wide. King size bed centred on the longest wall with matching bedside tables. Built-in "
    "wardrobes along the entire opposite wall. Dressing table between the two windows. Bench at the end of the bed.",
    "A bar with 8 barstools along the counter, 5 round tables with 4 chairs each, a dartboard and a jukebox in the "
    "corner. 12 x 8 m.",
    "Bedroom 4x4 with the door on the east wall, bed against the north wall and wardrobe against the west wall",
    "a music room with an upright piano on the left wall, a drum kit in the far corner, three guitar stands and a sofa "
    "opposite the piano",
    "A long narrow living room, 3 m by 8 m, with the TV at one end and the dining table at the other",
    "Yoga studio for 12 people, mats in 3 rows of 4, mirror along the front wall, shelf for props at the back",
    "A bed, a chair, a table.",
    "A steampunk inventor's workshop with two workbenches, a tool cabinet beside each, and a comfy leather chair to "
    "think in",
    "A modern farmhouse dining room with a ten-foot table, a bench on one side and five chairs on the other, and a "
    "hutch against the far wall",
    "Kitchen 3.2 by 4 metres, L-shaped counter, fridge at the end of the counter, sink under the window, small "
    "breakfast table for two away from the stove",
    "A home theater with two rows of four recliners, screen on the front wall, popcorn machine by the door",
    "A principal's office: executive desk centred and facing the door, two visitor chairs opposite the principal, "
    "bookcases flanking the window, a flag in the corner, small sofa along the right-hand wall",
    "Lounge with the fireplace in the middle of the long wall, sofa in front of it and a bookcase in each alcove "
    "beside the chimney",
    "A bedroom in which the bed stands in the middle of the room, nothing against the windows",
    "4.2m by 3.6m office, door at the left end of the south wall, window opposite the door; my desk should be under "
    "the window and the shelves to the right of the desk",
    "a family of five needs a dining room: extendable table, highchair next to the table, dresser for plates, dog bed "
    "in the corner",
    "A craft room with a sewing machine on a desk, an ironing board, a cutting table that one can walk around, fabric "
    "shelves from wall to wall, and a comfy chair",
    "Bathroom 8x10 ft: clawfoot tub below the window, double vanity opposite the tub, toilet hidden from the door, "
    "towel warmer near the shower",
    "Laundry room, washer and dryer side by side, ironing board, laundry sink, hanging rail above the machines, 2.4 x "
    "2 metres",
    "A hobbit's living-room with round door, low armchairs around the hearth, a pantry shelf & a writing desk by the "
    "round window",
    "Living room. No TV. No rug. Not too many plants. Piano instead of a desk. Sofa must not face the window.",
    "Waiting area 6x3m with 2 rows of 5 chairs back-to-back in the centre, vending machine in a corner, information "
    "desk to the right of the entrance"};

std::unique_ptr<const Handbook> Loaded() {
  auto handbook = LoadHandbook(FLAIR_SOURCE_DIR "/language_worker/handbook/data");
  if (!handbook.ok()) {
    ADD_FAILURE() << handbook.status();
    return nullptr;
  }
  return *std::move(handbook);
}

v1::Brief BriefOf(const std::string& text) {
  v1::Brief brief;
  brief.set_text(text);
  return brief;
}

// Every answer to a brief, one after another; checks that each is sound.
std::string AnswersTo(const std::string& text, const Handbook& handbook) {
  const v1::Brief brief = BriefOf(text);
  const auto room = DescribeRoom(brief, handbook);
  if (!room.ok()) return room.status().ToString();
  const auto zones = PlanZones(brief, *room, handbook);
  const auto objects = ListObjects(brief, *room, *zones, handbook);
  const auto style = ChooseStyle(brief, *room, *objects, handbook);
  const auto constraints = ListConstraints(brief, *room, *zones, *objects, handbook);
  const v1::ConstraintList cleaned = CleanConstraints(*constraints);
  EXPECT_TRUE(Validate(*room).ok()) << Validate(*room);
  EXPECT_TRUE(Validate(*objects, *zones).ok()) << Validate(*objects, *zones);
  EXPECT_TRUE(Validate(*style, *room, *objects).ok()) << Validate(*style, *room, *objects);
  EXPECT_TRUE(Validate(cleaned, *objects).ok()) << Validate(cleaned, *objects);
  return room->DebugString() + zones->DebugString() + objects->DebugString() + style->DebugString() +
         cleaned.DebugString();
}

// Two handbooks lie at other addresses: an answer that goes by the order of pointers differs.
TEST(HandbookBriefs, GiveTheSameSoundAnswersWithEveryCopyOfTheHandbook) {
  const auto first = Loaded(), second = Loaded();
  ASSERT_TRUE(first && second);
  for (const char* text : kBriefs) {
    SCOPED_TRACE(text);
    const std::string answers = AnswersTo(text, *first);
    EXPECT_NE(answers.find("openings"), std::string::npos) << answers;
    EXPECT_EQ(answers, AnswersTo(text, *second));
  }
}

// Words that ask for more ("between the", "two rows of") may be the last ones.
TEST(HandbookBriefs, AreReadWhereverTheyBreakOff) {
  const auto handbook = Loaded();
  ASSERT_TRUE(handbook);
  for (const std::string text : kBriefs) {
    for (std::size_t end = text.find(' '); end != std::string::npos; end = text.find(' ', end + 1)) {
      const auto room = DescribeRoom(BriefOf(text.substr(0, end)), *handbook);
      EXPECT_TRUE(!room.ok() || Validate(*room).ok()) << text.substr(0, end) << ": " << Validate(*room);
    }
  }
}

}  // namespace
}  // namespace flair::language
