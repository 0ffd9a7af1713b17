// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/service/handlers.h"

namespace flair::renderer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExportSceneTest : public testing::Test {
 protected:
  ExportSceneTest() {
    request_.set_request_id("r1");
    request_.set_job_id("job_7");
    request_.set_brief_text("A crypt.");
    request_.set_format(v1::SCENE_FORMAT_GLB);
    *request_.mutable_solved_layout() = ReadSample("cloakroom");
  }
  absl::StatusOr<v1::ExportSceneResponse> Export() {
    return ExportSceneHandler(furniture_, "build 7", answer_bytes_).Handle(request_, call_);
  }

  v1::ExportSceneRequest request_;
  ProceduralFurniture furniture_;
  int64_t answer_bytes_ = int64_t{32} << 20;
  runtime::CallContext call_;
};

TEST_F(ExportSceneTest, AGlbSaysWhereItComesFromAndIsTheSameTwice) {
  const auto first = Export(), second = Export();
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_THAT(first->scene(), StartsWith("glTF"));
  EXPECT_THAT(first->scene(), testing::AllOf(HasSubstr("job_7"), HasSubstr("A crypt."), HasSubstr("build 7")));
  EXPECT_EQ(first->producer().method(), "glb");
  EXPECT_TRUE(first->scene() == second->scene());
}

TEST_F(ExportSceneTest, ASceneStateIsJson) {
  request_.set_format(v1::SCENE_FORMAT_SCENE_STATE);
  const auto response = Export();
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_THAT(response->scene(), StartsWith("{"));
  EXPECT_EQ(response->producer().method(), "scene_state");
}

TEST_F(ExportSceneTest, AFormatOfNoKindIsRefused) {
  request_.set_format(v1::SCENE_FORMAT_UNSPECIFIED);
  EXPECT_EQ(Export().status(), absl::InvalidArgumentError("format: is not set"));
}

TEST_F(ExportSceneTest, StopsWhenTheCallerIsGone) {
  call_.cancellation().Cancel();
  EXPECT_EQ(Export().status().code(), absl::StatusCode::kCancelled);
}

TEST_F(ExportSceneTest, ASceneTooLargeForItsMessageIsAnErrorThatSaysSo) {
  answer_bytes_ = 100;
  EXPECT_EQ(Export().status().code(), absl::StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace flair::renderer
