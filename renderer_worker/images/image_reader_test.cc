// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer_worker/images/image_files.h"

namespace flair::renderer {
namespace {

using testing::HasSubstr;

// Left half red, right half blue.
Pixels Halves(int width, int height) {
  Pixels pixels{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const bool is_left = i % width < width / 2;
    for (const int value : {is_left ? 255 : 0, 0, is_left ? 0 : 255}) pixels.rgb.push_back(static_cast<uint8_t>(value));
  }
  return pixels;
}

std::string File(v1::PreviewFormat format, int width, int height) {
  return *MakeImageWriter()->Write(format, Halves(width, height), {});
}

std::string WhyNot(const std::string& bytes) {
  const absl::Status status = ReadImage(bytes, 100, 100).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  return std::string(status.message());
}

class EveryFormat : public testing::TestWithParam<v1::PreviewFormat> {};

TEST_P(EveryFormat, ShrinksIntoTheBoxAndKeepsItsShape) {
  const absl::StatusOr<Pixels> pixels = ReadImage(File(GetParam(), 640, 480), 100, 100);
  ASSERT_TRUE(pixels.ok()) << pixels.status();
  EXPECT_EQ(pixels->width_px, 100);
  EXPECT_EQ(pixels->height_px, 75);
  ASSERT_EQ(pixels->rgb.size(), 100U * 75U * 3U);
  EXPECT_GT(pixels->rgb[0], 240);
  EXPECT_LT(pixels->rgb[2], 15);
  EXPECT_GT(pixels->rgb.back(), 240);
}

TEST_P(EveryFormat, IsNotEnlarged) {
  const absl::StatusOr<Pixels> pixels = ReadImage(File(GetParam(), 40, 30), 100, 100);
  ASSERT_TRUE(pixels.ok()) << pixels.status();
  EXPECT_EQ(pixels->width_px, 40);
  EXPECT_EQ(pixels->height_px, 30);
}

TEST_P(EveryFormat, CutAnywhereIsAnErrorOrAPictureButNoCrash) {
  const std::string whole = File(GetParam(), 200, 100);
  for (size_t length = 0; length < whole.size(); length += 1 + whole.size() / 97) {
    const absl::StatusOr<Pixels> pixels = ReadImage(whole.substr(0, length), 100, 100);
    if (pixels.ok()) {
      EXPECT_EQ(pixels->rgb.size(), 3 * static_cast<size_t>(pixels->width_px) * static_cast<size_t>(pixels->height_px));
    } else {
      EXPECT_EQ(pixels.status().code(), absl::StatusCode::kInvalidArgument) << pixels.status();
    }
  }
}

TEST_P(EveryFormat, FlippedBitsAreAnErrorOrAPictureButNoCrash) {
  const std::string whole = File(GetParam(), 200, 100);
  for (size_t at = 0; at < whole.size(); at += 1 + whole.size() / 193) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (at % 8)));
    const absl::StatusOr<Pixels> pixels = ReadImage(flipped, 100, 100);
    if (!pixels.ok()) {
      EXPECT_EQ(pixels.status().code(), absl::StatusCode::kInvalidArgument) << pixels.status();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat,
                         testing::Values(v1::PREVIEW_FORMAT_PNG, v1::PREVIEW_FORMAT_JPEG, v1::PREVIEW_FORMAT_TIFF),
                         [](const auto& info) { return v1::PreviewFormat_Name(info.param); });

TEST(ReadImage, SaysThatNothingIsThere) { EXPECT_THAT(WhyNot(""), HasSubstr("is empty")); }

TEST(ReadImage, SaysWhichFormatsItReads) {
  EXPECT_THAT(WhyNot("<svg xmlns=\"http://www.w3.org/2000/svg\"/>"), HasSubstr("is none of PNG, JPEG and TIFF"));
}

TEST(ReadImage, AHeaderOfFiftyThousandPixelsIsRefusedBeforeDecoding) {
  std::string bomb = File(v1::PREVIEW_FORMAT_PNG, 64, 64);
  bomb.replace(16, 8, std::string("\x00\x00\xC3\x50\x00\x00\xC3\x50", 8));
  EXPECT_THAT(WhyNot(bomb), HasSubstr("is said to be 50000 x 50000 px; at most 8192 px a side"));
}

TEST(ReadImage, AJpegHeaderOfSixtyThousandPixelsIsRefusedBeforeDecoding) {
  std::string bomb = File(v1::PREVIEW_FORMAT_JPEG, 64, 64);
  const size_t frame = bomb.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  bomb.replace(frame + 5, 4, "\xEA\x60\xEA\x60");
  EXPECT_THAT(WhyNot(bomb), HasSubstr("60000 x 60000 px"));
}

TEST(ReadImage, AJpegOfAThousandScansIsRefused) {
  std::string bomb = File(v1::PREVIEW_FORMAT_JPEG, 64, 64);
  for (int i = 0; i < 1000; ++i) bomb += "\xFF\xDA";
  EXPECT_THAT(WhyNot(bomb), HasSubstr("is a JPEG of 1001 scans; at most 100"));
}

TEST(ReadImage, APngOfNothingButAHeaderIsAnError) {
  EXPECT_THAT(WhyNot(File(v1::PREVIEW_FORMAT_PNG, 64, 64).substr(0, 20)), HasSubstr("ends in its header"));
}

// 8192 x 8192 pixels of one colour: 200 MB once decoded, of which never more than a few rows are held.
TEST(ReadImage, AHugeEvenPictureBecomesASmallOne) {
  Pixels even{8192, 8192, {}};
  even.rgb.assign(size_t{3} * 8192 * 8192, 77);
  const std::string bomb = *MakeImageWriter()->WritePng(even, {});
  ASSERT_LT(bomb.size(), 2000000U);
  const absl::StatusOr<Pixels> pixels = ReadImage(bomb, 64, 64);
  ASSERT_TRUE(pixels.ok()) << pixels.status();
  EXPECT_EQ(pixels->width_px, 64);
  EXPECT_EQ(pixels->rgb, std::vector<uint8_t>(size_t{3} * 64 * 64, 77));
}

}  // namespace
}  // namespace flair::renderer
