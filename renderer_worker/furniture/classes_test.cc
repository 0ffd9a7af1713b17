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
  std::set<int> ids;
  std::string before;
  for (const FurnitureClass& each : Furniture().furniture()) {
    EXPECT_LT(before, each.name());
    before = each.name();
    EXPECT_GE(each.id(), 1);
    EXPECT_TRUE(ids.insert(each.id()).second) << each.name();
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

TEST(Classes, EveryWordLeadsToItsClassAndNoWordIsGivenTwice) {
  std::set<std::string> seen;
  for (const FurnitureClass& each : Furniture().furniture()) {
    for (const auto& words : {each.words(), each.words_alone()}) {
      for (const std::string& word : words) {
        EXPECT_TRUE(seen.insert(word).second) << word;
        EXPECT_EQ(ClassFromWords(word), each.name()) << word;
      }
    }
  }
}

TEST(Classes, RecordsNameOnlyClassesThatThereAre) {
  for (const FurnitureClass& each : Furniture().furniture()) {
    for (const std::string& other :
         {each.on_floor(), each.wide_on_floor(), each.on_wall(), each.on_ceiling(), each.on_surface()}) {
      EXPECT_TRUE(other.empty() || ClassIdOf(other) > 0) << each.name() << " -> " << other;
    }
  }
}

// A model that contradicts the name is worse than a plain block.
TEST(Classes, ThingsThatOnlySoundLikeFurnitureArePlainBlocks) {
  const std::pair<const char*, const char*> cases[] = {
      {"lumber rack", "rack"},     {"table saw", "machine"}, {"skateboard", "board"},       {"bench vice", "box"},
      {"cat tree", "box"},         {"pedestal fan", "box"},  {"rocket model", "statue"},    {"papyrus scrolls", "box"},
      {"projector", "box"},        {"flashlight", ""},       {"chair lift motor", ""},      {"murphy bed", "bed"},
      {"foosball table", "table"}, {"water tank", "barrel"}, {"vending machine", "machine"}};
  for (const auto& [name, category] : cases) {
    v1::Object object = Named(name);
    object.set_category(category);
    EXPECT_EQ(ClassOf(object), "box") << name;
  }
  EXPECT_EQ(ClassOf(Named("planet mobile", v1::OBJECT_KIND_CEILING)), "box");
}

TEST(Classes, WhatHasAModelOfItsOwnIsNotWhatItsCategorySays) {
  const std::pair<const char*, const char*> cases[] = {{"hall tree", "hall_tree"},
                                                       {"kiln", "kiln"},
                                                       {"gold heap", "heap"},
                                                       {"suit of armour", "armour"},
                                                       {"server rack", "server_rack"},
                                                       {"hammock", "hammock"},
                                                       {"radiator", "radiator"},
                                                       {"corner sofa", "corner_sofa"},
                                                       {"corner desk", "corner_desk"},
                                                       {"squat rack", "power_rack"},
                                                       {"potter's wheel", "pottery_wheel"}};
  for (const auto& [name, class_name] : cases) EXPECT_EQ(ClassOf(Named(name)), class_name) << name;
}

TEST(Classes, AdjectivesLeaveAThingWhatItIs) {
  EXPECT_EQ(ClassOf(Named("large potted tree")), "plant");
  EXPECT_EQ(ClassOf(Named("wooden rack")), "coat_stand");
  EXPECT_EQ(ClassOf(Named("table, dining")), "table");
  EXPECT_EQ(ClassOf(Named("pair of wingback chairs (green)")), "wing_chair");
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
                                                       {"suit of armor", "armour"},
                                                       {"wizard's cauldron", "cauldron"},
                                                       {"mattress", "bed"},
                                                       {"wine barrel", "barrel"},
                                                       {"grandfather clock", "clock"},
                                                       {"privacy screen", "folding_screen"},
                                                       {"weaving loom", "loom"},
                                                       {"wardrobe with mirror", "wardrobe"},
                                                       {"vanity with sink", "basin"},
                                                       {"desklamp", "table_lamp"},
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
