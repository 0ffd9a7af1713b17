// SPDX-License-Identifier: GPL-3.0-or-later
// What a brief says of its doors and windows, in words.
#include "language_worker/handbook/reading/opening_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

OpeningWishes OpeningsIn(const std::string& text) {
  const std::vector<Token> tokens = TokensOf(text);
  std::vector<bool> used(tokens.size());
  OpeningWishes openings;
  ReadOpenings(tokens, std::vector<bool>(tokens.size()), used, openings);
  return openings;
}

// "door@south middle; 2 window@east w1.2".
std::string Told(const OpeningWishes& openings) {
  std::string told;
  for (const OpeningWish& wish : openings.wishes) {
    told += told.empty() ? "" : "; ";
    told += (wish.count > 1 ? std::to_string(wish.count) + " " : "") + (wish.door ? "door" : "window");
    if (!wish.side.empty()) told += "@" + wish.side;
    if (wish.along.at == AlongWall::At::kMiddle) told += " middle";
    if (wish.along.at == AlongWall::At::kEnd) told += " end:" + wish.along.end;
    if (wish.along.from_end_m) told += fmt::format(" +{:g}", *wish.along.from_end_m);
    if (wish.width_m) told += fmt::format(" w{:g}", *wish.width_m);
    if (wish.height_m) told += fmt::format(" h{:g}", *wish.height_m);
    if (wish.sill_m) told += fmt::format(" sill{:g}", *wish.sill_m);
    if (wish.width_factor > 1) told += " large";
    if (wish.width_factor < 1) told += " small";
    if (wish.to_ceiling) told += " to-ceiling";
    if (wish.outside) told += " outside";
    if (!wish.leads_to.empty()) told += " to:" + wish.leads_to;
    if (wish.swing == v1::DOOR_SWING_SLIDING) told += " sliding";
    if (wish.swing == v1::DOOR_SWING_OUTWARD) told += " outward";
    if (wish.swing == v1::DOOR_SWING_NONE) told += " open";
    if (wish.of_many) told += " ...";
  }
  return told;
}

struct OpeningCase {
  const char* text;
  const char* told;
};

TEST(OpeningReader, ReadsTheWall) {
  const OpeningCase kCases[] = {
      {"The door is on the south wall and there are two windows on the east wall.", "door@south; 2 window@east"},
      {"A study with one window in the north wall.", "window@north"},
      {"On the north wall there is a large window.", "window@north large"},
      {"The west wall has two windows and a door.", "2 window@west; door@west"},
      {"One window, on the west wall, and a door.", "window@west; door"},
      {"One window, on the west wall a shelf.", "window"},
      {"A four-door cabinet and a door-mat.", ""},
      {"Window: north. Door: south wall.", "window@north; door@south"},
      {"A room with a door to the hall on the west side.", "door@west"},
      {"Windows on the north and east walls.", "window@north; window@east"},
      {"A north-facing window and an east window.", "window@north; window@east"},
      {"Windows along the whole length of the south side.", "2 window@south"},
      {"A window on each short wall.", "window@short; window@across short"},
      {"A guest room that has one window, facing east.", "window"},
      {"Two windows, one on the north wall and the other on the east.", "window@north; window@east"},
      {"One window is on the north wall, the other on the west wall.", "window@north; window@west"},
      {"A bedroom with two windows. The windows are on the south wall.", "2 window@south"},
      {"Two windows. One window is on the long wall.", "window; window@long"},
      {"A bench beside the front door, and a second door opposite the first.", "door; door@far"},
      {"A shop with a second door on the east wall.", "door; door@east"},
  };
  for (const auto& [text, told] : kCases) EXPECT_EQ(Told(OpeningsIn(text)), told) << text;
}

