// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "absl/status/statusor.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "room/conversion/conversion.h"
#include "room/geometry/pose.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

absl::Status Wrong(std::string problem) { return absl::InvalidArgumentError(problem); }

// Applies edits to a problem; every method returns what is wrong with its edit, starting with the field.
class Editor {
 public:
  explicit Editor(EditedProblem& problem) : problem_(problem) {}

  absl::Status Apply(const v1::LayoutEdit& edit) {
    switch (edit.edit_case()) {
      case v1::LayoutEdit::kMoveObject:
        return Move(edit.move_object());
      case v1::LayoutEdit::kPinObjectId:
        return Pin(edit.pin_object_id());
      case v1::LayoutEdit::kUnpinObjectId:
        return Unpin(edit.unpin_object_id());
      case v1::LayoutEdit::kResizeObject:
        return Resize(edit.resize_object());
      case v1::LayoutEdit::kAddObject:
        return Add(edit.add_object());
      case v1::LayoutEdit::kRemoveObjectId:
        return Remove(edit.remove_object_id());
      case v1::LayoutEdit::kAddEdge:
        return AddEdge(edit.add_edge(), "add_edge");
      case v1::LayoutEdit::kRemoveEdgeId:
        return RemoveEdge(edit.remove_edge_id());
      case v1::LayoutEdit::kSetEdgeWeight:
        return Weigh(edit.set_edge_weight());
      case v1::LayoutEdit::EDIT_NOT_SET:
        break;
    }
    return Wrong(": is not set; choose one of its fields");
  }

 private:
  v1::LayoutGraph& graph() { return problem_.graph; }

  v1::Object* FindObject(const std::string& id) {
    for (v1::Object& object : *graph().mutable_object_list()->mutable_objects()) {
      if (object.id() == id) return &object;
    }
    return nullptr;
  }
  v1::Placement* FindPlacement(const std::string& id) {
    for (v1::Placement& placement : problem_.placements) {
      if (placement.object_id() == id) return &placement;
    }
    return nullptr;
  }
  int FindEdge(const std::string& id) {
    for (int e = 0; e < graph().edges_size(); ++e) {
      if (graph().edges(e).id() == id) return e;
    }
    return -1;
  }
  int FindPin(const std::string& id) {
    for (int i = 0; i < graph().pinned_placements_size(); ++i) {
      if (graph().pinned_placements(i).object_id() == id) return i;
    }
    return -1;
  }
  std::string NoObject(const char* field, const std::string& id) {
    std::string known;
    for (const v1::Object& object : graph().object_list().objects()) known += (known.empty() ? "" : ", ") + object.id();
    return fmt::format(".{}: \"{}\" is not an object of the layout; those are {}", field, id, known);
  }
  std::string NoEdge(const char* field, const std::string& id) {
    return fmt::format(".{}: \"{}\" is not a constraint of the layout; they run from \"{}\" to \"{}\"", field, id,
                       graph().edges().empty() ? "" : graph().edges(0).id(),
                       graph().edges().empty() ? "" : graph().edges(graph().edges_size() - 1).id());
  }
  // The graph after an edit, as every solve checks it.
  absl::Status Check(const char* field) {
    const absl::Status status = Validate(graph(), "the graph after it");
    return status.ok() ? status : Wrong(fmt::format(".{}: {}", field, std::string(status.message())));
  }
  void Touch(const v1::ConstraintEdge& edge) {
    problem_.edited_edges.insert(edge.id());
    for (const v1::Argument& argument : edge.arguments()) {
      if (FindObject(argument.value().text()) != nullptr) problem_.touched.insert(argument.value().text());
      for (const std::string& text : argument.value().texts().items()) {
        if (FindObject(text) != nullptr) problem_.touched.insert(text);
      }
    }
  }

  // The surface objects that an edge names together with `id`.
  void TouchRidersOf(const std::string& id, const v1::ConstraintEdge& edge) {
    const auto named = [&](const v1::Argument& argument) { return argument.value().text() == id; };
    if (std::ranges::none_of(edge.arguments(), named)) return;
    for (const v1::Argument& argument : edge.arguments()) {
      const v1::Object* object = FindObject(argument.value().text());
      if (object != nullptr && object->kind() == v1::OBJECT_KIND_SURFACE) problem_.touched.insert(object->id());
    }
  }

