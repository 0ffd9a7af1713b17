// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/service/handlers.h"

namespace flair::renderer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ContactSheetTakerTest : public testing::Test {
 protected:
  absl::Status Options(int tile_count, int tile_px = 128) {
    v1::ComposeContactSheetRequest request;
    request.mutable_options()->set_tile_count(tile_count);
    request.mutable_options()->set_tile_px(tile_px);
    request.mutable_options()->set_title("Rooms");
    return taker_.Take(request, call_);
  }
  absl::Status Layout(const std::string& sample) {
    v1::ComposeContactSheetRequest request;
    request.mutable_tile()->set_caption(sample);
    *request.mutable_tile()->mutable_solved_layout() = ReadSample(sample);
    return taker_.Take(request, call_);
  }
  absl::Status Image(const std::string& bytes) {
    v1::ComposeContactSheetRequest request;
    request.mutable_tile()->set_caption("image");
    request.mutable_tile()->set_image(bytes);
    return taker_.Take(request, call_);
  }

  std::unique_ptr<ImageWriter> writer_ = MakeImageWriter();
  std::atomic<int> open_sheets_ = 0;
  ContactSheetTaker taker_{*writer_, open_sheets_};
  runtime::CallContext call_;
};

TEST_F(ContactSheetTakerTest, PutsLayoutsAndImagesOnOneSheet) {
  const std::string image = *writer_->WritePng(Pixels{2, 2, std::vector<uint8_t>(12, 99)}, {});
  ASSERT_EQ(Options(3), absl::OkStatus());
  ASSERT_EQ(Layout("cloakroom"), absl::OkStatus());
  ASSERT_EQ(Layout("cloakroom"), absl::OkStatus());
  ASSERT_EQ(Image(image), absl::OkStatus());
  const auto response = taker_.Finish(call_);
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_THAT(response->sheet().image(), StartsWith("\x89PNG"));
  EXPECT_GT(response->sheet().width_px(), 256);
  EXPECT_EQ(response->diagnostics_size(), 0);
  EXPECT_EQ(response->producer().method(), "contact_sheet");
}

TEST_F(ContactSheetTakerTest, BrokenTilesAreToldAndTheSheetComesAllTheSame) {
  v1::ComposeContactSheetRequest missing, bad;
  missing.mutable_tile()->set_caption("missing");
  missing.mutable_tile()->set_remark("layout.pb cannot be read");
  bad.mutable_tile()->set_caption("bad");
  *bad.mutable_tile()->mutable_solved_layout() = ReadSample("cloakroom");
  bad.mutable_tile()->mutable_solved_layout()->mutable_placements(0)->set_y_m(1.0 / 0.0);
  ASSERT_EQ(Options(4), absl::OkStatus());
  ASSERT_EQ(Image("GIF89a"), absl::OkStatus());
  ASSERT_EQ(taker_.Take(missing, call_), absl::OkStatus());
  ASSERT_EQ(taker_.Take(bad, call_), absl::OkStatus());
  ASSERT_EQ(Layout("cloakroom"), absl::OkStatus());
  const auto response = taker_.Finish(call_);
  ASSERT_TRUE(response.ok()) << response.status();
  ASSERT_EQ(response->diagnostics_size(), 3);
  EXPECT_EQ(response->diagnostics(0).message(), "tile 1, \"image\": the image is none of PNG, JPEG and TIFF");
  EXPECT_EQ(response->diagnostics(1).message(), "tile 2, \"missing\": layout.pb cannot be read");
  EXPECT_THAT(response->diagnostics(2).message(), HasSubstr("solved_layout.placements[0].y_m"));
}

TEST_F(ContactSheetTakerTest, RefusesTilesBeforeOptions) {
  EXPECT_EQ(Image("x"), absl::InvalidArgumentError("options: is not set; the first message holds it"));
}

TEST_F(ContactSheetTakerTest, RefusesTilesBeyondTheirNumber) {
  ASSERT_EQ(Options(1), absl::OkStatus());
  ASSERT_EQ(Layout("cloakroom"), absl::OkStatus());
  EXPECT_EQ(Layout("cloakroom"), absl::InvalidArgumentError("tile: one more than the 1 of options.tile_count"));
}

TEST_F(ContactSheetTakerTest, RefusesToEndBeforeAllHaveCome) {
  ASSERT_EQ(Options(2), absl::OkStatus());
  ASSERT_EQ(Layout("cloakroom"), absl::OkStatus());
  EXPECT_EQ(taker_.Finish(call_).status(),
            absl::InvalidArgumentError("options.tile_count: 2 tiles were announced, 1 came"));
}

TEST_F(ContactSheetTakerTest, RefusesAnEmptyStream) {
  EXPECT_EQ(taker_.Finish(call_).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST_F(ContactSheetTakerTest, SoManyAtATimeAndNoMore) {
  std::vector<std::unique_ptr<ContactSheetTaker>> others;
  for (int i = 0; i < kMostOpenSheets; ++i)
    others.push_back(std::make_unique<ContactSheetTaker>(*writer_, open_sheets_));
  v1::ComposeContactSheetRequest request;
  request.mutable_options()->set_tile_count(1);
  EXPECT_EQ(others.back()->Take(request, call_).code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(others.front()->Take(request, call_), absl::OkStatus());
  others.clear();
  EXPECT_EQ(open_sheets_, 1);
}

}  // namespace
}  // namespace flair::renderer
