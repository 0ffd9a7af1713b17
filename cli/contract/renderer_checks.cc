// SPDX-License-Identifier: GPL-3.0-or-later
// Renderer: plans as pictures and pages; views, scenes and contact sheets of those who claim them.
#include <algorithm>
#include <array>

#include "cli/contract/bedroom.h"
#include "cli/contract/stage_checks.h"
#include "flair/v1/renderer_service.pb.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

constexpr int kPlanPx = 512;
constexpr int kViewPx = 256;
constexpr char kPlan[] = "Render of a plan as PNG, 512 px";
constexpr char kPng[] = "\x89PNG";

v1::RenderRequest Plan() {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.mutable_options()->set_size_px(kPlanPx);
  return request;
}

v1::RenderRequest View(v1::PreviewView view, v1::PreviewFormat format) {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.mutable_options()->set_view(view);
  request.mutable_options()->set_format(format);
  request.mutable_options()->set_size_px(kViewPx);
  request.mutable_options()->set_sample_count(1);
  return request;
}

// What is wrong with a picture as the answer to Plan(); empty when nothing is.
std::string PlanFault(const v1::RenderResponse& answer) {
  const v1::Preview& preview = answer.preview();
  if (const absl::Status status = Validate(preview); !status.ok()) return std::string(status.message());
  if (preview.format() != v1::PREVIEW_FORMAT_PNG || !preview.image().starts_with(kPng))
    return "an image that is no PNG";
  if (preview.view() != v1::PREVIEW_VIEW_PLAN) return "view " + v1::PreviewView_Name(preview.view());
  const int longer = std::max(preview.width_px(), preview.height_px());
  return longer == kPlanPx ? "" : fmt::format("{} x {} px", preview.width_px(), preview.height_px());
}

Finding DrawsAPlan(const v1::RenderResponse& answer) {
  const std::string fault = PlanFault(answer);
  if (!fault.empty()) return Wrong(fault);
  return answer.producer().program().empty() ? Wrong("a producer without program", "who drew it") : Kept();
}

struct Format {
  v1::PreviewFormat format;
  const char* name;
  const char* start;
};
constexpr std::array<Format, 4> kFormats = {{{v1::PREVIEW_FORMAT_JPEG, "JPEG", "\xFF\xD8\xFF"},
                                             {v1::PREVIEW_FORMAT_TIFF, "TIFF", "II*"},
                                             {v1::PREVIEW_FORMAT_SVG, "SVG", "<?xml"},
                                             {v1::PREVIEW_FORMAT_PDF, "PDF", "%PDF"}}};

// A renderer may leave formats out, and says so.
Finding DrawsAs(const Format& format, Target& target) {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.mutable_options()->set_format(format.format);
  const auto answer = target.Ask<v1::RenderResponse>(request);
  if (absl::IsUnimplemented(answer.status())) return Skipped(fmt::format("it says that it draws no {}", format.name));
  RETURN_IF_ERROR(answer.status());
  if (answer->preview().format() != format.format) {
    return Wrong("format " + v1::PreviewFormat_Name(answer->preview().format()));
  }
  return answer->preview().image().starts_with(format.start) ? Kept() : Wrong("other bytes");
}

// What is wrong with a view of the bedroom; empty when nothing is.
std::string ViewFault(const v1::Preview& preview, v1::PreviewView view) {
  if (!preview.image().starts_with(kPng)) return "an image that is no PNG";
  if (preview.view() != view) return "view " + v1::PreviewView_Name(preview.view());
  const v1::CameraParameters& camera = preview.annotations().camera();
  if (std::max(preview.width_px(), preview.height_px()) != kViewPx || camera.width_px() != preview.width_px()) {
    return fmt::format("{} x {} px with a camera of {} px", preview.width_px(), preview.height_px(), camera.width_px());
  }
  const auto is_bed = [](const v1::Instance& instance) {
    return instance.subject_id() == "bed" && instance.has_placement() && instance.placement().x_m() == 2;
  };
  return std::ranges::any_of(preview.annotations().instances(), is_bed) ? "" : "no instance of the bed at x_m 2";
}

Check ExportCheck(const char* name, v1::SceneFormat format, const std::string& start) {
  v1::ExportSceneRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  request.set_format(format);
  return {name,
          Promise::kMessages,
          fmt::format("ExportScene as {}", v1::SceneFormat_Name(format)),
          fmt::format("a file that begins with {}", start),
          Answered<v1::ExportSceneResponse>(request,
                                            [start](const v1::ExportSceneResponse& answer) {
                                              if (answer.scene().starts_with(start)) return Kept();
                                              return Wrong(fmt::format("{} other bytes", answer.scene().size()));
                                            }),
          v1::CAPABILITY_EXPORT_SCENE};
}

v1::ContactSheetTile LayoutTile() {
  v1::ContactSheetTile tile;
  tile.set_caption("bedroom");
  *tile.mutable_solved_layout() = BedroomLayout();
  return tile;
}

v1::ContactSheetTile ImageTile(const std::string& bytes) {
  v1::ContactSheetTile tile;
  tile.set_caption("image");
  tile.set_image(bytes);
  return tile;
}

// Sends the options and the tiles, and waits for the answer.
absl::StatusOr<v1::ComposeContactSheetResponse> Compose(const Target& target, int tile_count,
                                                        const std::vector<v1::ContactSheetTile>& tiles) {
  std::vector<v1::ComposeContactSheetRequest> requests(1);
  requests[0].mutable_options()->set_tile_count(tile_count);
  requests[0].mutable_options()->set_tile_px(96);
  for (const v1::ContactSheetTile& tile : tiles) *requests.emplace_back().mutable_tile() = tile;
  ASSIGN_OR_RETURN(const auto answers, target.Stream<v1::ComposeContactSheetResponse>(requests));
  if (answers.size() == 1) return answers[0];
  return absl::DataLossError(fmt::format("{} answers", answers.size()));
}

