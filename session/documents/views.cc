// SPDX-License-Identifier: GPL-3.0-or-later
// What documents look like: reasons, drawings, files, and furniture to choose from. Nothing here changes one.
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <set>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "session/documents/documents.h"
#include "session/documents/furniture_search.h"
#include "session/documents/record.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

constexpr size_t kMostOffers = 200;

// What a document is called as a file: "a-bedroom-for-two". A long one ends with a whole word.
std::string FileStemOf(const std::string& title) {
  constexpr size_t kMost = 60;
  std::string stem;
  for (const char c : title) {
    const char low = absl::ascii_tolower(static_cast<unsigned char>(c));
    if (absl::ascii_isalnum(static_cast<unsigned char>(low))) {
      stem += low;
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  if (const size_t end = stem.rfind('-', kMost); stem.size() > kMost) {
    stem.resize(end == std::string::npos ? kMost : end);
  }
  while (stem.ends_with('-')) stem.pop_back();
  return stem.empty() ? "room" : stem;
}

struct Format {
  v1::DocumentFormat format;
  const char* ending;
  const char* media_type;
  v1::PreviewView view = v1::PREVIEW_VIEW_UNSPECIFIED;
  v1::PreviewFormat preview = v1::PREVIEW_FORMAT_UNSPECIFIED;
};
constexpr Format kFormats[] = {
    {v1::DOCUMENT_FORMAT_PLAN_PNG, ".png", "image/png", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PNG},
    {v1::DOCUMENT_FORMAT_PLAN_SVG, ".svg", "image/svg+xml", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_SVG},
    {v1::DOCUMENT_FORMAT_PLAN_PDF, ".pdf", "application/pdf", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PDF},
    {v1::DOCUMENT_FORMAT_BIRDSEYE_PNG, "-birdseye.png", "image/png", v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_FORMAT_PNG},
    {v1::DOCUMENT_FORMAT_PERSPECTIVE_PNG, "-perspective.png", "image/png", v1::PREVIEW_VIEW_PERSPECTIVE,
     v1::PREVIEW_FORMAT_PNG},
    {v1::DOCUMENT_FORMAT_SCENE_GLB, ".glb", "model/gltf-binary"},
    {v1::DOCUMENT_FORMAT_REPORT, ".md", "text/markdown; charset=utf-8"},
    {v1::DOCUMENT_FORMAT_LAYOUT_PB, ".pb", "application/x-protobuf"},
    {v1::DOCUMENT_FORMAT_LAYOUT_JSON, ".json", "application/json"},
    {v1::DOCUMENT_FORMAT_ARTIFACTS_TAR, ".tar", "application/x-tar"}};

// What the renderer is asked to draw. It wants a piece: an empty room gets one that stands nowhere, which is left out.
v1::SolvedLayout Drawable(const v1::SolvedLayout& layout) {
  v1::SolvedLayout drawable = layout;
  drawable.clear_runner_ups();
  v1::LayoutGraph& graph = *drawable.mutable_graph();
  if (!graph.object_list().objects().empty()) return drawable;
  v1::Object& nothing = *graph.mutable_object_list()->add_objects();
  nothing.set_id("nothing");
  nothing.set_name("nothing");
  nothing.set_kind(v1::OBJECT_KIND_FLOOR);
  nothing.set_role(v1::OBJECT_ROLE_TERTIARY);
  nothing.set_zone_id(graph.zone_plan().zones().empty() ? "" : graph.zone_plan().zones(0).id());
  for (const auto set : {&v1::Object::set_width_m, &v1::Object::set_depth_m, &v1::Object::set_height_m})
    (nothing.*set)(0.1);
  return drawable;
}

template <typename Request>
void SetOrigin(const v1::Artifact& layout, const v1::Document& document, Request& request) {
  *request.mutable_solved_layout() = Drawable(layout.solved_layout());
  request.set_job_id(layout.id());
  if (!document.has_brief()) return;
  request.set_brief_text(document.brief().text());
  request.set_brief_seed(document.brief().seed());
}

}  // namespace

absl::StatusOr<v1::JudgeResponse> Documents::Judge(const v1::JudgeRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(const Record record, GetAt(request.document_id(), request.revision()));
  ASSIGN_OR_RETURN(const Layout layout, Shown(record));
  return acts_.Judge(layout->solved_layout(), request, call);
}

absl::StatusOr<v1::ExplainResponse> Documents::Explain(const v1::ExplainRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(const Record record, store_->Get(request.document_id()));
  ASSIGN_OR_RETURN(const Layout layout, Shown(record));
  v1::ExplainResponse response;
  response.set_revision(record.document().revision());
  // Of an empty room there is nothing to say.
  if (layout->solved_layout().graph().object_list().objects().empty()) return response;
  ASSIGN_OR_RETURN(const v1::ConstraintCatalog catalog, stages_.Catalog(call));
  ASSIGN_OR_RETURN(const std::string note, parts_.note_json(layout->solved_layout(), catalog));
  if (!google::protobuf::util::JsonStringToMessage(note, response.mutable_note()).ok()) {
    return absl::InternalError("the note of the layout is no JSON");
  }
  for (std::string& line : parts_.not_as_asked(layout->solved_layout())) response.add_not_as_asked(std::move(line));
  return response;
}

absl::StatusOr<v1::Artifact> Documents::GetArtifact(const std::string& artifact_id, CallContext& call) {
  absl::StatusOr<v1::Artifact> layout = store_->FindLayout(artifact_id);
  if (!absl::IsNotFound(layout.status())) return layout;
  return stages_.GetArtifact(artifact_id, call);
}

absl::StatusOr<v1::DrawDocumentResponse> Documents::Draw(const v1::DrawDocumentRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(const Record record, store_->Get(request.document_id()));
  ASSIGN_OR_RETURN(const Layout layout, Shown(record));
  v1::DrawPlanPartsRequest draw;
  *draw.mutable_solved_layout() = Drawable(layout->solved_layout());
  *draw.mutable_object_ids() = request.object_ids();
  ASSIGN_OR_RETURN(v1::DrawPlanPartsResponse drawn, stages_.DrawPlanParts(std::move(draw), call));
  // Another renderer's drawing goes into the page: it may only draw.
  RETURN_IF_ERROR(Validate(drawn.parts(), "parts"));
  v1::DrawDocumentResponse response;
  response.set_revision(record.document().revision());
  response.mutable_parts()->Swap(drawn.mutable_parts());
  return response;
}

absl::StatusOr<v1::ExportDocumentResponse> Documents::Export(const v1::ExportDocumentRequest& request,
                                                             CallContext& call) {
  const auto* const format = std::ranges::find(kFormats, request.format(), &Format::format);
  if (format == std::end(kFormats)) {
    return InvalidArgument("format: {}; is none that a document has", static_cast<int>(request.format()));
  }
  ASSIGN_OR_RETURN(const Record record, store_->Get(request.document_id()));
  ASSIGN_OR_RETURN(const Layout layout, Shown(record));
  v1::ExportDocumentResponse response;
  response.set_file_name(FileStemOf(DocumentOf(record).title()) + format->ending);
  response.set_media_type(format->media_type);
  if (format->view != v1::PREVIEW_VIEW_UNSPECIFIED) {
    v1::RenderRequest render;
    SetOrigin(*layout, DocumentOf(record), render);
    *render.mutable_options() = request.options();
    render.mutable_options()->set_view(format->view);
    render.mutable_options()->set_format(format->preview);
    ASSIGN_OR_RETURN(v1::RenderResponse drawn, stages_.Render(std::move(render), call));
    response.mutable_content()->swap(*drawn.mutable_preview()->mutable_image());
  } else if (format->format == v1::DOCUMENT_FORMAT_SCENE_GLB) {
    v1::ExportSceneRequest scene;
    SetOrigin(*layout, DocumentOf(record), scene);
    scene.set_format(v1::SCENE_FORMAT_GLB);
    ASSIGN_OR_RETURN(v1::ExportSceneResponse made, stages_.ExportScene(std::move(scene), call));
    response.mutable_content()->swap(*made.mutable_scene());
  } else if (format->format == v1::DOCUMENT_FORMAT_REPORT) {
    ASSIGN_OR_RETURN(const v1::ConstraintCatalog catalog, stages_.Catalog(call));
    ASSIGN_OR_RETURN(const std::string text, parts_.note_text(layout->solved_layout(), catalog));
    response.set_content(text);
  } else if (format->format == v1::DOCUMENT_FORMAT_LAYOUT_PB) {
    response.set_content(cli::ArtifactBytes(*layout));
  } else if (format->format == v1::DOCUMENT_FORMAT_ARTIFACTS_TAR) {
    ASSIGN_OR_RETURN(*response.mutable_content(), ArchiveOf(layout, call));
  } else {
    response.set_content(cli::ToJson(*layout));
  }
  return response;
}

absl::StatusOr<v1::ListFurnitureResponse> Documents::ListFurniture(const v1::ListFurnitureRequest& request,
                                                                   CallContext& call) {
  std::vector<const v1::FurnitureOffer*> found = FoundFurniture(parts_, request.query());
  if (found.size() > kMostOffers) found.resize(kMostOffers);
  v1::DrawPlanPartsRequest draw;
  v1::LayoutGraph& graph = *draw.mutable_solved_layout()->mutable_graph();
  v1::Room& room = *graph.mutable_room();
  constexpr double kSide_m = 40;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {kSide_m, 0.0}, {kSide_m, kSide_m}, {0.0, kSide_m}}) {
    v1::Point2& corner = *room.mutable_floor()->add_vertices();
    corner.set_x_m(x);
    corner.set_y_m(y);
  }
  for (const char* name : {"south", "east", "north", "west"}) room.add_walls()->set_name(name);
  room.set_room_type("room");
  room.set_title("Furniture");
  room.set_height_m(3);
  v1::Zone& zone = *graph.mutable_zone_plan()->add_zones();
  zone.set_id("room");
  zone.set_name("room");
  v1::ListFurnitureResponse response;
  for (const v1::FurnitureOffer* const offer : found) {
    v1::Object& object = *graph.mutable_object_list()->add_objects();
    object = offer->object();
    object.set_id(fmt::format("offer_{}", response.offers_size()));
    object.set_zone_id("room");
    draw.add_object_ids(object.id());
    v1::Placement& at = *draw.mutable_solved_layout()->add_placements();
    at.set_object_id(object.id());
    at.set_x_m(kSide_m / 2);
    at.set_y_m(kSide_m / 2);
    *response.add_offers() = *offer;
  }
  // Without symbols a name and a size are left: not every renderer draws parts.
  if (found.empty()) return response;
  absl::StatusOr<v1::DrawPlanPartsResponse> drawn = stages_.DrawPlanParts(std::move(draw), call);
  if (absl::IsUnimplemented(drawn.status())) return response;
  RETURN_IF_ERROR(drawn.status());
  RETURN_IF_ERROR(Validate(drawn->parts(), "parts"));
  for (v1::PlanPart& part : *drawn->mutable_parts()->mutable_parts()) {
    int index = -1;
    if (!absl::SimpleAtoi(part.object_id().substr(std::min<size_t>(6, part.object_id().size())), &index)) continue;
    if (index >= 0 && index < response.offers_size())
      response.mutable_offers(index)->mutable_svg()->swap(*part.mutable_svg());
  }
  return response;
}

}  // namespace flair::session
