// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/size_phrase.h"

#include <gtest/gtest.h>

#include <string>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

absl::StatusOr<SizeRequest> Read(const std::string& text) {
  const std::vector<Token> tokens = TokensOf(text);
  std::vector<bool> used(tokens.size());
  return ReadSize(tokens, TheHandbook(), used);
}

struct PairCase {
  const char* name;
  const char* text;
  double width_m;
  double depth_m;
};

class SizePair : public testing::TestWithParam<PairCase> {};

TEST_P(SizePair, GivesWidthAndDepthInMetres) {
  const absl::StatusOr<SizeRequest> size = Read(GetParam().text);
  ASSERT_TRUE(size.ok()) << size.status();
  ASSERT_TRUE(size->width_m && size->depth_m) << GetParam().text;
  EXPECT_NEAR(*size->width_m, GetParam().width_m, 1e-6);
  EXPECT_NEAR(*size->depth_m, GetParam().depth_m, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Forms, SizePair,
    testing::Values(PairCase{"metres", "A bedroom that is 4m x 5m.", 4, 5}, PairCase{"unit_once", "4 x 5 m", 4, 5},
                    PairCase{"open_side", "Roughly 7 x 4 m, open towards the hall", 7, 4},
                    PairCase{"no_unit", "A bedroom that is 5x5 for a young girl", 5, 5},
                    PairCase{"decimals", "3.225m x 4.5m", 3.225, 4.5}, PairCase{"comma", "3,5 x 4", 3.5, 4},
                    PairCase{"by_words", "4 by 5 metres", 4, 5}, PairCase{"times_sign", "4 \u00d7 5", 4, 5},
                    PairCase{"feet", "12ft by 10ft", 3.6576, 3.048},
                    PairCase{"feet_once", "12 x 14 feet", 3.6576, 4.2672},
                    PairCase{"feet_inches", "12'6\" x 14'", 3.81, 4.2672},
                    PairCase{"curly_feet", "12\u2019 x 14\u2019", 3.6576, 4.2672},
                    PairCase{"feet_and_no_inches", "Clear 8'-0\" x 10'-6\"", 2.4384, 3.2004},
                    PairCase{"inches_apart", "9 ft x 11 ft 3 in", 2.7432, 3.429},
                    PairCase{"two_marks", "9'6'' by 11'", 2.8956, 3.3528},
                    PairCase{"said_feet", "ten foot six by twelve foot", 3.2004, 3.6576},
                    PairCase{"metres_and_rest", "5 m by 2 m 80", 5, 2.8},
                    PairCase{"said_metres", "four metres twenty by three ten", 4.2, 3.1},
                    PairCase{"said_point", "two point six by three point seven five metres", 2.6, 3.75},
                    PairCase{"said_quarters", "three and a quarter metres by four and three quarters", 3.25, 4.75},
                    PairCase{"unit_once_said", "six metres by four fifty", 6, 4.5},
                    PairCase{"long_by_wide", "6 m long by 4 m wide", 4, 6},
                    PairCase{"sides_named", "Study. Width 3 m, length: 4.5 m", 3, 4.5},
                    PairCase{"a_loo", "A loo, 0.8 x 1.6 m", 0.8, 1.6},
                    PairCase{"tiles_first", "Tiles of 30 x 30 cm. The bathroom is 2 x 3 m.", 2, 3},
                    PairCase{"centimetres", "240cm x 300cm", 2.4, 3}, PairCase{"millimetres", "3600 x 4200", 3.6, 4.2},
                    PairCase{"bare_centimetres", "350 x 420", 3.5, 4.2}, PairCase{"by_name", "8m long, 4m wide", 4, 8},
                    PairCase{"no_blanks", "A study of 3mx4m", 3, 4}, PairCase{"sign_no_blanks", "4m\u00d75m", 4, 5},
                    PairCase{"cm_no_blanks", "400cmx500cm", 4, 5}, PairCase{"square", "a 5 m square studio", 5, 5}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(ReadSize, ReadsAreas) {
  EXPECT_NEAR(*Read("20 square metres")->area_m2, 20, 1e-9);
  EXPECT_NEAR(*Read("a 20 m2 room")->area_m2, 20, 1e-9);
  EXPECT_NEAR(*Read("20 m\u00b2")->area_m2, 20, 1e-9);
  EXPECT_NEAR(*Read("20 sqm")->area_m2, 20, 1e-9);
  EXPECT_NEAR(*Read("215 sq ft")->area_m2, 19.974, 1e-3);
}

TEST(ReadSize, KeepsTheCeilingApartFromTheSides) {
  const SizeRequest size = *Read("a 4 x 5 m room with a 2.7m ceiling");
  EXPECT_NEAR(*size.height_m, 2.7, 1e-9);
  EXPECT_NEAR(*size.width_m, 4, 1e-9);
}

TEST(ReadSize, TheHeightMayStandBeforeItsNumber) {
  EXPECT_FALSE(Read("A guest room with at least 2 by 2 m of bare floor")->in_numbers());
  EXPECT_FALSE(Read("A railway room. Large layout table 3.5 m x 1.5 m he can walk around.")->in_numbers());
  EXPECT_DOUBLE_EQ(*Read("A captain's cabin of 4 x 5 m. Low ceiling, maybe 1.9 m.")->height_m, 1.9);
  EXPECT_FALSE(Read("A model railway room of 4 x 5 m, the layout at 1.2 m high")->height_m.has_value());
  for (const char* text : {"A room of 4 x 5 m. Height 2.4 m.", "a 4 x 5 m room with a ceiling of 2.4 m",
                           "a 4 x 5 m room, ceiling height: 2.4 m", "a 4 x 5 m room, the ceiling is at 2.4 m"}) {
    const SizeRequest size = *Read(text);
    ASSERT_TRUE(size.height_m.has_value()) << text;
    EXPECT_NEAR(*size.height_m, 2.4, 1e-9) << text;
    EXPECT_NEAR(*size.width_m, 4, 1e-9) << text;
  }
}

TEST(ReadSize, ASquareRoomOfAnAreaIsSquare) {
  EXPECT_EQ(*Read("a square room of 20 square metres")->side_ratio, 1);
  EXPECT_FALSE(Read("a room of 20 square metres")->side_ratio.has_value());
}

TEST(ReadSize, KnowsSizeWords) {
  EXPECT_EQ(Read("a small narrow room")->area_factor, 0.75);
  EXPECT_EQ(*Read("a small narrow room")->side_ratio, 0.5);
  EXPECT_FALSE(Read("a room")->in_numbers());
}

TEST(ReadSize, LeavesTheSizesOfThingsInTheRoomAlone) {
  for (const char* text :
       {"A bedroom with a 0.6m x 0.4m desk", "A living room, TV 65 inches, 120cm x 60cm coffee table",
        "a bedroom with a desk of 1.6 m x 0.8 m", "a bedroom with a desk (1.6 x 0.8 m)", "a 2.4 m high bookshelf",
        "a 2 m long sofa", "a studio with canvases of 3m x 2m", "a room for a giant who is 20 m tall",
        "a bedroom with a solid oak desk that is 1.8 m wide", "a bedroom with a 2m x 2m double bed"}) {
    const absl::StatusOr<SizeRequest> size = Read(text);
    ASSERT_TRUE(size.ok()) << text << ": " << size.status();
    EXPECT_FALSE(size->in_numbers()) << text;
    EXPECT_FALSE(size->height_m.has_value()) << text;
  }
}

TEST(ReadSize, WhatIsSaidOfEachIsNotSaidOfTheRoom) {
  for (const char* text : {"An office with two desks at the window, 140 x 70 cm each.",
                           "A classroom with tables, each 2.4 x 1.2 m", "A study, door width 0.9 m"}) {
    const absl::StatusOr<SizeRequest> size = Read(text);
    ASSERT_TRUE(size.ok()) << size.status();
    EXPECT_FALSE(size->in_numbers()) << text;
  }
}

TEST(ReadSize, SizeWordsOfThingsAndPeopleAreNotTheRooms) {
  for (const char* text :
       {"a bedroom with a small desk", "A bedroom, small desk and sofa", "a music room with a grand piano",
        "a living room with a baby grand", "a living room with small windows", "a bedroom for a little girl",
        "a bedroom with a bed and a small aquarium", "a bedroom with a sofa that is small"}) {
    EXPECT_EQ(Read(text)->area_factor, 1) << text;
  }
  for (const char* text : {"a small bedroom with a desk", "a bedroom that is small", "a bedroom, small and bright",
                           "a bedroom for two, small", "a small bedroom for a little girl", "small",
                           "a small solid bedroom with a grand piano", "a sofa and a desk in a small room"}) {
    EXPECT_EQ(Read(text)->area_factor, 0.75) << text;
  }
}

TEST(ReadSize, FindsTheRoomsSizeBesideThoseOfThings) {
  for (const char* text : {"A bedroom with a 1.6m x 2m bed, 4m x 5m", "A 4m x 5m bedroom with a 0.6m x 0.4m desk",
                           "A bedroom of 4m x 5m with a bed", "a boutique of 4m x 5m", "a 4 x 5 m piano room",
                           "A bedroom with a desk and a bed, 4m x 5m", "a 4 x 5 m music room with a 2.4 m wide piano",
                           "bed, desk, sofa; 4m x 5m", "A 4m x 5m space for a sofa"}) {
    const absl::StatusOr<SizeRequest> size = Read(text);
    ASSERT_TRUE(size.ok()) << text << ": " << size.status();
    ASSERT_TRUE(size->width_m && size->depth_m) << text;
    EXPECT_EQ(*size->width_m, 4) << text;
    EXPECT_EQ(*size->depth_m, 5) << text;
  }
}

TEST(ReadSize, RefusesImpossibleRoomsAndNamesTheValue) {
  for (const char* text : {"A bedroom that is 0m x -3m", "a 0.5m x 0.5m room", "a 200 m x 200 m room", "4m x -3m",
                           "0.3 square metres", "a 4 x 5 room with a 40m ceiling"}) {
    const absl::StatusOr<SizeRequest> size = Read(text);
    ASSERT_FALSE(size.ok()) << text;
    EXPECT_EQ(size.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_NE(std::string(size.status().message()).find("brief.text: a "), std::string::npos) << size.status();
  }
}

TEST(ReadSize, SurvivesHostileText) {
  for (const std::string& text : {std::string(100000, '9'), std::string(50000, '\''), std::string("4\x01 x\x7f 5"),
                                  std::string("\xf0\x9f\x9b\x8f 4x5 \xff\xfe"), std::string("x x x 4 x x 5")}) {
    const absl::StatusOr<SizeRequest> size = Read(text);
    if (size.ok() && size->width_m) EXPECT_GE(*size->width_m, 1);
  }
}

}  // namespace
}  // namespace flair::language