TEST(OpeningReader, ReadsWallsThatGoByOtherOpenings) {
  const OpeningCase kCases[] = {
      {"A window opposite the door.", "window@far"},
      {"A window across from the entrance.", "window@far"},
      {"The door is opposite the window on the east wall.", "door@across east; window@east"},
      {"A door and a window on the same wall.", "door; window@near"},
      {"A door on the north wall and a window on the opposite wall.", "door@north; window@across north"},
      {"Windows on both sides.", "window@left; window@right"},
      {"A window on the wall across from the door.", "window@far"},
      {"The door is right in the middle of one of the short walls.", "door@short middle"},
      {"A door on the west wall and a window in the east wall opposite.", "door@west; window@across west"},
      {"The door is in the north wall on the left side.", "door@north end:left"},
      {"Windows on three sides.", "window@far; window@left; window@right"},
      {"Windows opposite each other.", "window@left; window@right"},
      {"A window either side of the door.", "2 window@near"},
      {"As you enter, the window is on the left.", "window@left"},
      {"The window is straight ahead as you come in.", "window@far"},
      {"A door and a window on the north wall.", "door@north; window@north"},
      {"A door in the south wall and a pair of windows in the wall opposite.", "door@south; 2 window@across south"},
      {"A window to the right of the door.", "window@near"},
      {"A low door to the south with a tiny window on either side.", "door@south; 2 window@south small"},
      {"The door is in the east wall with windows on both sides.", "door@east; 2 window@east"},
      {"Double doors on the south face and windows on the three northern faces.",
       "door@south w1.5; window@north; window@north west; window@north east"},
      {"A window on the north west side.", "window@north west"},
      {"A back door on the north wall to the yard, and keep the cooker away from the back door.",
       "door@north w0.9 outside to:yard"},
      {"A doorway to the rest of the house on the south.", "door@south"},
      {"A tiny window high up on the short wall.", "window@short sill1.5 small"},
      {"Two windows left and right of the door.", "2 window@near"},
      {"Two doors: one to the hall (south wall), one to the bathroom (west wall).",
       "door@south; door@west to:bathroom"},
      {"A window in the short wall and a door in the long wall near the window.", "window@short; door@long"},
  };
  for (const auto& [text, told] : kCases) EXPECT_EQ(Told(OpeningsIn(text)), told) << text;
}

TEST(OpeningReader, ReadsWhatAClauseTellsOfSeveral) {
  const OpeningCase kCases[] = {
      {"It has two doors, bedroom and bathroom, facing each other in the short walls.",
       "door@short to:bedroom; door@across short to:bathroom"},
      {"One door to the passage and one to the larder.", "door; door to:larder"},
      {"Window 90 x 70 cm, high, on the west wall.", "window@west w0.9 h0.7 sill1.5"},
      {"A nook, 3 x 2 m, open on the south side to the hall.", "door@south open"},
      {"North glazing full width.", "window@north w100"},
      {"Both get a bit of the window, which is in the centre of the long wall.", "window@long middle"},
      {"A shop window and a glass door on the short street side.", "window@near w2; door@short"},
      {"A bed on the long wall opposite the windows.", "2 window@across long"},
      {"A table near the kitchen hatch.", "door to:kitchen open"},
      {"Sliding glass doors take up most of the north wall, and the door from the passage is in the east wall.",
       "door@north outside sliding; door@east"},
      {"Windows run along the south side, bifold doors fill the west wall.", "2 window@south; door@west sliding"},
      {"A door at one end and a window at the other end.", "door@short; window@across short"},
      {"A door on the south wall at the right, two windows left of it.", "door@south end:right; 2 window@south"},
      {"A door on the west wall, at the far end.", "door@west end:far"},
      {"A back door to the toilets on the north wall at the left end.", "door@north end:left to:toilets"},
      {"The north wall is solid and has the door into the kitchen, right hand end.", "door@north end:right to:kitchen"},
      {"Leave the way to the balcony open.", "door outside to:balcony"},
      {"Glass on the south and half of the east side.", "window@south w100; window@east w100"},
  };
  for (const auto& [text, told] : kCases) EXPECT_EQ(Told(OpeningsIn(text)), told) << text;
  EXPECT_TRUE(OpeningsIn("A trapdoor as the only entrance.").other_way_in);
  EXPECT_TRUE(OpeningsIn("A bench on the window wall.").one_window_wall);
  EXPECT_EQ(OpeningsIn("A board on the windowless long wall.").bare_sides, std::vector<std::string>{"long"});
}

