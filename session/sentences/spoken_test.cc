// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/spoken.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "room/conversion/conversion.h"

namespace flair::session {
namespace {

// A room of 6 m x 4 m with a few pieces.
class SpokenTest : public ::testing::Test {
 protected:
  SpokenTest() {
    *layout_.mutable_graph()->mutable_room() = RoomToProto(RectangularRoom(6, 4));
    for (const auto& [id, name, x_m] :
         std::vector<std::tuple<std::string, std::string, double>>{{"sofa", "sofa", 1},
                                                                   {"armchair", "armchair", 2},
                                                                   {"dining_table", "dining table", 3},
                                                                   {"dining_chair_1", "dining chair", 2.5},
                                                                   {"dining_chair_2", "dining chair", 3.5},
                                                                   {"floor_lamp", "floor lamp", 5},
                                                                   {"area_rug", "area rug", 1},
                                                                   {"wall_clock", "wall clock", 3},
                                                                   {"bookshelf", "bookshelf", 5.5},
                                                                   {"television", "television", 1}}) {
      v1::Object& object = *layout_.mutable_graph()->mutable_object_list()->add_objects();
      object.set_id(id);
      object.set_name(name);
      object.set_kind(id == "wall_clock" ? v1::OBJECT_KIND_WALL : v1::OBJECT_KIND_FLOOR);
      v1::Placement& at = *layout_.add_placements();
      at.set_object_id(id);
      at.set_x_m(x_m);
    }
  }

  // What is read of every clause: its act, pieces, and what else it says.
  std::string Read(const std::string& text) {
    const FindPiece find = [](const std::string& name) -> std::optional<v1::Object> {
      static const std::map<std::string, std::string> known = {{"pouf", "ottoman"},
                                                               {"couch", "sofa"},
                                                               {"tv", "television"},
                                                               {"carpet", "area rug"},
                                                               {"plant", "floor plant"},
                                                               {"bookcase", "bookshelf"},
                                                               {"visitor chair", "visitor chair"}};
      const auto found = known.find(name);
      if (found == known.end()) return std::nullopt;
      v1::Object object;
      object.set_name(found->second);
      return object;
    };
    const IdSet selected;
    const ObjectIds last;
    const MeantPieces pieces(layout_, selected, last, find);
    const Room room = RectangularRoom(6, 4);
    std::vector<std::string> clauses;
    const Tokens tokens = PlainTokens(text);
    for (Span span{0, tokens.size()}, rest; !span.empty(); span = rest) {
      clauses.push_back(TextOf(SpokenReader(pieces, room).Read(text, tokens, span, rest)));
    }
    return absl::StrJoin(clauses, "; ");
  }

  static std::string TextOf(const Spoken& spoken) {
    if (spoken.act.empty()) return "\"" + spoken.said + "\"";
    std::vector<std::string> texts = {spoken.act};
    if (!spoken.absent.empty()) texts.push_back("no " + spoken.absent);
    if (spoken.what.is_one) texts.emplace_back(spoken.what.is_told ? "which of" : "one of");
    texts.insert(texts.end(), spoken.what.ids.begin(), spoken.what.ids.end());
    if (!spoken.other.ids.empty()) texts.push_back("and " + absl::StrJoin(spoken.other.ids, " "));
    if (spoken.by.has_value()) texts.push_back("by " + spoken.by->object.name());
    if (spoken.length_m.has_value()) texts.push_back(fmt::format("{:.2f}", *spoken.length_m));
    if (!spoken.size_m.empty()) texts.push_back(fmt::format("{:.2f}", fmt::join(spoken.size_m, "x")));
    for (const std::string& change : spoken.changes) texts.push_back(change);
    if (!spoken.dimension.empty()) texts.push_back(spoken.dimension);
    if (!spoken.way.empty()) texts.push_back(spoken.way);
    if (!spoken.target.kind.empty()) texts.push_back((spoken.is_away ? "from " : "to ") + spoken.target.kind);
    if (!spoken.place.empty()) texts.push_back("[" + spoken.place + "]");
    return absl::StrJoin(texts, " ");
  }

