// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/classes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace flair::renderer {
namespace {

v1::Object Named(const std::string& name, v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR) {
  v1::Object object;
  object.set_name(name);
  object.set_kind(kind);
  return object;
}

TEST(Classes, AreSortedWithoutRepeatsAndEachHasItsOwnNumber) {
  EXPECT_TRUE(std::is_sorted(FurnitureClasses().begin(), FurnitureClasses().end()));
  std::set<int> ids;
  for (size_t i = 0; i < FurnitureClasses().size(); ++i) {
    const int id = ClassIdOf(FurnitureClasses()[i]);
    EXPECT_GE(id, 1);
    EXPECT_TRUE(ids.insert(id).second) << FurnitureClasses()[i];
  }
  EXPECT_EQ(ClassIdOf("whatchamacallit"), 0);
  EXPECT_EQ(ClassIdOf(""), 0);
}

// Pictures that people have made hold these numbers.
TEST(Classes, KeepTheirNumbers) {
  EXPECT_EQ(ClassIdOf("aquarium"), 1);
  EXPECT_EQ(ClassIdOf("bed"), 8);
  EXPECT_EQ(ClassIdOf("box"), 13);
  EXPECT_EQ(ClassIdOf("plant"), 61);
  EXPECT_EQ(ClassIdOf("workbench"), 103);
}

// A table and not a line of test each: compiling those took half a minute.
constexpr std::pair<const char*, const char*> kWords[] = {
#define WORDS(words, class_name) {words, class_name},
#include "renderer_worker/furniture/class_words.inc"
#undef WORDS
};

TEST(Classes, EveryWordLeadsToAClass) {
  for (const auto& [words, class_name] : kWords) {
    EXPECT_GT(ClassIdOf(class_name), 0) << words << " -> " << class_name;
  }
}

TEST(Classes, NoWordIsGivenTwice) {
  std::set<std::string> seen;
  for (const auto& [words, class_name] : kWords) {
    EXPECT_TRUE(seen.insert(words).second) << words;
  }
}

TEST(Classes, FreeNamesFindTheirClass) {
  const std::pair<const char*, const char*> cases[] = {{"king-size bed", "bed"},
                                                       {"Chest of Drawers", "dresser"},
                                                       {"desk lamp", "table_lamp"},
                                                       {"arc floor lamp", "floor_lamp"},
                                                       {"oak bookshelves", "bookshelf"},
                                                       {"adjustable dumbbell set", "weights"},
                                                       {"stack of books", "books"},
                                                       {"bedside table", "nightstand"},
                                                       {"dining chairs", "chair"},
                                                       {"velvet-lined coffin", "coffin"},
                                                       {"potted plant with basket", "plant"},
                                                       {"suit of armor", "statue"},
                                                       {"wizard's cauldron", "cauldron"},
                                                       {"mattress", "bed"},
                                                       {"wine barrel", "barrel"},
                                                       {"grandfather clock", "clock"},
                                                       {"privacy screen", "folding_screen"},
                                                       {"weaving loom", "loom"},
                                                       {"wardrobe with mirror", "wardrobe"},
                                                       {"vanity with sink", "basin"},
                                                       {"desklamp", "floor_lamp"},
                                                       {"jewelrybox", "trunk"},
                                                       {"throwpillow 2", "cushion"},
                                                       {"fiddle leaf fig", "plant"},
                                                       {"bed frame", "bed"},
                                                       {"dressing table", "vanity"}};
  for (const auto& [name, class_name] : cases) EXPECT_EQ(ClassOf(Named(name)), class_name) << name;
}

TEST(Classes, UnknownNamesAreABox) {
  EXPECT_EQ(ClassOf(Named("whatchamacallit")), "box");
  EXPECT_EQ(ClassOf(Named("")), "box");
  EXPECT_EQ(ClassOf(Named(std::string(10000, 'x'))), "box");
  EXPECT_EQ(ClassFromWords("whatchamacallit"), "");
}

TEST(Classes, TheNameWinsOverTheCategoryWhichHelpsWhenTheNameSaysNothing) {
  v1::Object object = Named("office chair");
  object.set_category("chair");
  EXPECT_EQ(ClassOf(object), "office_chair");
  object.set_name("Old Faithful");
  EXPECT_EQ(ClassOf(object), "chair");
  object.set_name("mushroom table");
  object.set_category("round_table");
  EXPECT_EQ(ClassOf(object), "round_table");
  object.set_name("Old Faithful");
  object.set_category("");
  object.set_id("chair_3");
  EXPECT_EQ(ClassOf(object), "chair");
}

TEST(Classes, WhatCarriesItTellsLampsAndRacksApart) {
  EXPECT_EQ(ClassOf(Named("lamp", v1::OBJECT_KIND_CEILING)), "pendant");
  EXPECT_EQ(ClassOf(Named("lamp", v1::OBJECT_KIND_WALL)), "wall_lamp");
  EXPECT_EQ(ClassOf(Named("lamp", v1::OBJECT_KIND_SURFACE)), "table_lamp");
  EXPECT_EQ(ClassOf(Named("torch stand")), "floor_lamp");
  EXPECT_EQ(ClassOf(Named("coat rack", v1::OBJECT_KIND_WALL)), "rack");
  EXPECT_EQ(ClassOf(Named("hats on hooks", v1::OBJECT_KIND_WALL)), "rack");
  EXPECT_EQ(ClassOf(Named("coat rack")), "coat_stand");
  EXPECT_EQ(ClassOf(Named("lamp desk", v1::OBJECT_KIND_SURFACE)), "table_lamp");
}

}  // namespace
}  // namespace flair::renderer