TEST(OpeningReader, ReadsThePlaceAlongTheWall) {
  const OpeningCase kCases[] = {
      {"A door in the middle of the west wall.", "door@west middle"},
      {"A door centred on the south wall.", "door@south middle"},
      {"A door on the south wall, in the middle.", "door@south middle"},
      {"A door at the left end of the south wall.", "door@south end:left"},
      {"A door in the south-west corner.", "door@south end:west"},
      {"A door on the west wall near the south corner.", "door@west end:south"},
      {"A door in the corner of the east wall.", "door@east end:"},
      {"A door on the west wall towards the north, a window on the long wall nearer the east.",
       "door@west end:north; window@long end:east"},
      {"A door in the north wall, by the west wall.", "door@north end:west"},
      {"A door in the south wall, at the far right.", "door@south end:right"},
      {"A door at the north-west corner, on the west wall.", "door@west end:north"},
      {"A window to the right on the north wall.", "window@north end:right"},
      {"A door at each end of the south wall.", "door@south end:left; door@south end:right"},
      {"You come in at the south-west corner.", "door@south end:west"},
      {"A door on the south wall, 50 cm from the left corner.", "door@south end:left +0.5"},
      {"A door 1 m from the west wall.", "door end:west +1"},
      {"In the middle of the north wall is a window.", "window@north middle"},
  };
  for (const auto& [text, told] : kCases) EXPECT_EQ(Told(OpeningsIn(text)), told) << text;
}

TEST(OpeningReader, ReadsMeasuresAndKinds) {
  const OpeningCase kCases[] = {
      {"A 1.2 m wide window on the north wall.", "window@north w1.2"},
      {"A window on the north wall, 1.2m wide.", "window@north w1.2"},
      {"Two 3 m windows on the north wall.", "2 window@north w3"},
      {"A 1.2 m x 1.5 m window.", "window w1.2 h1.5"},
      {"A 90cm door opening outwards.", "door w0.9 outward"},
      {"A bathroom, no door opening inwards.", "door outward"},
      {"A window with a sill at 1.1 m.", "window sill1.1"},
      {"Floor-to-ceiling windows along the south wall.", "2 window@south sill0 to-ceiling"},
      {"French windows to the garden on the east wall.", "door@east w1.5 outside to:garden"},
      {"A balcony door on the south wall.", "door@south outside to:balcony"},
      {"Patio doors on the west side.", "door@west w1.8 outside to:patio sliding"},
      {"A door leading out to the terrace.", "door w0.9 outside to:terrace"},
      {"A door to the kitchen on the east wall.", "door@east to:kitchen"},
      {"An en-suite door on the west wall.", "door@west to:en suite"},
      {"A sliding door.", "door sliding"},
      {"Double doors in the middle of the long wall.", "door@long middle w1.5"},
      {"An open doorway to the hall.", "door open"},
      {"A small high window and a large one.", "window sill1.6 small"},
      {"A wall of windows on the south.", "window@south w100"},
      {"The south wall is nearly all window.", "window@south w100"},
      {"One short wall is almost entirely glass.", "window@short w100"},
      {"A roller door 3 m wide on the south wall.", "door@south w3 sliding"},
      {"A sliding door in one of the long walls.", "door@long sliding"},
      {"A door to the garden in one of the long walls.", "door@long w0.9 outside to:garden"},
      {"A south-facing room.", "window@south ..."},
  };
  for (const auto& [text, told] : kCases) EXPECT_EQ(Told(OpeningsIn(text)), told) << text;
}

