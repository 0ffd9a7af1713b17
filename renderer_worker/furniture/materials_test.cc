// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> Named(std::string_view text) {
  std::vector<std::string> names;
  for (const BaseMaterial* material : MaterialsInWords(text)) names.emplace_back(material->name);
  return names;
}

TEST(Materials, EveryWordMeansAMaterialAndNoWordMeansTwo) {
  std::set<std::string> seen;
  for (const FurnitureMaterial& material : Furniture().material()) {
    EXPECT_EQ(BaseMaterialOf(material.name()).name, material.name());
    for (const std::string& word : material.words()) {
      EXPECT_TRUE(seen.insert(word).second) << word;
      EXPECT_THAT(Named(word), ElementsAre(material.name())) << word;
    }
  }
}

TEST(Materials, AreWhatTheGltfModelAllows) {
  for (const BaseMaterial& material : BaseMaterials()) {
    EXPECT_GT(material.look.roughness, 0) << material.name;
    EXPECT_LE(material.look.roughness, 1) << material.name;
    EXPECT_GE(material.look.metallic, 0) << material.name;
    EXPECT_LE(material.look.metallic, 1) << material.name;
    for (const float channel : {material.look.colour.x, material.look.colour.y, material.look.colour.z}) {
      EXPECT_GT(channel, 0) << material.name;
      EXPECT_LT(channel, 0.9F) << material.name;
    }
  }
}

TEST(Materials, AreReadFromFreeText) {
  EXPECT_THAT(Named("walnut and brass"), ElementsAre("walnut", "brass"));
  EXPECT_THAT(Named("Metal frame with walnut wooden shelves"), ElementsAre("metal", "walnut"));
  EXPECT_THAT(Named("Velvet-upholstered, with chrome legs"), ElementsAre("velvet", "linen", "chrome"));
  EXPECT_THAT(Named("rattan and linen"), ElementsAre("rattan", "linen"));
  EXPECT_THAT(Named("Scandinavian minimalist"), IsEmpty());
  EXPECT_THAT(Named(""), IsEmpty());
}

v1::ObjectStyle Style(const std::string& material, const std::string& colour, int red, int green, int blue) {
  v1::ObjectStyle style;
  style.set_material(material);
  style.mutable_colour()->set_name(colour);
  style.mutable_colour()->set_red(red), style.mutable_colour()->set_green(green),
      style.mutable_colour()->set_blue(blue);
  return style;
}

ClassMaterials Sofa() {
  ClassMaterials materials;
  materials.set_hard("walnut");
  materials.set_styled(ClassMaterials::SOFT);
  return materials;
}

const ClassMaterials kSofa = Sofa(), kTable;

TEST(Palette, TheColourOfASofaIsThatOfItsCloth) {
  const v1::ObjectStyle style = Style("linen", "sage", 150, 170, 140);
  const Palette palette = PaletteOf(kSofa, {}, &style);
  EXPECT_GT(palette.soft.colour.y, palette.soft.colour.x);
  EXPECT_EQ(palette.hard.colour, BaseMaterialOf("walnut").look.colour);
}

TEST(Palette, TheNameOfAColourMaySayThatItIsTheWoods) {
  const v1::ObjectStyle style = Style("upholstered", "dark walnut", 70, 45, 30);
  const Palette palette = PaletteOf(kSofa, {}, &style);
  EXPECT_EQ(palette.hard.colour, LinearHex(0x462D1E));
  EXPECT_EQ(palette.soft.colour, BaseMaterialOf("linen").look.colour);
}

TEST(Palette, AWhiteOakTableIsPaintedAndABrownOneIsNot) {
  const v1::ObjectStyle white = Style("oak", "white", 245, 245, 242), brown = Style("oak", "brown", 140, 100, 60);
  EXPECT_EQ(PaletteOf(kTable, {}, &white).hard.pattern, Pattern::kPlain);
  EXPECT_THAT(PaletteOf(kTable, {}, &white).hard.name, HasSubstr("painted"));
  EXPECT_EQ(PaletteOf(kTable, {}, &brown).hard.pattern, Pattern::kWood);
}

TEST(Palette, TheSecondMaterialIsForFittings) {
  const v1::ObjectStyle style = Style("brass and walnut", "walnut", 107, 70, 48);
  const Palette palette = PaletteOf(kTable, {}, &style);
  EXPECT_THAT(palette.hard.name, HasSubstr("walnut"));
  EXPECT_THAT(palette.metal.name, HasSubstr("brass"));
}

TEST(Palette, TheNameOfAPieceCountsWhereNoStyleIsKnown) {
  v1::Object object;
  object.set_name("stone bench");
  EXPECT_THAT(PaletteOf(kTable, object, nullptr).hard.name, HasSubstr("stone"));
}

}  // namespace
}  // namespace flair::renderer
