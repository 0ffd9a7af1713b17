// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the sample layouts against stored ones, and what a written file says of itself.
// Our own headers first: OpenImageIO redefines byte-swapping names that protobuf's headers use.
#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/images/image_files.h"
// clang-format off
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>
// clang-format on
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace flair::renderer {
namespace {

// As OpenImageIO's own test suite: few pixels may differ visibly, hardly any strongly, none beyond all measure.
constexpr int kFailLevel = 24;         // of 255, per channel
constexpr double kFailShare = 0.005;   // of the pixels
constexpr double kHardShare = 0.0005;  // of the pixels, beyond 3 * kFailLevel
constexpr int kSizePx = 800;

std::string GoldenPath(const std::string& name) {
  return std::string(FLAIR_SOURCE_DIR) + "/renderer_worker/drawing/testdata/" + name + ".png";
}

// A picture: of every sample layout as it is drawn by default, and of some with other options.
struct GoldenCase {
  std::string name;
  std::string sample;
  v1::RenderOptions options;
};

void PrintTo(const GoldenCase& golden, std::ostream* out) { *out << golden.name; }

GoldenCase CaseWith(const std::string& name, const std::string& sample, const std::vector<v1::PlanLayer>& layers,
                    v1::PaperSize paper = v1::PAPER_SIZE_A3) {
  GoldenCase golden{name, sample, {}};
  golden.options.set_size_px(kSizePx);
  golden.options.set_paper(paper);
  for (const v1::PlanLayer layer : layers) golden.options.add_layers(layer);
  return golden;
}

std::vector<GoldenCase> Cases() {
  std::vector<GoldenCase> cases;
  for (const std::string& name : SampleLayouts()) cases.push_back(CaseWith(name, name, {}));
  cases.push_back(CaseWith("nursery_constraints", "nursery",
                           {v1::PLAN_LAYER_FLOOR_PIECES, v1::PLAN_LAYER_TERTIARY, v1::PLAN_LAYER_CONSTRAINTS}));
  cases.push_back(
      CaseWith("nursery_circulation", "nursery", {v1::PLAN_LAYER_FLOOR_PIECES, v1::PLAN_LAYER_CIRCULATION}));
  cases.push_back(CaseWith("l_shaped_studio_a4", "l_shaped_studio", {}, v1::PAPER_SIZE_A4));
  return cases;
}

absl::StatusOr<std::string> Picture(const GoldenCase& golden, DrawnPlan& plan) {
  absl::StatusOr<DrawnPlan> drawn = DrawPlan(ReadSample(golden.sample), golden.options);
  if (!drawn.ok()) return drawn.status();
  plan = *std::move(drawn);
  return MakeImageWriter()->WritePng(plan.pixels,
                                     {{"Title", plan.title}, {"flair:scale", "1:" + std::to_string(plan.scale)}});
}

class Golden : public testing::TestWithParam<GoldenCase> {};

TEST_P(Golden, LooksAsStored) {
  DrawnPlan plan;
  const absl::StatusOr<std::string> png = Picture(GetParam(), plan);
  ASSERT_TRUE(png.ok()) << png.status();
  const char* update = std::getenv("FLAIR_UPDATE_GOLDENS");
  if (update != nullptr && std::string_view(update) == "1")
    std::ofstream(GoldenPath(GetParam().name), std::ios::binary) << *png;
  OIIO::ImageBuf golden(GoldenPath(GetParam().name));
  ASSERT_TRUE(golden.read(0, 0, true, OIIO::TypeDesc::UINT8)) << golden.geterror();
  ASSERT_EQ(golden.spec().width, plan.pixels.width_px);
  ASSERT_EQ(golden.spec().height, plan.pixels.height_px);
  std::vector<uint8_t> stored(plan.pixels.rgb.size());
  ASSERT_TRUE(golden.get_pixels(golden.roi(), OIIO::TypeDesc::UINT8, stored.data()));
  int failed = 0, hard = 0;
  for (size_t i = 0; i < stored.size(); i += 3) {
    int worst = 0;
    for (size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(stored[i + c] - plan.pixels.rgb[i + c]));
    failed += worst > kFailLevel;
    hard += worst > 3 * kFailLevel;
  }
  const double pixels = static_cast<double>(stored.size()) / 3;
  EXPECT_LE(failed / pixels, kFailShare);
  EXPECT_LE(hard / pixels, kHardShare);
}

INSTANTIATE_TEST_SUITE_P(Plans, Golden, testing::ValuesIn(Cases()), [](const auto& info) { return info.param.name; });

TEST(ImageWriter, WritesTheSameBytesTwiceAndSaysWhatItIs) {
  const GoldenCase golden = CaseWith("vampire_bedroom", "vampire_bedroom", {});
  DrawnPlan plan;
  const absl::StatusOr<std::string> first = Picture(golden, plan), second = Picture(golden, plan);
  ASSERT_TRUE(first.ok()) << first.status();
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(*first, *second);
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(first->data()), first->size());
  const auto input = OIIO::ImageInput::open("plan.png", nullptr, &memory);
  ASSERT_NE(input, nullptr) << OIIO::geterror();
  EXPECT_EQ(input->spec().get_string_attribute("DocumentName"),  // its name for PNG's Title
            "A bedroom for a vampire.");
  EXPECT_EQ(input->spec().get_string_attribute("flair:scale"), "1:25");
  std::vector<uint8_t> read(plan.pixels.rgb.size());
  ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, read.data()));
  EXPECT_EQ(read, plan.pixels.rgb);
}

}  // namespace
}  // namespace flair::renderer
