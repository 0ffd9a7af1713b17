// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/contract/contract.h"

namespace flair::testing {
namespace {

using Service = v1::RendererService::StubInterface;
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

}  // namespace
}  // namespace flair::testing
