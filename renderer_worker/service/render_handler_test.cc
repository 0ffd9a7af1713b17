// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/files/files.h"

namespace flair::renderer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

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

// Must not be asked.
class NoWriter final : public ImageWriter {
 public:
  absl::StatusOr<std::string> Write(v1::PreviewFormat, const Pixels&, const ImageMetadata&, double) override {
    return absl::InternalError("pixels were written");
  }
  absl::StatusOr<std::string> WriteExr(int, int, std::span<const ImagePlane>, const ImageMetadata&) override {
    return absl::InternalError("pixels were written");
  }
};

class RenderHandlerTest : public testing::Test {
 protected:
  RenderHandlerTest() {
    request_.set_request_id("r1");
    request_.set_job_id("job_7");
    request_.set_brief_text("A cloakroom for eight coats.");
    request_.set_brief_seed(12);
    *request_.mutable_solved_layout() = ReadSample("cloakroom");
    request_.mutable_options()->set_size_px(400);
  }
  v1::RenderOptions& options() { return *request_.mutable_options(); }
  void AskForAView(v1::PreviewView view, int size_px = 256) {
    options().set_view(view);
    options().set_size_px(size_px);
    options().set_sample_count(1);
  }
  absl::StatusOr<v1::RenderResponse> Render(ImageWriter& writer) {
    return RenderHandler(writer, furniture_, limits_).Handle(request_, call_);
  }
  absl::StatusOr<v1::RenderResponse> Render() { return Render(*writer_); }
  std::string WhyNot() {
    const absl::Status status = Render().status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
    return std::string(status.message());
  }

  v1::RenderRequest request_;
  ProceduralFurniture furniture_;
  std::unique_ptr<ImageWriter> writer_ = MakeImageWriter();
  ViewLimits limits_{.thread_count = 2, .answer_bytes = int64_t{32} << 20};
  runtime::CallContext call_;
};

TEST_F(RenderHandlerTest, APlanSaysWhatItIsAndWhereItComesFrom) {
  FakeWriter writer;
  const auto response = Render(writer);
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->preview().view(), v1::PREVIEW_VIEW_PLAN);
  EXPECT_EQ(response->preview().format(), v1::PREVIEW_FORMAT_PNG);
  EXPECT_EQ(response->preview().width_px(), 400);
  EXPECT_EQ(response->producer().program(), "flair-renderer");
  EXPECT_EQ(response->producer().method(), "plan");
  const std::string digest = runtime::Sha256Hex(runtime::CanonicalBytes(request_.solved_layout()));
  EXPECT_THAT(
      response->preview().image(),
      AllOf(HasSubstr("Title=A cloakroom;"), HasSubstr("Software=flair-renderer plan "), HasSubstr("flair:scale=1:"),
            HasSubstr("flair:job_id=job_7;"), HasSubstr("flair:brief=A cloakroom for eight coats.;"),
            HasSubstr("flair:seed=12;"), HasSubstr("flair:layout_sha256=" + digest)));
}

TEST_F(RenderHandlerTest, WhatIsNotKnownIsLeftOut) {
  FakeWriter writer;
  request_.clear_job_id();
  request_.clear_brief_text();
  request_.clear_brief_seed();
  EXPECT_THAT(
      Render(writer)->preview().image(),
      AllOf(testing::Not(HasSubstr("job_id")), testing::Not(HasSubstr("brief")), testing::Not(HasSubstr("seed"))));
}

