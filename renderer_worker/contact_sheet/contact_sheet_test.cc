// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/contact_sheet/contact_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flair::renderer {
namespace {

using testing::HasSubstr;

Pixels Plain(int width, int height, uint8_t red, uint8_t green, uint8_t blue) {
  Pixels pixels{width, height, {}};
  for (int i = 0; i < width * height; ++i) pixels.rgb.insert(pixels.rgb.end(), {red, green, blue});
  return pixels;
}

std::vector<int> At(const Pixels& pixels, int x, int y) {
  const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(pixels.width_px) + static_cast<size_t>(x));
  return {pixels.rgb[at], pixels.rgb[at + 1], pixels.rgb[at + 2]};
}

bool HasInk(const Pixels& pixels, int left, int top, int right, int bottom) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      if (At(pixels, x, y) != std::vector<int>{255, 255, 255}) return true;
    }
  }
  return false;
}

TEST(ArrangeSheet, AnyNumberOfTilesFitsTheLargestSheet) {
  for (int count = 1; count <= 10000; count = count < 40 ? count + 1 : count * 5 / 4) {
    for (const bool has_heading : {false, true}) {
      const auto grid = ArrangeSheet(count, std::nullopt, has_heading);
      ASSERT_TRUE(grid.ok()) << count << " " << grid.status();
      EXPECT_LE(grid->width_px(), kLargestSheetPx);
      EXPECT_LE(grid->height_px(), kLargestSheetPx);
      EXPECT_GE(grid->column_count * grid->row_count, count);
      EXPECT_LT(grid->column_count * (grid->row_count - 1), count);
    }
  }
  EXPECT_TRUE(ArrangeSheet(10000, std::nullopt, true).ok());
  EXPECT_EQ(ArrangeSheet(12, std::nullopt, true)->tile_px, 480);
  EXPECT_GE(ArrangeSheet(1000, std::nullopt, true)->tile_px, 160);
}

TEST(ArrangeSheet, SaysWhichTilesWouldFit) {
  const absl::Status status = ArrangeSheet(1000, 1024, true).status();
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("options.tile_px: 1000 tiles of 1024 px make a sheet larger than"));
  const std::string message(status.message());
  const int named = std::stoi(message.substr(message.rfind("at most ") + 8));
  EXPECT_TRUE(ArrangeSheet(1000, named, true).ok());
  EXPECT_FALSE(ArrangeSheet(1000, named + 1, true).ok());
}

TEST(ContactSheet, PutsEveryPictureInTheMiddleOfItsPlaceWithItsCaptionBelow) {
  const SheetGrid grid = *ArrangeSheet(5, 120, false);
  auto sheet = *ContactSheet::Make(grid, "");
  for (int i = 0; i < 5; ++i)
    ASSERT_EQ(sheet->Add(Plain(100, 60, static_cast<uint8_t>(40 * i), 0, 200), {"room", "all constraints hold"}),
              absl::OkStatus());
  const Pixels pixels = *sheet->Finish();
  ASSERT_EQ(pixels.width_px, grid.width_px());
  ASSERT_EQ(pixels.height_px, grid.height_px());
  ASSERT_EQ(pixels.rgb.size(),
            size_t{3} * static_cast<size_t>(pixels.width_px) * static_cast<size_t>(pixels.height_px));
  for (int i = 0; i < 5; ++i) {
    const int left = grid.gap_px + i % grid.column_count * grid.cell_width_px();
    const int top = grid.gap_px + i / grid.column_count * grid.cell_height_px();
    EXPECT_EQ(At(pixels, left + 10, top + 30), (std::vector<int>{40 * i, 0, 200}));
    EXPECT_EQ(At(pixels, left + 109, top + 89), (std::vector<int>{40 * i, 0, 200}));
    EXPECT_FALSE(HasInk(pixels, left, top, left + 120, top + 30)) << "above the picture";
    EXPECT_TRUE(HasInk(pixels, left, top + 120, left + 120, top + 120 + grid.caption_px)) << "caption";
    EXPECT_TRUE(
        HasInk(pixels, left, top + 120 + grid.caption_px, left + 120, top + grid.cell_height_px() - grid.gap_px))
        << "remark";
  }
}

TEST(ContactSheet, ABrokenTileShowsWhyInItsPlace) {
  const SheetGrid grid = *ArrangeSheet(2, 200, true);
  auto sheet = *ContactSheet::Make(grid, "Rooms");
  ASSERT_EQ(sheet->AddBroken("is none of PNG, JPEG and TIFF", {"broken", ""}), absl::OkStatus());
  ASSERT_EQ(sheet->Add(Plain(200, 200, 1, 2, 3), {"whole", ""}), absl::OkStatus());
  const Pixels pixels = *sheet->Finish();
  EXPECT_TRUE(HasInk(pixels, grid.gap_px, grid.gap_px, grid.width_px(), grid.gap_px + grid.heading_px)) << "heading";
  EXPECT_TRUE(HasInk(pixels, grid.gap_px, grid.gap_px + grid.heading_px, grid.gap_px + 200,
                     grid.gap_px + grid.heading_px + 200));
}

// Long words and characters of other scripts stay within their cell.
TEST(ContactSheet, LongTextStaysInItsCell) {
  const SheetGrid grid = *ArrangeSheet(2, 128, false);
  ASSERT_EQ(grid.column_count, 2);
  const auto make = [&](const std::string& text) {
    auto sheet = *ContactSheet::Make(grid, "");
    EXPECT_EQ(sheet->AddBroken(text, {text, text}), absl::OkStatus());
    EXPECT_EQ(sheet->Add(Plain(1, 1, 255, 255, 255), {"", ""}), absl::OkStatus());
    return *sheet->Finish();
  };
  for (const std::string& text :
       {std::string(500, 'W'), std::string("寝室 寝室 寝室 寝室 寝室 寝室 寝室 寝室 寝室 寝室"), std::string()}) {
    const Pixels pixels = make(text);
    EXPECT_FALSE(HasInk(pixels, grid.gap_px + grid.cell_width_px(), 0, grid.width_px(), grid.height_px())) << text;
  }
}

TEST(ContactSheet, TheSameTilesGiveTheSamePixels) {
  const auto make = [] {
    auto sheet = *ContactSheet::Make(*ArrangeSheet(3, 96, true), "Title");
    for (int i = 0; i < 3; ++i) EXPECT_EQ(sheet->Add(Plain(50, 90, 9, 9, 9), {"a", "b"}), absl::OkStatus());
    return sheet->Finish()->rgb;
  };
  EXPECT_EQ(make(), make());
}

}  // namespace
}  // namespace flair::renderer