  absl::Status Move(const v1::Placement& target) {
    if (FindObject(target.object_id()) == nullptr) return Wrong(NoObject("move_object", target.object_id()));
    if (!std::isfinite(target.theta_rad()) || std::abs(target.theta_rad()) > 1e6) {
      return Wrong(fmt::format(".move_object.theta_rad: {} is not an angle in radians", target.theta_rad()));
    }
    v1::Placement* placement = FindPlacement(target.object_id());
    if (placement == nullptr) {
      placement = &problem_.placements.emplace_back();
      placement->set_object_id(target.object_id());
      placement->set_z_m(target.z_m());
    }
    placement->set_x_m(target.x_m());
    placement->set_y_m(target.y_m());
    placement->set_theta_rad(WrapHeading(target.theta_rad()));
    problem_.touched.insert(target.object_id());
    SetPin(*placement);
    return Check("move_object");
  }
  void SetPin(const v1::Placement& placement) {
    const int pin = FindPin(placement.object_id());
    *(pin >= 0 ? graph().mutable_pinned_placements(pin) : graph().add_pinned_placements()) = placement;
  }
  absl::Status Pin(const std::string& id) {
    if (FindObject(id) == nullptr) return Wrong(NoObject("pin_object_id", id));
    const v1::Placement* placement = FindPlacement(id);
    if (placement == nullptr) {
      return Wrong(fmt::format(".pin_object_id: \"{}\" has no place in the layout; move it to one", id));
    }
    SetPin(*placement);
    return Check("pin_object_id");
  }
  absl::Status Unpin(const std::string& id) {
    const int pin = FindPin(id);
    if (pin < 0) return Wrong(fmt::format(".unpin_object_id: \"{}\" is not pinned", id));
    graph().mutable_pinned_placements()->DeleteSubrange(pin, 1);
    problem_.touched.insert(id);
    return absl::OkStatus();
  }
  absl::Status Resize(const v1::ResizeObject& size) {
    v1::Object* object = FindObject(size.object_id());
    if (object == nullptr) return Wrong(NoObject("resize_object", size.object_id()));
    const double grown_m = size.has_depth_m() ? size.depth_m() - object->depth_m() : 0;
    if (size.has_width_m()) object->set_width_m(size.width_m());
    if (size.has_depth_m()) object->set_depth_m(size.depth_m());
    if (size.has_height_m()) object->set_height_m(size.height_m());
    problem_.touched.insert(size.object_id());
    RETURN_IF_ERROR(Check("resize_object"));
    v1::Placement* placement = FindPlacement(size.object_id());
    if (placement == nullptr || FindPin(size.object_id()) >= 0) return absl::OkStatus();
    placement->set_x_m(placement->x_m() - grown_m / 2 * std::sin(placement->theta_rad()));
    placement->set_y_m(placement->y_m() + grown_m / 2 * std::cos(placement->theta_rad()));
    return absl::OkStatus();
  }
  absl::Status Add(const v1::AddObject& added) {
    const v1::Object& object = added.object();
    if (FindObject(object.id()) != nullptr) {
      return Wrong(fmt::format(".add_object.object.id: \"{}\" is an object already; ids are new", object.id()));
    }
    // Objects are listed by role.
    auto& objects = *graph().mutable_object_list()->mutable_objects();
    *objects.Add() = object;
    for (int i = objects.size() - 1; i > 0 && objects[i - 1].role() > object.role(); --i)
      objects.SwapElements(i, i - 1);
    problem_.touched.insert(object.id());
    RETURN_IF_ERROR(Check("add_object"));
    for (int i = 0; i < added.edges_size(); ++i) {
      RETURN_IF_ERROR(AddEdge(added.edges(i), fmt::format("add_object.edges[{}]", i).c_str()));
    }
    return absl::OkStatus();
  }
  absl::Status Remove(const std::string& id) {
    if (FindObject(id) == nullptr) return Wrong(NoObject("remove_object_id", id));
    // What stood on it or hung at it has to find another place.
    for (const v1::Object& object : graph().object_list().objects()) {
      if (object.host_id() == id) problem_.touched.insert(object.id());
    }
    for (const v1::ConstraintEdge& edge : graph().edges()) TouchRidersOf(id, edge);
    const IdSet said = SentencesWithEdges();
    for (v1::Diagnostic& diagnostic : RemoveObjects({id}, graph()))
      problem_.diagnostics.push_back(std::move(diagnostic));
    // What was said of it is gone with it.
    const IdSet left = SentencesWithEdges();
    auto& sentences = *graph().mutable_constraint_list()->mutable_sentences();
    for (int i = sentences.size() - 1; i >= 0; --i) {
      if (said.contains(sentences[i].id()) && !left.contains(sentences[i].id())) sentences.DeleteSubrange(i, 1);
    }
    std::erase_if(problem_.placements, [&](const v1::Placement& p) { return p.object_id() == id; });
    problem_.touched.erase(id);
    return Check("remove_object_id");
  }
  IdSet SentencesWithEdges() {
    IdSet ids;
    for (const v1::ConstraintEdge& edge : graph().edges()) ids.insert(edge.sentence_id());
    return ids;
  }
  absl::Status AddEdge(const v1::ConstraintEdge& added, const char* field) {
    v1::ConstraintEdge edge = added;
    if (edge.weight() == 0) edge.set_weight(1);
    for (int k = graph().edges_size() + 1; edge.id().empty(); ++k) {
      if (FindEdge(fmt::format("e{}", k)) < 0) edge.set_id(fmt::format("e{}", k));
    }
    if (FindEdge(edge.id()) >= 0) return Wrong(fmt::format(".{}.id: \"{}\" is a constraint already", field, edge.id()));
    *graph().add_edges() = edge;
    const absl::StatusOr<Scene> scene = SceneFromProto(graph());
    if (!scene.ok()) return Wrong(fmt::format(".{}: {}", field, std::string(scene.status().message())));
    const std::vector<Vec2<double>> centers(scene->zones.size());
    const auto bound = Bind(edge, {*scene, centers});
    if (!bound.ok()) return Wrong(fmt::format(".{}: {}", field, std::string(bound.status().message())));
    Touch(edge);
    return absl::OkStatus();
  }
  absl::Status RemoveEdge(const std::string& id) {
    const int edge = FindEdge(id);
    if (edge < 0) return Wrong(NoEdge("remove_edge_id", id));
    // Nobody who asks for less asks for a piece that had no place.
    const IdSet before = problem_.touched;
    Touch(graph().edges(edge));
    std::erase_if(problem_.touched,
                  [&](const std::string& one) { return !before.contains(one) && FindPlacement(one) == nullptr; });
    graph().mutable_edges()->DeleteSubrange(edge, 1);
    return absl::OkStatus();
  }
  absl::Status Weigh(const v1::SetEdgeWeight& weight) {
    const int edge = FindEdge(weight.edge_id());
    if (edge < 0) return Wrong(NoEdge("set_edge_weight.edge_id", weight.edge_id()));
    if (!(weight.weight() > 0 && weight.weight() <= 100)) {
      return Wrong(fmt::format(".set_edge_weight.weight: {} is not in (0, 100]", weight.weight()));
    }
    graph().mutable_edges(edge)->set_weight(weight.weight());
    Touch(graph().edges(edge));
    return absl::OkStatus();
  }

  EditedProblem& problem_;
};

}  // namespace

absl::StatusOr<EditedProblem> ApplyEdits(const v1::SolvedLayout& layout, const EditList& edits) {
  EditedProblem problem;
  problem.graph = layout.graph();
  problem.placements.assign(layout.placements().begin(), layout.placements().end());
  Editor editor(problem);
  for (int i = 0; i < edits.size(); ++i) {
    if (absl::Status status = editor.Apply(edits[i]); !status.ok()) {
      return InvalidArgument("edits[{}]{}", i, status.message());
    }
  }
  return problem;
}

}  // namespace flair::optimizer
