// SPDX-License-Identifier: GPL-3.0-or-later
// Tools that change a room.
#include <cmath>
#include <numbers>
#include <set>

#include "cli/mcp/document_tools.h"
#include "cli/mcp/layout_json.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli::mcp {
namespace {

double Radians(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  return (turn < 0 ? turn + 360 : turn) * std::numbers::pi / 180;
}

void AddArgument(const std::string& name, const std::string& text, v1::ConstraintEdge& edge) {
  v1::Argument& argument = *edge.add_arguments();
  argument.set_name(name);
  argument.mutable_value()->set_text(text);
}

// What differs between two layouts, and how good the second is.
Json ActedJson(const v1::GetDocumentResponse& before, const v1::ActResponse& after, const std::string& done) {
  constexpr int kMostRemarks = 30;
  const v1::SolvedLayout& layout = after.layout();
  const v1::LayoutGraph& graph = layout.has_graph() ? layout.graph() : before.layout().graph();
  Json json = {{"document_id", after.document().id()},
               {"revision", after.document().revision()},
               {"done", done},
               {"moved", Json::array()},
               {"removed", Json::array()},
               {"remarks", Json::array()},
               {"measures", MeasuresJson(layout.edge_outcomes(), layout.metrics())},
               {"faults", FaultsJson(graph, layout.metrics())}};
  std::set<std::string> left;
  for (const v1::Object& object : graph.object_list().objects()) {
    left.insert(object.id());
    const v1::Placement* from = PlacementOf(before.layout(), object.id());
    const v1::Placement* to = PlacementOf(layout, object.id());
    const bool same =
        from == nullptr ? to == nullptr : to != nullptr && from->SerializeAsString() == to->SerializeAsString();
    if (!same) json["moved"].push_back(PlaceJson(graph, object, to));
  }
  for (const v1::Object& object : before.layout().graph().object_list().objects()) {
    if (!left.contains(object.id())) json["removed"].push_back(object.id());
  }
  std::set<std::string> known;
  for (const v1::Diagnostic& diagnostic : before.layout().diagnostics()) known.insert(diagnostic.message());
  for (const v1::Diagnostic& diagnostic : after.diagnostics()) {
    // That constraints go with what they name is nothing to tell.
    if (diagnostic.code() == "edge_removed" || known.contains(diagnostic.message())) continue;
    if (json["remarks"].size() < kMostRemarks) json["remarks"].push_back(diagnostic.message());
  }
  if (!after.answer().empty()) json["answer"] = after.answer();
  if (!after.left_over().empty()) json["left_over"] = after.left_over();
  AddHistory(after.document(), json);
  return json;
}

}  // namespace

DocumentTools::Result DocumentTools::Act(const Json& arguments, ToolCall& call, const Fill& fill) {
  // Another call may change the room between reading and acting; who names a revision wants to hear of it.
  constexpr int kMostTries = 5;
  for (int i = 0;; ++i) {
    ASSIGN_OR_RETURN(const v1::GetDocumentResponse before, Shown(arguments.at("document_id")));
    v1::ActRequest request;
    request.set_document_id(before.document().id());
    request.set_revision(arguments.value("revision", before.document().revision()));
    RETURN_IF_ERROR(fill(before.layout(), request));
    absl::StatusOr<v1::ActResponse> after = documents_.Act(request, call.context());
    if (absl::IsAborted(after.status()) && !arguments.contains("revision") && i + 1 < kMostTries) continue;
    RETURN_IF_ERROR(after.status());
    const std::string done = request.has_undo()   ? "undo: " + before.document().undo_label()
                             : request.has_redo() ? "redo: " + before.document().redo_label()
                             : after->document().layout_id() == before.document().layout_id()
                                 ? "nothing"
                                 : after->document().undo_label();
    ToolResult result;
    result.structured = ActedJson(before, *after, done);
    return result;
  }
}

absl::Status DocumentTools::FillMove(const Json& arguments, const v1::SolvedLayout& shown, v1::ActRequest& request) {
  ASSIGN_OR_RETURN(const v1::Object* object, ObjectMeant(shown.graph(), arguments.at("object"), "object"));
  v1::Placement to;
  const v1::Placement* from = PlacementOf(shown, object->id());
  if (from != nullptr) to = *from;
  to.set_object_id(object->id());
  to.set_x_m(arguments.at("x_m").get<double>());
  to.set_y_m(arguments.at("y_m").get<double>());
  if (arguments.contains("heading_deg")) to.set_theta_rad(Radians(arguments.at("heading_deg").get<double>()));
  if (arguments.value("settle", true)) {
    *request.mutable_edit()->add_edits()->mutable_move_object() = to;
  } else {
    *request.mutable_move()->add_placements() = to;
  }
  return absl::OkStatus();
}

