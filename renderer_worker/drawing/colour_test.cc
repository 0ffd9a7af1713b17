// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "renderer_worker/drawing/canvas.h"

namespace flair::renderer {
namespace {

TEST(Colour, OklchGoesThereAndBack) {
  for (unsigned value : {0x000000u, 0xFFFFFFu, 0x5C0C14u, 0x8FA288u, 0x123456u, 0xFE8010u}) {
    const Rgb colour = Hex(value), back = FromOklch(ToOklch(colour));
    EXPECT_NEAR(colour.red, back.red, 2e-3) << std::hex << value;
    EXPECT_NEAR(colour.green, back.green, 2e-3) << std::hex << value;
    EXPECT_NEAR(colour.blue, back.blue, 2e-3) << std::hex << value;
  }
}

TEST(Colour, EvenBlackFurnitureIsLightEnoughToPrintOn) {
  for (unsigned value = 0; value <= 0xFFFFFF; value += 0x1F3A7) {
    const double fill = ToOklch(SoftenForPrint(Hex(value))).lightness;
    EXPECT_GT(fill, 0.6);
    EXPECT_GT(fill - ToOklch(LineColourFor(SoftenForPrint(Hex(value)))).lightness, 0.25);
    EXPECT_GT(ToOklch(TintForPrint(Hex(value))).lightness, 0.9);
  }
}

TEST(Colour, OrderByLightnessSurvives) {
  EXPECT_LT(ToOklch(SoftenForPrint(Hex(0x101010))).lightness, ToOklch(SoftenForPrint(Hex(0x808080))).lightness);
  EXPECT_LT(ToOklch(SoftenForPrint(Hex(0x808080))).lightness, ToOklch(SoftenForPrint(Hex(0xF0F0F0))).lightness);
}

}  // namespace
}  // namespace flair::renderer