TEST_F(RenderHandlerTest, EveryFormatOfAPlanIsWhatItIsCalled) {
  const std::pair<v1::PreviewFormat, std::string> kStarts[] = {{v1::PREVIEW_FORMAT_PNG, "\x89PNG"},
                                                               {v1::PREVIEW_FORMAT_JPEG, "\xFF\xD8\xFF"},
                                                               {v1::PREVIEW_FORMAT_TIFF, "II*"},
                                                               {v1::PREVIEW_FORMAT_SVG, "<?xml"},
                                                               {v1::PREVIEW_FORMAT_PDF, "%PDF"}};
  for (const auto& [format, start] : kStarts) {
    options().Clear();
    options().set_format(format);
    const auto first = Render(), second = Render();
    ASSERT_TRUE(first.ok()) << first.status();
    EXPECT_EQ(first->preview().format(), format);
    EXPECT_THAT(first->preview().image(), StartsWith(start));
    EXPECT_TRUE(first->preview().image() == second->preview().image()) << v1::PreviewFormat_Name(format);
  }
}

TEST_F(RenderHandlerTest, SvgAndPdfNeedNoImageLibraryAndSayWhereTheyComeFrom) {
  NoWriter writer;
  for (const v1::PreviewFormat format : {v1::PREVIEW_FORMAT_SVG, v1::PREVIEW_FORMAT_PDF}) {
    options().Clear();
    options().set_format(format);
    const auto response = Render(writer);
    ASSERT_TRUE(response.ok()) << response.status();
    EXPECT_EQ(response->preview().width_px(), 0);
  }
  options().set_format(v1::PREVIEW_FORMAT_SVG);
  EXPECT_THAT(Render(writer)->preview().image(), AllOf(HasSubstr("job_7"), HasSubstr("A cloakroom for eight coats.")));
}

TEST_F(RenderHandlerTest, RefusesNumbersThatAreNone) {
  request_.mutable_solved_layout()->mutable_placements(0)->set_x_m(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(WhyNot(), HasSubstr("solved_layout.placements[0].x_m"));
}

TEST_F(RenderHandlerTest, StopsWhenTheCallerIsGone) {
  call_.cancellation().Cancel();
  EXPECT_EQ(Render().status().code(), absl::StatusCode::kCancelled);
  AskForAView(v1::PREVIEW_VIEW_BIRDSEYE);
  EXPECT_EQ(Render().status().code(), absl::StatusCode::kCancelled);
}

TEST_F(RenderHandlerTest, AViewComesWithItsCameraAndObjects) {
  for (const v1::PreviewView view : {v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_VIEW_PERSPECTIVE}) {
    AskForAView(view);
    const auto response = Render();
    ASSERT_TRUE(response.ok()) << response.status();
    EXPECT_EQ(response->preview().view(), view);
    EXPECT_THAT(response->preview().image(), StartsWith("\x89PNG"));
    EXPECT_EQ(response->preview().width_px(), 256);
    EXPECT_EQ(response->preview().annotations().camera().width_px(), 256);
    EXPECT_EQ(response->preview().annotations().camera().camera_from_room_size(), 16);
    EXPECT_GT(response->preview().annotations().instances_size(), request_.solved_layout().placements_size());
  }
}

TEST_F(RenderHandlerTest, TheNumberOfThreadsChangesNothing) {
  AskForAView(v1::PREVIEW_VIEW_BIRDSEYE);
  options().set_format(v1::PREVIEW_FORMAT_EXR);
  const auto two = Render();
  limits_.thread_count = 1;
  const auto one = Render();
  ASSERT_TRUE(one.ok() && two.ok()) << one.status() << two.status();
  EXPECT_TRUE(one->SerializeAsString() == two->SerializeAsString());
}

TEST_F(RenderHandlerTest, ACameraOfOnesOwnIsTheOneThatTakesThePicture) {
  AskForAView(v1::PREVIEW_VIEW_PERSPECTIVE);
  for (const double x : {1.0, 1.0, 5.0}) options().mutable_camera()->add_eye_m(x);
  for (const double x : {1.0, 1.5, 0.0}) options().mutable_camera()->add_target_m(x);
  const auto response = Render();
  ASSERT_TRUE(response.ok()) << response.status();
  // Where the eye is: minus the rotation's transpose times the translation.
  const auto& m = response->preview().annotations().camera().camera_from_room();
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(-(m[i] * m[3] + m[4 + i] * m[7] + m[8 + i] * m[11]), i == 2 ? 5.0 : 1.0, 1e-4);
}

TEST_F(RenderHandlerTest, AnExrNamesEveryChannelAndItsIdsAreThoseOfTheAnnotations) {
  AskForAView(v1::PREVIEW_VIEW_BIRDSEYE);
  options().set_format(v1::PREVIEW_FORMAT_EXR);
  const auto response = Render();
  ASSERT_TRUE(response.ok()) << response.status();
  const std::string& bytes = response->preview().image();
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  const auto input = OIIO::ImageInput::open("a.exr", nullptr, &memory);
  ASSERT_NE(input, nullptr) << OIIO::geterror();
  const std::vector<std::string>& names = input->spec().channelnames;
  EXPECT_THAT(names, testing::UnorderedElementsAre("R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G",
                                                   "albedo.B", "instance", "class"));
  EXPECT_EQ(input->spec().get_string_attribute("flair:job_id"), "job_7");
  EXPECT_EQ(input->spec().get_string_attribute("flair:samples"), "1");
  const int channel = static_cast<int>(std::find(names.begin(), names.end(), "instance") - names.begin());
  std::vector<uint32_t> ids(256 * 256);
  ASSERT_TRUE(input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::UINT32, ids.data()));
  std::map<uint32_t, int64_t> counts;
  for (const uint32_t id : ids) ++counts[id];
  counts.erase(0);
  EXPECT_GT(counts.size(), 3U);
  for (const v1::Instance& instance : response->preview().annotations().instances())
    EXPECT_EQ(instance.visible_pixel_count(), counts[static_cast<uint32_t>(instance.instance_id())])
        << instance.subject_id();
}