  v1::SolvedLayout layout_;
};

TEST_F(SpokenTest, PiecesGo) {
  for (const char* const text :
       {"remove the wall clock", "Please take the clock away.", "no wall clock", "get rid of the clock",
        "can you delete the clock please?", "I don't want the clock any more", "the clock should go",
        "throw out the clock", "the wall clock is not needed", "make the clock disappear", "clock away"}) {
    EXPECT_EQ(Read(text), "remove wall_clock") << text;
  }
  EXPECT_EQ(Read("delete the lamp"), "remove floor_lamp");
  EXPECT_EQ(Read("remove the chairs"), "remove dining_chair_1 dining_chair_2");
  EXPECT_EQ(Read("one chair less"), "remove one of dining_chair_1 dining_chair_2");
  EXPECT_EQ(Read("remove the second dining chair"), "remove dining_chair_2");
  EXPECT_EQ(Read("remove the right chair"), "remove dining_chair_2");
  EXPECT_EQ(Read("delete the clock, the lamp and the sofa"), "remove wall_clock floor_lamp sofa");
  EXPECT_EQ(Read("remove the piano"), "remove no piano");
  // Those are other chairs.
  EXPECT_EQ(Read("remove the visitor chairs"), "remove no visitor chair");
}

TEST_F(SpokenTest, PiecesGetOtherSizes) {
  for (const char* const text :
       {"make the table longer", "the table should be longer", "the table is too short", "I need a longer table"}) {
    EXPECT_EQ(Read(text), "resize dining_table more long") << text;
  }
  EXPECT_EQ(Read("make the carpet bigger"), "resize area_rug more big");
  EXPECT_EQ(Read("the rug is too big"), "resize area_rug less big");
  EXPECT_EQ(Read("the table is 3 m long"), "resize to dining_table 3.00 long");
  EXPECT_EQ(Read("make the table 20 cm longer"), "resize by dining_table 0.20 more long");
  EXPECT_EQ(Read("make the rug 2.4 by 2.2 m"), "resize to area_rug 2.40x2.20");
  EXPECT_EQ(Read("make the rug 240x220 cm"), "resize to area_rug 2.40x2.20");
  EXPECT_EQ(Read("enlarge the table"), "resize more big dining_table");
  // A sentence about places is none about sizes.
  EXPECT_EQ(Read("The table is 3 m from the sofa"), "\"The table is 3 m from the sofa\"");
}

TEST_F(SpokenTest, PiecesAreReplacedAndSwapped) {
  for (const char* const text : {"swap the armchair for a pouf", "replace the armchair with a pouf",
                                 "use a pouf instead of the armchair", "I'd rather have a pouf than the armchair"}) {
    EXPECT_EQ(Read(text), "replace armchair by ottoman") << text;
  }
  EXPECT_EQ(Read("replace the dining chairs with visitor chairs"),
            "replace dining_chair_1 dining_chair_2 by visitor chair");
  for (const char* const text :
       {"swap the sofa and the bookshelf", "swap sofa with bookcase", "the sofa and the bookshelf change places",
        "exchange the positions of the couch and the bookcase", "put the sofa where the bookshelf is"}) {
    EXPECT_EQ(Read(text), "swap sofa and bookshelf") << text;
  }
}

TEST_F(SpokenTest, PiecesMoveAndTurn) {
  EXPECT_EQ(Read("move the sofa 20 cm to the left"), "move by sofa 0.20 west");
  EXPECT_EQ(Read("push the sofa half a metre south"), "move by sofa 0.50 south");
  EXPECT_EQ(Read("the armchair is 60 cm west of the bookshelf"), "set off armchair 0.60 west to object");
  EXPECT_EQ(Read("put the armchair 20 cm to the right of the sofa"), "set off armchair 0.20 east to object");
  EXPECT_EQ(Read("move the sofa closer to the window"), "move by sofa to window");
  EXPECT_EQ(Read("the sofa is too close to the tv"), "move by sofa from object");
  EXPECT_EQ(Read("move the sofa to the opposite wall"), "place sofa [to the opposite wall]");
  for (const char* const text :
       {"turn the armchair towards the television", "make the armchair face the tv", "point the armchair at the tv"}) {
    EXPECT_EQ(Read(text), "turn armchair to object") << text;
  }
  EXPECT_EQ(Read("rotate the sofa"), "turn by sofa");
  EXPECT_EQ(Read("turn the sofa around"), "turn by sofa around");
  EXPECT_EQ(Read("the sofa has the window on its left"), "sentence on the left sofa to window");
}

TEST_F(SpokenTest, ClausesAreReadApart) {
  EXPECT_EQ(Read("add a plant in the south-east corner and make the rug bigger"),
            "\"add a plant in the south-east corner\"; resize area_rug more big");
  EXPECT_EQ(Read("remove the clock, then turn the sofa around"), "remove wall_clock; turn by sofa around");
  EXPECT_EQ(Read("remove the rug and the sofa should face the window"),
            "remove area_rug; \"the sofa should face the window\"");
  // One sentence about two things stays one.
  EXPECT_EQ(Read("The sofa is against a wall and faces the television"),
            "\"The sofa is against a wall and faces the television\"");
  EXPECT_EQ(Read("Add a plant and a bookcase"), "\"Add a plant and a bookcase\"");
  EXPECT_EQ(Read("two more chairs"), "\"two more chairs\"");
}

TEST_F(SpokenTest, PiecesAreToldByTheirPlaces) {
  for (const char* const text :
       {"Please remove the clock above the table", "I do not want the clock above the dining table",
        "the clock that hangs above the table should go", "get rid of the clock over the table"}) {
    EXPECT_EQ(Read(text), "remove wall_clock") << text;
  }
  EXPECT_EQ(Read("get rid of the lamp next to the bookshelf because it is in the way"), "remove floor_lamp; reason");
  EXPECT_EQ(Read("remove the chair on the left"), "remove dining_chair_1");
  EXPECT_EQ(Read("the chair at the right end of the table should go"), "remove dining_chair_2");
  EXPECT_EQ(Read("remove the chair to the left of the dining table"), "remove dining_chair_1");
  EXPECT_EQ(Read("remove the chair at the table"), "remove which of dining_chair_1 dining_chair_2");
  EXPECT_EQ(Read("remove a chair at the table"), "remove one of dining_chair_1 dining_chair_2");
  EXPECT_EQ(Read("move the lamp by the bookcase 20 cm to the left"), "move by floor_lamp 0.20 west");
  EXPECT_EQ(Read("swap the chair on the left and the lamp next to the bookshelf"),
            "swap dining_chair_1 and floor_lamp");
  // What does not stand there is not meant.
  EXPECT_EQ(Read("remove the clock above the sofa"), "remove no clock above the sofa");
  // A place to go to is none to be found at.
  EXPECT_EQ(Read("put the lamp in the corner"), "place floor_lamp [in the corner]");
  EXPECT_EQ(Read("move the sofa next to the armchair"), "place sofa [next to the armchair]");
}

TEST_F(SpokenTest, ReasonsAskForNothing) {
  EXPECT_EQ(Read("remove the clock, I do not like it"), "remove wall_clock; reason");
  EXPECT_EQ(Read("remove the clock because it is ugly and turn the sofa around"),
            "remove wall_clock; reason; turn by sofa around");
  EXPECT_EQ(Read("make the table longer so that we have more space"), "resize dining_table more long; reason");
  // Alone it is no reason.
  EXPECT_EQ(HistoryAsked("I do not like it"), "another layout");
}

TEST_F(SpokenTest, MoreWordsForTheSame) {
  EXPECT_EQ(Read("Instead of the armchair I want a pouf"), "replace armchair by ottoman");
  EXPECT_EQ(Read("turn the sofa around by 90 degrees"), "turn by sofa");
}

TEST_F(SpokenTest, TheHistoryIsAskedForInWords) {
  EXPECT_EQ(HistoryAsked("undo"), "undo");
  EXPECT_EQ(HistoryAsked("please take that back"), "undo");
  EXPECT_EQ(HistoryAsked("Show me another layout"), "another layout");
  EXPECT_EQ(HistoryAsked("can you arrange the furniture differently?"), "another layout");
  EXPECT_EQ(HistoryAsked("remove the sofa"), "");
  EXPECT_EQ(HistoryAsked(""), "");
}

TEST_F(SpokenTest, LongNonsenseIsReadInTime) {
  std::string text;
  for (int i = 0; i < 60; ++i) text += "and the ";
  EXPECT_NE(Read(text), "");
}

}  // namespace
}  // namespace flair::session
