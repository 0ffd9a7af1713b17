// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/render_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "renderer_worker/drawing/testdata/read_layout.h"
#include "renderer_worker/service/export_scene_handler.h"

namespace flair::renderer {
namespace {

// Answers with the metadata instead of a picture.
class FakeWriter final : public ImageWriter {
 public:
  absl::StatusOr<std::string> Write(v1::PreviewFormat, const Pixels&, const ImageMetadata& metadata, double) override {
    return Text(metadata);
  }
  absl::StatusOr<std::string> WriteExr(int, int, std::span<const ImagePlane>, const ImageMetadata& metadata) override {
    return Text(metadata);
  }

 private:
  static std::string Text(const ImageMetadata& metadata) {
    std::string text;
    for (const auto& [name, value] : metadata) text += name + "=" + value + ";";
    return text;
  }
};

v1::RenderRequest Request(const std::string& sample) {
  v1::RenderRequest request;
  request.set_request_id("r1");
  request.set_job_id("job_7");
  *request.mutable_solved_layout() = ReadSample(sample);
  request.mutable_options()->set_size_px(400);
  return request;
}

TEST(RenderHandler, DrawsAndSaysWhatForAtWhichScale) {
  FakeWriter writer;
  runtime::CallContext call;
  const absl::StatusOr<v1::RenderResponse> response = RenderHandler(writer).Handle(Request("cloakroom"), call);
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->preview().format(), v1::PREVIEW_FORMAT_PNG);
  EXPECT_EQ(response->preview().width_px(), 400);
  EXPECT_EQ(response->producer().program(), "flair-renderer");
  EXPECT_THAT(response->preview().image(),
              testing::AllOf(testing::HasSubstr("Title=A cloakroom;"), testing::HasSubstr("flair:scale=1:10 at A3;"),
                             testing::HasSubstr("flair:job_id=job_7;")));
}

TEST(RenderHandler, RefusesNumbersThatAreNone) {
  FakeWriter writer;
  runtime::CallContext call;
  v1::RenderRequest request = Request("cloakroom");
  request.mutable_solved_layout()->mutable_placements(0)->set_x_m(std::numeric_limits<double>::quiet_NaN());
  const absl::Status status = RenderHandler(writer).Handle(request, call).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("solved_layout.placements[0].x_m"));
}

TEST(RenderHandler, StopsWhenTheCallerIsGone) {
  FakeWriter writer;
  runtime::CallContext call;
  call.cancellation().Cancel();
  EXPECT_EQ(RenderHandler(writer).Handle(Request("cloakroom"), call).status().code(), absl::StatusCode::kCancelled);
}

TEST(ExportSceneHandler, SaysThatItDoesNot) {
  runtime::CallContext call;
  v1::ExportSceneRequest request;
  request.set_request_id("r1");
  request.set_format(v1::SCENE_FORMAT_GLB);
  *request.mutable_solved_layout() = ReadSample("cloakroom");
  EXPECT_EQ(ExportSceneHandler().Handle(request, call).status().code(), absl::StatusCode::kUnimplemented);
}

}  // namespace
}  // namespace flair::renderer