TEST_F(RenderHandlerTest, AViewTooLargeForItsMessageIsRefusedBeforeItIsTraced) {
  AskForAView(v1::PREVIEW_VIEW_BIRDSEYE, 4000);
  options().set_format(v1::PREVIEW_FORMAT_EXR);
  const std::string message = WhyNot();
  EXPECT_THAT(message, AllOf(HasSubstr("options.size_px: 4000 is too large for an EXR"),
                             HasSubstr("runtime.max_message_mib"), HasSubstr("at most 1")));
  // The size that the message names is good.
  const int named = std::stoi(message.substr(message.rfind("at most ") + 8));
  EXPECT_GE(named, kDefaultViewSizePx) << "the default must fit";
  limits_.answer_bytes = int64_t{1} << 40;
  options().set_size_px(8192);
  EXPECT_THAT(WhyNot(), HasSubstr("options.size_px: 8192 is too large for a ray-traced view; at most 4096"));
}

TEST_F(RenderHandlerTest, AFileTooLargeForItsMessageIsAnErrorThatSaysSo) {
  limits_.answer_bytes = 1000;
  const absl::Status status = Render().status();
  EXPECT_EQ(status.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(status.message()), HasSubstr("runtime.max_message_mib"));
}

TEST_F(RenderHandlerTest, PlansComeInPartsToo) {
  v1::DrawPlanPartsRequest request;
  *request.mutable_solved_layout() = request_.solved_layout();
  const absl::StatusOr<v1::DrawPlanPartsResponse> response =
      PlanPartsHandler(limits_.answer_bytes).Handle(request, call_);
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->parts().parts_size(), request.solved_layout().placements_size());
  EXPECT_EQ(response->producer().method(), "plan_parts");
  const absl::Status too_large = PlanPartsHandler(1000).Handle(request, call_).status();
  EXPECT_EQ(too_large.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(too_large.message()), HasSubstr("runtime.max_message_mib"));
  EXPECT_THAT(std::string(PlanPartsHandler(1000).Handle({}, call_).status().message()), StartsWith("solved_layout"));
}

}  // namespace
}  // namespace flair::renderer
