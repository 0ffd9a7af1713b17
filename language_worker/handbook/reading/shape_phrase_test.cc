// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/shape_phrase.h"

#include <gtest/gtest.h>

#include "absl/status/statusor.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

class ShapePhrase : public testing::Test {
 protected:
  static ShapeRequest Read(const std::string& text) { return ReadShape(TokensOf(text), TheHandbook()); }
};

TEST_F(ShapePhrase, ReadsLettersInAllTheirSpellings) {
  EXPECT_EQ(Read("An L-shaped studio of 6 m x 5 m.").shape, RoomShape::kL);
  EXPECT_EQ(Read("A living room in the shape of comfort, L shaped, 30 m2").shape, RoomShape::kL);
  EXPECT_EQ(Read("A T-shaped 8m x 6m living room").shape, RoomShape::kT);
  EXPECT_EQ(Read("An office that is shaped like a U").shape, RoomShape::kU);
  EXPECT_EQ(Read("The living room is L-shaped with a round table.").shape, RoomShape::kL);
  EXPECT_EQ(Read("A bedroom with an L-shape floor").shape, RoomShape::kL);
}

TEST_F(ShapePhrase, ReadsWhatIsRoundOrHasManyWalls) {
  EXPECT_EQ(Read("A round bedroom.").shape, RoomShape::kRound);
  EXPECT_EQ(Read("A study in a turret, 5 m across").shape, RoomShape::kRound);
  EXPECT_EQ(Read("A wizard's tower study, circular, 6 metres across.").shape, RoomShape::kRound);
  EXPECT_EQ(Read("A study with a table, round, of oak.").shape, RoomShape::kRectangle);
  EXPECT_EQ(Read("An oval office of 30 m2").shape, RoomShape::kOval);
  EXPECT_EQ(Read("A hexagonal living room of 20 m2").shape, RoomShape::kHexagon);
  EXPECT_EQ(Read("The office is octagonal.").shape, RoomShape::kOctagon);
}

TEST_F(ShapePhrase, FurnitureHasShapesOfItsOwn) {
  for (const char* text :
       {"A living room with an L-shaped sofa.", "An office with an L-shaped desk for two.",
        "A dining room with a round dining table for six.", "A lounge with a curved sofa and a desk",
        "A room to sit in all year round.", "A study where I shape clay.", "The room's shape is good.",
        "A bedroom with hexagonal tiles.", "A bedroom that is 4m x 5m."}) {
    EXPECT_EQ(Read(text).shape, RoomShape::kRectangle) << text;
    EXPECT_EQ(Read(text).unknown, "") << text;
  }
}

TEST_F(ShapePhrase, NamesTheShapeThatCannotBeDrawn) {
  EXPECT_EQ(Read("A triangular living room of 20 m2").unknown, "triangular");
  EXPECT_EQ(Read("A bedroom in the attic.").unknown, "attic");
  EXPECT_EQ(Read("A Z-shaped office.").unknown, "Z-shaped");
}

}  // namespace
}  // namespace flair::language
