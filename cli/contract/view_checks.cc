// SPDX-License-Identifier: GPL-3.0-or-later
// Renderer: ray-traced views and scenes, of those who claim them.
#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/renderer_service.pb.h"

namespace flair::contract {
namespace {

constexpr int kSizePx = 256;

v1::RenderRequest View(v1::PreviewView view) {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.mutable_options()->set_view(view);
  request.mutable_options()->set_size_px(kSizePx);
  request.mutable_options()->set_sample_count(1);
  return request;
}

// What is wrong with a view of the bedroom; empty when nothing is.
std::string ViewFault(const v1::Preview& preview, v1::PreviewView view) {
  if (preview.view() != view) return "view " + v1::PreviewView_Name(preview.view());
  const v1::CameraParameters& camera = preview.annotations().camera();
  if (std::max(preview.width_px(), preview.height_px()) != kSizePx || camera.width_px() != preview.width_px()) {
    return fmt::format("{} x {} px with a camera of {} px", preview.width_px(), preview.height_px(), camera.width_px());
  }
  const auto is_bed = [](const v1::Instance& instance) {
    return instance.subject_id() == "bed" && instance.has_placement() && instance.placement().x_m() == 2;
  };
  return std::ranges::any_of(preview.annotations().instances(), is_bed) ? "" : "no instance of the bed at x_m 2";
}

Finding ShowsTheView(Target& target, v1::PreviewView view) {
  const std::string sent = fmt::format("Render of {} as PNG, {} px", v1::PreviewView_Name(view), kSizePx);
  return Given<v1::RenderResponse>(target, sent, View(view), [&](const v1::RenderResponse& answer) {
    const std::string right = "a PNG of that view, annotated with its camera and the placed objects";
    if (!answer.preview().image().starts_with("\x89PNG")) return Broken(sent, "an image that is no PNG", right);
    const std::string fault = ViewFault(answer.preview(), view);
    return fault.empty() ? Kept() : Broken(sent, fault, right);
  });
}

Finding WritesChannels(Target& target) {
  v1::RenderRequest request = View(v1::PREVIEW_VIEW_BIRDSEYE);
  request.mutable_options()->set_format(v1::PREVIEW_FORMAT_EXR);
  const std::string sent = "Render of BIRDSEYE as EXR";
  return Given<v1::RenderResponse>(target, sent, request, [&](const v1::RenderResponse& answer) {
    const bool is_exr = answer.preview().image().starts_with("\x76\x2f\x31\x01");
    return is_exr ? Kept() : Broken(sent, "other bytes", "an OpenEXR file");
  });
}

Finding ExportsAs(Target& target, v1::SceneFormat format, const char* start) {
  v1::ExportSceneRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.set_format(format);
  const std::string sent = fmt::format("ExportScene as {}", v1::SceneFormat_Name(format));
  return Given<v1::ExportSceneResponse>(target, sent, request, [&](const v1::ExportSceneResponse& answer) {
    if (answer.scene().starts_with(start)) return Kept();
    return Broken(sent, fmt::format("{} other bytes", answer.scene().size()),
                  fmt::format("a file that begins with {}", start));
  });
}

}  // namespace

void AddViewChecks(Checks& checks) {
  for (const v1::PreviewView view : {v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_VIEW_PERSPECTIVE}) {
    checks.push_back({fmt::format("{} comes with its camera and its objects", v1::PreviewView_Name(view)),
                      Promise::kMessages, [view](Target& target) { return ShowsTheView(target, view); },
                      v1::CAPABILITY_VIEWS});
  }
  checks.push_back({"A view asked for as EXR is one", Promise::kMessages, WritesChannels, v1::CAPABILITY_VIEWS});
  using Request = v1::RenderRequest;
  AddRefusals<v1::RenderResponse, Request>(
      View(v1::PREVIEW_VIEW_BIRDSEYE),
      {{"a view as SVG", "options.format",
        [](Request& request) {
          request.mutable_options()->set_format(v1::PREVIEW_FORMAT_SVG);
          request.mutable_options()->clear_size_px();
        }},
       {"a view without paths", "options.sample_count",
        [](Request& request) { request.mutable_options()->set_sample_count(0); }},
       {"a camera without an eye", "options.camera.eye_m",
        [](Request& request) { request.mutable_options()->mutable_camera()->add_target_m(1); }},
       {"an EXR that is larger than an answer may be", "options.size_px",
        [](Request& request) {
          request.mutable_options()->set_format(v1::PREVIEW_FORMAT_EXR);
          request.mutable_options()->set_size_px(8192);
        }}},
      checks, v1::CAPABILITY_VIEWS);
  checks.push_back({"A scene asked for as GLB is one", Promise::kMessages,
                    [](Target& target) { return ExportsAs(target, v1::SCENE_FORMAT_GLB, "glTF"); },
                    v1::CAPABILITY_EXPORT_SCENE});
  checks.push_back({"A scene asked for as SceneState is JSON", Promise::kMessages,
                    [](Target& target) { return ExportsAs(target, v1::SCENE_FORMAT_SCENE_STATE, "{"); },
                    v1::CAPABILITY_EXPORT_SCENE});
  v1::ExportSceneRequest scene;
  *scene.mutable_solved_layout() = BedroomLayout();
  scene.set_format(v1::SCENE_FORMAT_GLB);
  AddRefusals<v1::ExportSceneResponse, v1::ExportSceneRequest>(
      scene, {{"a format that is not set", "format", [](v1::ExportSceneRequest& request) { request.clear_format(); }}},
      checks, v1::CAPABILITY_EXPORT_SCENE);
}

}  // namespace flair::contract
