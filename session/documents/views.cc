// SPDX-License-Identifier: GPL-3.0-or-later
// What documents look like: reasons, drawings, and furniture to choose from. Nothing here changes one.
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <set>

#include "absl/strings/numbers.h"
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

}  // namespace

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