TEST(OpeningReader, LeavesWordsThatOnlyTellWhereSomethingElseIs) {
  for (const char* text :
       {"A desk by the window and a chair near the door.", "A bed facing away from the door.", "A window seat.",
        "Looking out of her window.", "A room with a doormat and a door handle.", "Nothing under any window."}) {
    EXPECT_EQ(Told(OpeningsIn(text)), "") << text;
  }
  EXPECT_TRUE(OpeningsIn("A desk by the window.").window_meant);
  // Their own place is told, once.
  EXPECT_EQ(Told(OpeningsIn("A desk under the window on the north wall.")), "window@north");
  EXPECT_EQ(Told(OpeningsIn("A window on the north wall and a desk under the window.")), "window@north");
  EXPECT_EQ(Told(OpeningsIn("Garden doors on the south wall, a sofa facing the garden doors.")),
            "door@south w1.5 outside to:garden");
}

TEST(OpeningReader, ReadsGlassFrontsAndDoorsByWhatIsBehindThem) {
  const OpeningCase kCases[] = {
      {"A coffee shop with a full glass front and the entrance in the middle of it.",
       "window@near w100 sill0; door@near middle"},
      {"Bar, glazed shopfront on the street with the door at its left end.",
       "window@near w100 sill0; door@near end:left"},
      {"You come in from the west.", "door@west"},
      {"It is entered on the short side. As you enter the window is on the left.", "door@short; window@left"},
      {"A salon with a glazed front.", "window@near w100 sill0"},
      {"A shop with a glass facade on the south wall.", "window@south w100 sill0"},
      {"The door from the hall is on the north side.", "door@north"},
      {"A reading room with tall windows down one long side.", "2 window@long h2 sill0.4"},
      {"One large window in front of the door.", "window@far large"},
      {"A dressing table on the right wall beside the window.", "window@right"},
  };
  for (const auto& [text, told] : kCases) EXPECT_EQ(Told(OpeningsIn(text)), told) << text;
}

TEST(OpeningReader, ReadsThatThereAreNone) {
  for (const char* text : {"A room with no windows.", "A windowless room.", "A room without any windows.",
                           "A cellar without a window.", "A gym with no natural light.", "There are no windows."}) {
    const OpeningWishes openings = OpeningsIn(text);
    EXPECT_TRUE(openings.no_windows) << text;
    EXPECT_TRUE(openings.wishes.empty()) << text;
  }
  const OpeningWishes bare = OpeningsIn("A room with no windows on the north wall.");
  EXPECT_FALSE(bare.no_windows);
  EXPECT_EQ(bare.bare_sides, std::vector<std::string>{"north"});
}

TEST(OpeningReader, SaysWhatItCannotTake) {
  for (const char* text :
       {"A bedroom with a skylight.", "A window above the sink.", "A door in the 4 m wall.",
        "A door in the corner of the 4 m wall.", "The door is on the south wall. The door is on the north wall.",
        "A windowless room with a window on the east wall.", "No windows, and a desk under the window."}) {
    EXPECT_EQ(OpeningsIn(text).not_read.size(), 1u) << text;
  }
}

TEST(OpeningReader, MarksWhatItHasUsed) {
  const std::vector<Token> tokens = TokensOf("desk under the window on the north wall");
  std::vector<bool> used(tokens.size());
  OpeningWishes openings;
  ReadOpenings(tokens, std::vector<bool>(tokens.size()), used, openings);
  EXPECT_FALSE(used[1]) << "\"under\" tells where the desk is";
  EXPECT_TRUE(used[7]) << "the wall is the window's";
}

// Twice the text takes about twice the time: a bounded number of words is looked at for each opening.
TEST(OpeningReader, IsLinear) {
  const auto seconds = [](std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i)
      text += "a door on the on the window, one in the middle of both the two windows ";
    const auto start = std::chrono::steady_clock::now();
    OpeningsIn(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  seconds(100);
  EXPECT_LT(seconds(4000), 40 * seconds(400) + 0.05);
}

}  // namespace
}  // namespace flair::language
