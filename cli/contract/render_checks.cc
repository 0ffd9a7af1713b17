// SPDX-License-Identifier: GPL-3.0-or-later
// Renderer: plans as pictures and pages.
#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/renderer_service.pb.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

constexpr int kSizePx = 512;
constexpr char kAsked[] = "Render of a plan as PNG, 512 px";

v1::RenderRequest Plan() {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.mutable_options()->set_size_px(kSizePx);
  return request;
}

// What is wrong with a picture as the answer to Plan(); empty when nothing is.
std::string PlanFault(const v1::Preview& preview) {
  if (const absl::Status status = Validate(preview); !status.ok()) return std::string(status.message());
  if (preview.format() != v1::PREVIEW_FORMAT_PNG || !preview.image().starts_with("\x89PNG")) {
    return "an image that is no PNG";
  }
  if (preview.view() != v1::PREVIEW_VIEW_PLAN) return "view " + v1::PreviewView_Name(preview.view());
  const int longer = std::max(preview.width_px(), preview.height_px());
  return longer == kSizePx ? "" : fmt::format("{} x {} px", preview.width_px(), preview.height_px());
}

Finding DrawsAPlan(Target& target) {
  return Given<v1::RenderResponse>(target, kAsked, Plan(), [](const v1::RenderResponse& answer) {
    const std::string fault = PlanFault(answer.preview());
    if (!fault.empty()) return Broken(kAsked, fault, "a PNG whose longer side is 512 px, and a preview that says so");
    if (!answer.producer().program().empty()) return Kept();
    return Broken(kAsked, "a producer without program", "who drew it");
  });
}

struct Format {
  v1::PreviewFormat format;
  const char* name;
  const char* start;
};

const Format kFormats[] = {{v1::PREVIEW_FORMAT_JPEG, "JPEG", "\xFF\xD8\xFF"},
                           {v1::PREVIEW_FORMAT_TIFF, "TIFF", "II*"},
                           {v1::PREVIEW_FORMAT_SVG, "SVG", "<?xml"},
                           {v1::PREVIEW_FORMAT_PDF, "PDF", "%PDF"}};

// A renderer may leave formats out, and says so.
Finding DrawsAs(Target& target, const Format& format) {
  v1::RenderRequest request = Plan();
  request.mutable_options()->Clear();
  request.mutable_options()->set_format(format.format);
  const std::string sent = fmt::format("Render of a plan as {}", format.name);
  const auto answer = target.Ask<v1::RenderResponse>(request);
  if (absl::IsUnimplemented(answer.status())) return Skipped(fmt::format("it says that it draws no {}", format.name));
  const std::string right = fmt::format("the bytes of a {}, or UNIMPLEMENTED", format.name);
  if (!answer.ok()) return Broken(sent, StatusText(answer.status()), right);
  if (answer->preview().format() != format.format) {
    return Broken(sent, "format " + v1::PreviewFormat_Name(answer->preview().format()), right);
  }
  return answer->preview().image().starts_with(format.start) ? Kept() : Broken(sent, "other bytes", right);
}

void AddRenderRefusals(Checks& checks) {
  using Request = v1::RenderRequest;
  AddRefusals<v1::RenderResponse, Request>(
      Plan(),
      {{"no layout", "solved_layout", [](Request& request) { request.clear_solved_layout(); }},
       {"an object whose width is no number", "objects[0].width_m",
        [](Request& request) {
          request.mutable_solved_layout()->mutable_graph()->mutable_object_list()->mutable_objects(0)->set_width_m(
              kNaN);
        }},
       {"a placement that is no number", "placements[0].x_m",
        [](Request& request) { request.mutable_solved_layout()->mutable_placements(0)->set_x_m(kNaN); }},
       {"a placement of an object that is not there", "placements[0].object_id",
        [](Request& request) { request.mutable_solved_layout()->mutable_placements(0)->set_object_id("ghost"); }},
       {"a picture of nine pixels", "options.size_px",
        [](Request& request) { request.mutable_options()->set_size_px(9); }},
       {"a view that no enum has", "options.view",
        [](Request& request) { request.mutable_options()->set_view(static_cast<v1::PreviewView>(99)); }},
       {"a format that no enum has", "options.format",
        [](Request& request) { request.mutable_options()->set_format(static_cast<v1::PreviewFormat>(99)); }},
       {"a plan as EXR", "options.format",
        [](Request& request) { request.mutable_options()->set_format(v1::PREVIEW_FORMAT_EXR); }},
       {"a size in pixels for a page", "options.size_px",
        [](Request& request) { request.mutable_options()->set_format(v1::PREVIEW_FORMAT_SVG); }}},
      checks);
}

}  // namespace

Sample RenderSample() {
  v1::RenderRequest large = Plan();
  large.mutable_options()->set_size_px(8192);
  v1::RenderRequest traced = Plan();
  traced.mutable_options()->set_view(v1::PREVIEW_VIEW_PERSPECTIVE);
  traced.mutable_options()->set_size_px(2048);
  traced.mutable_options()->set_sample_count(4096);  // hours
  return {.what = kAsked,
          .request = std::make_shared<v1::RenderRequest>(Plan()),
          .fault =
              [](const std::string& bytes) {
                v1::RenderResponse answer;
                if (!answer.ParseFromString(bytes)) return std::string("bytes that are no RenderResponse");
                return PlanFault(answer.preview());
              },
          .core = [](const std::string& bytes) { return bytes; },
          .long_requests = {std::make_shared<v1::RenderRequest>(large), std::make_shared<v1::RenderRequest>(traced)}};
}

void AddRenderChecks(Checks& checks) {
  checks.push_back({"A plan is a PNG of the size that was asked for", Promise::kMessages, DrawsAPlan});
  for (const Format& format : kFormats) {
    checks.push_back({fmt::format("A plan asked for as {} is one", format.name), Promise::kMessages,
                      [&format](Target& target) { return DrawsAs(target, format); }});
  }
  AddRenderRefusals(checks);
}

}  // namespace flair::contract