absl::StatusOr<v1::Object> DocumentTools::FurnitureMeant(const Json& arguments, runtime::CallContext& call) {
  const std::string words = arguments.at("furniture").get<std::string>();
  v1::ListFurnitureRequest search;
  search.set_query(words);
  ASSIGN_OR_RETURN(const v1::ListFurnitureResponse found, documents_.ListFurniture(search, call));
  v1::Object object;
  if (!found.offers().empty()) {
    object = found.offers(0).object();
  } else if (arguments.contains("width_m") && arguments.contains("depth_m") && arguments.contains("height_m")) {
    object.set_name(words);
  } else {
    return InvalidArgument(
        "furniture: \"{}\" is not in the catalogue: give all three sizes, or search it with "
        "find_furniture",
        words);
  }
  if (arguments.contains("width_m")) object.set_width_m(arguments.at("width_m").get<double>());
  if (arguments.contains("depth_m")) object.set_depth_m(arguments.at("depth_m").get<double>());
  if (arguments.contains("height_m")) object.set_height_m(arguments.at("height_m").get<double>());
  return object;
}

absl::Status DocumentTools::FillAdd(const Json& arguments, runtime::CallContext& call, const v1::SolvedLayout& shown,
                                    v1::ActRequest& request) {
  constexpr double kNear_m = 1;
  v1::EditLayout& edit = *request.mutable_edit();
  edit.set_without_solving(!arguments.value("settle", true));
  v1::AddObject& add = *edit.add_edits()->mutable_add_object();
  ASSIGN_OR_RETURN(*add.mutable_object(), FurnitureMeant(arguments, call));
  const bool carried = add.object().kind() == v1::OBJECT_KIND_SURFACE;
  if (arguments.contains("near")) {
    ASSIGN_OR_RETURN(const v1::Object* near, ObjectMeant(shown.graph(), arguments.at("near"), "near"));
    add.mutable_object()->set_zone_id(near->zone_id());
    if (carried) add.mutable_object()->set_host_id(near->id());
    v1::ConstraintEdge& edge = *add.add_edges();
    edge.set_type(carried ? "on" : "near");
    edge.set_weight(1);
    // Empty: what is added.
    AddArgument("object", "", edge);
    AddArgument("target", near->id(), edge);
    if (!carried) {
      v1::Argument& most = *edge.add_arguments();
      most.set_name("max_distance_m");
      most.mutable_value()->set_number(kNear_m);
    }
  } else if (carried) {
    return InvalidArgument("near: a {} stands on another piece: say on which", add.object().name());
  }
  if (arguments.contains("x_m") != arguments.contains("y_m")) {
    return absl::InvalidArgumentError("x_m, y_m: a place needs both");
  }
  if (!arguments.contains("x_m")) {
    if (!arguments.contains("heading_deg")) return absl::OkStatus();
    return absl::InvalidArgumentError("heading_deg: needs a place, x_m and y_m");
  }
  v1::Placement& at = *edit.add_edits()->mutable_move_object();
  at.set_x_m(arguments.at("x_m").get<double>());
  at.set_y_m(arguments.at("y_m").get<double>());
  at.set_theta_rad(Radians(arguments.value("heading_deg", 0.0)));
  return absl::OkStatus();
}

absl::Status DocumentTools::FillReplace(const Json& arguments, runtime::CallContext& call,
                                        const v1::SolvedLayout& shown, v1::ActRequest& request) {
  ASSIGN_OR_RETURN(const v1::Object* object, ObjectMeant(shown.graph(), arguments.at("object"), "object"));
  request.mutable_replace()->set_object_id(object->id());
  ASSIGN_OR_RETURN(*request.mutable_replace()->mutable_by(), FurnitureMeant(arguments, call));
  return absl::OkStatus();
}

absl::Status DocumentTools::FillResize(const Json& arguments, const v1::SolvedLayout& shown, v1::ActRequest& request) {
  ASSIGN_OR_RETURN(const v1::Object* object, ObjectMeant(shown.graph(), arguments.at("object"), "object"));
  request.mutable_edit()->set_without_solving(!arguments.value("settle", true));
  v1::ResizeObject& resize = *request.mutable_edit()->add_edits()->mutable_resize_object();
  resize.set_object_id(object->id());
  if (arguments.contains("width_m")) resize.set_width_m(arguments.at("width_m").get<double>());
  if (arguments.contains("depth_m")) resize.set_depth_m(arguments.at("depth_m").get<double>());
  if (arguments.contains("height_m")) resize.set_height_m(arguments.at("height_m").get<double>());
  if (resize.has_width_m() || resize.has_depth_m() || resize.has_height_m()) return absl::OkStatus();
  return absl::InvalidArgumentError("width_m, depth_m, height_m: give at least one");
}

}  // namespace flair::cli::mcp