Finding ComposesTiles(Target& target) {
  ASSIGN_OR_RETURN(const v1::RenderResponse picture, target.Ask<v1::RenderResponse>(Plan()));
  ASSIGN_OR_RETURN(const auto answer, Compose(target, 2, {LayoutTile(), ImageTile(picture.preview().image())}));
  if (answer.sheet().image().starts_with(kPng) && answer.diagnostics().empty()) return Kept();
  return Wrong(
      fmt::format("an image of {} bytes and {} diagnostics", answer.sheet().image().size(), answer.diagnostics_size()));
}

Finding BrokenTilesAreTold(Target& target) {
  ASSIGN_OR_RETURN(const auto answer, Compose(target, 2, {ImageTile("no picture"), LayoutTile()}));
  const bool told =
      answer.diagnostics_size() == 1 && answer.diagnostics(0).message().find("image") != std::string::npos;
  return told ? Kept() : Wrong(fmt::format("{} diagnostics", answer.diagnostics_size()));
}

Finding WrongCountsAreRefused(Target& target) {
  const std::pair<int, std::vector<v1::ContactSheetTile>> rows[] = {
      {1, {LayoutTile(), LayoutTile()}}, {2, {LayoutTile()}}, {0, {}}};
  for (const auto& [promised, tiles] : rows) {
    const absl::Status status = Compose(target, promised, tiles).status();
    if (absl::IsInvalidArgument(status)) continue;
    return Wrong(status.ok() ? "OK, with a sheet" : StatusText(status), "",
                 fmt::format("ComposeContactSheet with tile_count {} and {} tiles", promised, tiles.size()));
  }
  return Kept();
}

}  // namespace

Sample RenderSample() {
  auto large = std::make_shared<v1::RenderRequest>(Plan());
  large->mutable_options()->set_size_px(8192);
  auto traced = std::make_shared<v1::RenderRequest>(Plan());
  traced->mutable_options()->set_view(v1::PREVIEW_VIEW_PERSPECTIVE);
  traced->mutable_options()->set_size_px(2048);
  traced->mutable_options()->set_sample_count(4096);  // hours
  return {.what = kPlan,
          .request = std::make_shared<v1::RenderRequest>(Plan()),
          .fault = FaultOf<v1::RenderResponse>(PlanFault),
          .core = [](const std::string& bytes) { return bytes; },
          .long_requests = {large, traced}};
}

Checks RendererChecks() {
  using Response = v1::RenderResponse;
  Checks checks = {{"A plan is a PNG of the size that was asked for", Promise::kMessages, kPlan,
                    "a PNG whose longer side is 512 px, and a preview that says so",
                    Answered<Response>(Plan(), DrawsAPlan)}};
  for (const Format& format : kFormats) {
    checks.push_back({fmt::format("A plan asked for as {} is one", format.name), Promise::kMessages,
                      fmt::format("Render of a plan as {}", format.name),
                      fmt::format("the bytes of a {}, or UNIMPLEMENTED", format.name),
                      [&format](Target& target) { return DrawsAs(format, target); }});
  }
  for (const v1::PreviewView view : {v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_VIEW_PERSPECTIVE}) {
    const std::string& name = v1::PreviewView_Name(view);
    checks.push_back(
        {fmt::format("{} comes with its camera and its objects", name), Promise::kMessages,
         fmt::format("Render of {} as PNG, {} px", name, kViewPx),
         "a PNG of that view, annotated with its camera and the placed objects",
         Answered<Response>(View(view, v1::PREVIEW_FORMAT_PNG),
                            [view](const Response& answer) { return WrongIf(ViewFault(answer.preview(), view)); }),
         v1::CAPABILITY_VIEWS});
  }
  checks.push_back({"A view asked for as EXR is one", Promise::kMessages, "Render of BIRDSEYE as EXR",
                    "an OpenEXR file",
                    Answered<Response>(View(v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_FORMAT_EXR),
                                       [](const Response& answer) {
                                         const bool is_exr = answer.preview().image().starts_with("\x76\x2f\x31\x01");
                                         return is_exr ? Kept() : Wrong("other bytes");
                                       }),
                    v1::CAPABILITY_VIEWS});
  checks.push_back(ExportCheck("A scene asked for as GLB is one", v1::SCENE_FORMAT_GLB, "glTF"));
  checks.push_back(ExportCheck("A scene asked for as SceneState is JSON", v1::SCENE_FORMAT_SCENE_STATE, "{"));
  checks.push_back({"Layouts and pictures become one sheet", Promise::kMessages,
                    "ComposeContactSheet of a layout and a PNG", "one PNG and no diagnostics", ComposesTiles,
                    v1::CAPABILITY_CONTACT_SHEET});
  checks.push_back({"A tile that cannot be drawn is told of, and the sheet comes", Promise::kMessages,
                    "ComposeContactSheet of a layout and of an image that is none",
                    "the sheet, with one diagnostic that names the caption \"image\"", BrokenTilesAreTold,
                    v1::CAPABILITY_CONTACT_SHEET});
  checks.push_back({"Too many, too few and no tiles are refused", Promise::kErrors, "ComposeContactSheet",
                    "INVALID_ARGUMENT", WrongCountsAreRefused, v1::CAPABILITY_CONTACT_SHEET});
  return checks;
}

}  // namespace flair::contract
