// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/contract/contract.h"

namespace flair::testing {
namespace {

using Service = v1::RendererService::StubInterface;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class RendererContract : public ::testing::Test {
 protected:
  static v1::RenderRequest Request() {
    v1::RenderRequest request;
    request.set_request_id("r1");
    *request.mutable_solved_layout()->mutable_graph() = BedroomGraph();
    v1::Placement& bed = *request.mutable_solved_layout()->add_placements();
    bed.set_object_id("bed");
    bed.set_x_m(2);
    bed.set_y_m(1);
    request.mutable_options()->set_size_px(512);
    return request;
  }

  ServerUnderTest server_{"renderer"};
  std::unique_ptr<v1::RendererService::Stub> stub_ = v1::RendererService::NewStub(server_.channel());
};

TEST_F(RendererContract, DrawsAPngOfTheSizeAskedFor) {
  const auto answer = Ask(*stub_, &Service::Render, Request());
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_THAT(answer->preview().image(), StartsWith("\x89PNG"));
  EXPECT_EQ(std::max(answer->preview().width_px(), answer->preview().height_px()), 512);
  EXPECT_EQ(answer->preview().format(), v1::PREVIEW_FORMAT_PNG);
}

TEST_F(RendererContract, TheSameLayoutGivesTheSameBytes) {
  const auto first = Ask(*stub_, &Service::Render, Request());
  const auto second = Ask(*stub_, &Service::Render, Request());
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_TRUE(first->preview().image() == second->preview().image());
}

TEST_F(RendererContract, ABadSizeIsInvalidArgument) {
  v1::RenderRequest request = Request();
  request.mutable_options()->set_size_px(9);
  EXPECT_EQ(Ask(*stub_, &Service::Render, request).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST_F(RendererContract, EveryFormatIsWhatItIsCalled) {
  const std::pair<v1::PreviewFormat, std::string> kStarts[] = {{v1::PREVIEW_FORMAT_JPEG, "\xFF\xD8\xFF"},
                                                               {v1::PREVIEW_FORMAT_TIFF, "II*"},
                                                               {v1::PREVIEW_FORMAT_SVG, "<?xml"},
                                                               {v1::PREVIEW_FORMAT_PDF, "%PDF"}};
  for (const auto& [format, start] : kStarts) {
    v1::RenderRequest request = Request();
    request.mutable_options()->Clear();
    request.mutable_options()->set_format(format);
    const auto answer = Ask(*stub_, &Service::Render, request);
    ASSERT_TRUE(answer.ok()) << answer.status();
    EXPECT_THAT(answer->preview().image(), StartsWith(start));
    EXPECT_EQ(answer->preview().format(), format);
  }
}

TEST_F(RendererContract, AViewComesWithCameraAndObjects) {
  v1::RenderRequest request = Request();
  request.mutable_options()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
  request.mutable_options()->set_size_px(256);
  request.mutable_options()->set_sample_count(1);
  request.mutable_options()->set_format(v1::PREVIEW_FORMAT_EXR);
  const auto answer = Ask(*stub_, &Service::Render, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_THAT(answer->preview().image(), StartsWith("\x76\x2f\x31\x01"));
  EXPECT_EQ(answer->preview().annotations().camera().width_px(), 256);
  ASSERT_GT(answer->preview().annotations().instances_size(), 0);
  EXPECT_EQ(answer->preview().annotations().instances(0).subject_id(), "bed");
}

TEST_F(RendererContract, OptionsThatDoNotGoTogetherAreInvalidArgument) {
  v1::RenderRequest request = Request();
  request.mutable_options()->set_format(v1::PREVIEW_FORMAT_EXR);
  const absl::Status status = Ask(*stub_, &Service::Render, request).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), HasSubstr("options.format"));
}

TEST_F(RendererContract, AnEightThousandPixelExrIsRefusedByTheNameOfItsField) {
  v1::RenderRequest request = Request();
  request.mutable_options()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
  request.mutable_options()->set_format(v1::PREVIEW_FORMAT_EXR);
  request.mutable_options()->set_size_px(8192);
  const absl::Status status = Ask(*stub_, &Service::Render, request).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), HasSubstr("options.size_px: 8192"));
}

TEST_F(RendererContract, ACallerWhoLeavesEndsTheTracing) {
  v1::RenderRequest request = Request();
  request.mutable_options()->set_view(v1::PREVIEW_VIEW_PERSPECTIVE);
  request.mutable_options()->set_size_px(2048);
  request.mutable_options()->set_sample_count(4096);  // hours
  runtime::CallContext call;
  const auto answer = runtime::UnaryRequest(*stub_, &Service::Render, request, call, absl::Now() + absl::Seconds(1));
  EXPECT_EQ(answer.status().code(), absl::StatusCode::kDeadlineExceeded);
  // Whoever comes next is served, by a renderer that has one thread to work with.
  const auto next = Ask(*stub_, &Service::Render, Request());
  EXPECT_TRUE(next.ok()) << next.status();
}

TEST_F(RendererContract, SceneFormatsAreWhatTheyAreCalled) {
  v1::ExportSceneRequest request;
  *request.mutable_solved_layout() = Request().solved_layout();
  request.set_format(v1::SCENE_FORMAT_GLB);
  const auto glb = Ask(*stub_, &Service::ExportScene, request);
  ASSERT_TRUE(glb.ok()) << glb.status();
  EXPECT_THAT(glb->scene(), StartsWith("glTF"));
  request.set_format(v1::SCENE_FORMAT_SCENE_STATE);
  const auto state = Ask(*stub_, &Service::ExportScene, request);
  ASSERT_TRUE(state.ok()) << state.status();
  EXPECT_THAT(state->scene(), StartsWith("{"));
  request.clear_format();
  EXPECT_EQ(Ask(*stub_, &Service::ExportScene, request).status().code(), absl::StatusCode::kInvalidArgument);
}

class ContactSheetContract : public RendererContract {
 protected:
  // Sends the options and tiles, and waits for the answer.
  absl::StatusOr<v1::ComposeContactSheetResponse> Compose(int tile_count,
                                                          const std::vector<v1::ContactSheetTile>& tiles) {
    grpc::ClientContext context;
    context.set_deadline(absl::ToChronoTime(absl::Now() + absl::Minutes(1)));
    v1::ComposeContactSheetResponse response;
    const auto writer = stub_->ComposeContactSheet(&context, &response);
    v1::ComposeContactSheetRequest request;
    request.mutable_options()->set_tile_count(tile_count);
    request.mutable_options()->set_tile_px(96);
    writer->Write(request);
    for (const v1::ContactSheetTile& tile : tiles) {
      *request.mutable_tile() = tile;
      if (!writer->Write(request)) break;
    }
    writer->WritesDone();
    const grpc::Status status = writer->Finish();
    if (!status.ok()) return runtime::FromGrpcStatus(status);
    return response;
  }
  static v1::ContactSheetTile LayoutTile() {
    v1::ContactSheetTile tile;
    tile.set_caption("bedroom");
    *tile.mutable_solved_layout() = Request().solved_layout();
    return tile;
  }
  static v1::ContactSheetTile ImageTile(const std::string& bytes) {
    v1::ContactSheetTile tile;
    tile.set_caption("image");
    tile.set_image(bytes);
    return tile;
  }
};

TEST_F(ContactSheetContract, TilesOfLayoutsAndOfPicturesBecomeOneSheet) {
  const auto picture = Ask(*stub_, &Service::Render, Request());
  ASSERT_TRUE(picture.ok()) << picture.status();
  const auto answer = Compose(2, {LayoutTile(), ImageTile(picture->preview().image())});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_THAT(answer->sheet().image(), StartsWith("\x89PNG"));
  EXPECT_EQ(answer->diagnostics_size(), 0);
}

TEST_F(ContactSheetContract, ABrokenTileIsADiagnosticAndTheSheetComes) {
  const auto answer = Compose(2, {ImageTile("no picture"), LayoutTile()});
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_EQ(answer->diagnostics_size(), 1);
  EXPECT_THAT(answer->diagnostics(0).message(), HasSubstr("image"));
}

TEST_F(ContactSheetContract, TooManyAndTooFewTilesAreInvalidArgument) {
  EXPECT_EQ(Compose(1, {LayoutTile(), LayoutTile()}).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(Compose(2, {LayoutTile()}).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(Compose(0, {}).status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace flair::testing
