// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer_worker/images/image_files.h"

namespace flair::renderer {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 37, kHeight = 23;

Pixels Gradient() {
  Pixels pixels{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int value : {6 * x, 10 * y, 128}) pixels.rgb.push_back(static_cast<uint8_t>(value));
    }
  }
  return pixels;
}

const ImageMetadata& Metadata() {
  static const ImageMetadata metadata = {{"Title", "A crypt"},
                                         {"Software", "flair-renderer plan 2"},
                                         {"flair:brief", "Für Søren 寝室"},
                                         {"flair:seed", "7"}};
  return metadata;
}

// Opens bytes with OpenImageIO itself.
struct Opened {
  Opened(const std::string& name, const std::string& bytes)
      : memory(const_cast<char*>(bytes.data()), bytes.size()), input(OIIO::ImageInput::open(name, nullptr, &memory)) {}
  OIIO::Filesystem::IOMemReader memory;
  std::unique_ptr<OIIO::ImageInput> input;
};

struct Format {
  const char* name;
  v1::PreviewFormat format;
  const char* file_name;
  int tolerance;
};

class EightBit : public testing::TestWithParam<Format> {};

TEST_P(EightBit, ReadsBackWithItsMetadataAndWithoutATimeOfDay) {
  const auto bytes = MakeImageWriter()->Write(GetParam().format, Gradient(), Metadata(), 300);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const Opened file(GetParam().file_name, *bytes);
  ASSERT_NE(file.input, nullptr) << OIIO::geterror();
  const OIIO::ImageSpec& spec = file.input->spec();
  ASSERT_EQ(spec.width, kWidth);
  ASSERT_EQ(spec.height, kHeight);
  std::vector<uint8_t> read(Gradient().rgb.size());
  ASSERT_TRUE(file.input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, read.data()));
  for (size_t i = 0; i < read.size(); ++i) ASSERT_NEAR(read[i], Gradient().rgb[i], GetParam().tolerance) << i;
  EXPECT_EQ(spec.get_string_attribute("Software"), "flair-renderer plan 2");
  EXPECT_NEAR(spec.get_float_attribute("XResolution"), 300, 0.1);
  EXPECT_EQ(spec.get_string_attribute("DateTime"), "");
  if (GetParam().format == v1::PREVIEW_FORMAT_PNG) {
    EXPECT_EQ(spec.get_string_attribute("flair:brief"), "Für Søren 寝室");
    EXPECT_EQ(spec.get_string_attribute("flair:seed"), "7");
  } else {
    EXPECT_THAT(std::string(spec.get_string_attribute("ImageDescription")),
                testing::AllOf(HasSubstr("flair:brief: Für Søren 寝室"), HasSubstr("flair:seed: 7")));
  }
}

TEST_P(EightBit, GivesTheSameBytesTwice) {
  const auto writer = MakeImageWriter();
  EXPECT_EQ(*writer->Write(GetParam().format, Gradient(), Metadata()),
            *writer->Write(GetParam().format, Gradient(), Metadata()));
}

INSTANTIATE_TEST_SUITE_P(Formats, EightBit,
                         testing::Values(Format{"Png", v1::PREVIEW_FORMAT_PNG, "a.png", 0},
                                         Format{"Jpeg", v1::PREVIEW_FORMAT_JPEG, "a.jpg", 6},
                                         Format{"Tiff", v1::PREVIEW_FORMAT_TIFF, "a.tif", 0}),
                         [](const auto& info) { return info.param.name; });

TEST(ImageWriter, SaysWhichFormatsHold8Bits) {
  const auto bytes = MakeImageWriter()->Write(v1::PREVIEW_FORMAT_SVG, Gradient(), {});
  EXPECT_EQ(bytes.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(bytes.status().message()), HasSubstr("PNG, JPEG or TIFF"));
}

class Exr : public testing::Test {
 protected:
  Exr() {
    for (int i = 0; i < kWidth * kHeight; ++i) {
      for (int c = 0; c < 3; ++c) colour_.push_back(static_cast<float>(i * (c + 1)) * 0.25F);
      depth_.push_back(1.0F / static_cast<float>(i + 3));
      ids_.push_back(static_cast<uint32_t>(i) * 1000003U);
    }
    depth_[5] = 1e9F;
  }
  absl::StatusOr<std::string> Write() const {
    const std::vector<ImagePlane> planes = {{{"R", "G", "B"}, ChannelStorage::kHalf, colour_, {}},
                                            {{"Z"}, ChannelStorage::kFloat, depth_, {}},
                                            {{"instance"}, ChannelStorage::kUint32, {}, ids_}};
    return MakeImageWriter()->WriteExr(kWidth, kHeight, planes, Metadata());
  }
  std::vector<float> colour_, depth_;
  std::vector<uint32_t> ids_;
};

TEST_F(Exr, ReadsBackEveryChannelInItsType) {
  const auto bytes = Write();
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const Opened file("a.exr", *bytes);
  ASSERT_NE(file.input, nullptr) << OIIO::geterror();
  const OIIO::ImageSpec& spec = file.input->spec();
  const auto channel = [&](const char* name) {
    return static_cast<int>(std::find(spec.channelnames.begin(), spec.channelnames.end(), name) -
                            spec.channelnames.begin());
  };
  ASSERT_EQ(spec.nchannels, 5);
  EXPECT_EQ(spec.channelformat(channel("G")), OIIO::TypeDesc::HALF);
  EXPECT_EQ(spec.channelformat(channel("Z")), OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(spec.channelformat(channel("instance")), OIIO::TypeDesc::UINT32);
  std::vector<float> depth(depth_.size()), green(depth_.size());
  std::vector<uint32_t> ids(ids_.size());
  const auto read = [&](const char* name, OIIO::TypeDesc type, void* to) {
    return file.input->read_image(0, 0, channel(name), channel(name) + 1, type, to);
  };
  ASSERT_TRUE(read("Z", OIIO::TypeDesc::FLOAT, depth.data()));
  ASSERT_TRUE(read("G", OIIO::TypeDesc::FLOAT, green.data()));
  ASSERT_TRUE(read("instance", OIIO::TypeDesc::UINT32, ids.data()));
  EXPECT_EQ(depth, depth_);
  EXPECT_EQ(ids, ids_);
  for (size_t i = 0; i < green.size(); ++i) ASSERT_NEAR(green[i], colour_[3 * i + 1], 1e-3 * green[i] + 1e-6);
}

TEST_F(Exr, KeepsMetadataAndNoTimeOfDay) {
  const auto bytes = Write();
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const Opened file("a.exr", *bytes);
  ASSERT_NE(file.input, nullptr);
  EXPECT_EQ(file.input->spec().get_string_attribute("flair:brief"), "Für Søren 寝室");
  EXPECT_EQ(file.input->spec().find_attribute("DateTime"), nullptr);
  EXPECT_THAT(*bytes, testing::Not(HasSubstr("capDate")));
  EXPECT_EQ(*bytes, *Write());
}

TEST_F(Exr, RefusesPlanesOfAnotherSize) {
  depth_.pop_back();
  EXPECT_EQ(Write().status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace flair::renderer
