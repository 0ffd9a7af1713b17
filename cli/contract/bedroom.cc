// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/bedroom.h"

#include <cstdlib>

#include "optimizer_worker/constraints/registry.h"
#include "room/conversion/conversion.h"
#include "room/text_format/scene_text.h"

namespace flair::contract {
namespace {

void AddSentence(v1::LayoutGraph& graph, const std::string& id, const std::string& text, v1::SentenceScope scope,
                 const std::vector<std::string>& subjects) {
  v1::Sentence& sentence = *graph.mutable_constraint_list()->add_sentences();
  sentence.set_id(id);
  sentence.set_text(text);
  sentence.set_scope(scope);
  sentence.set_weight(1);
  for (const std::string& subject : subjects) sentence.add_subject_ids(subject);
}

}  // namespace

v1::Brief BedroomBrief() {
  v1::Brief brief;
  brief.set_text("A bedroom that is 4m x 5m.");
  brief.set_seed(3);
  return brief;
}

v1::JobSpec BedroomJob() {
  v1::JobSpec spec;
  *spec.mutable_brief() = BedroomBrief();
  spec.mutable_solve_options()->set_max_restart_count(2);
  spec.mutable_render_options()->set_size_px(256);
  return spec;
}

v1::LayoutGraph GraphFromText(std::string_view scene) {
  const absl::StatusOr<SceneText> text = ParseScene(scene);
  if (!text.ok()) std::abort();  // the texts are this library's own
  v1::LayoutGraph graph = GraphFromScene(text->scene);
  graph.mutable_room()->set_room_type("bedroom");
  return graph;
}

v1::LayoutGraph BedroomGraph() {
  v1::LayoutGraph graph = GraphFromText(
      "4x5 room; door south 0.5 0.9; zone sleeping; bed 1.6x2 at 2,1,0 primary zone sleeping height 0.5; "
      "nightstand 0.5x0.4 at 3.5,1,0 zone sleeping height 0.5");
  for (v1::Object& object : *graph.mutable_object_list()->mutable_objects()) object.set_category(object.id());
  AddSentence(graph, "s1", "The bed's headboard is against a wall.", v1::SENTENCE_SCOPE_INTRA, {"bed"});
  AddSentence(graph, "s2", "The nightstand is next to the bed.", v1::SENTENCE_SCOPE_INTER, {"nightstand", "bed"});
  return graph;
}

v1::SolveRequest BedroomSolve() {
  v1::SolveRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  request.mutable_options()->set_seed(5);
  return request;
}

v1::SolveRestartsRequest BedroomRestarts(int first, int count) {
  v1::SolveRestartsRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  request.mutable_options()->set_seed(5);
  request.set_stage("primary");
  request.set_first_restart(first);
  request.set_restart_count(count);
  return request;
}

v1::EvaluateRequest BedroomEvaluate() {
  v1::EvaluateRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  v1::Placement& bed = *request.add_placements();
  bed.set_object_id("bed");
  bed.set_x_m(2);
  bed.set_y_m(0.5);
  return request;
}

v1::TranslateRequest BedroomTranslate() {
  const v1::LayoutGraph graph = BedroomGraph();
  v1::TranslateRequest request;
  *request.mutable_room() = graph.room();
  *request.mutable_zone_plan() = graph.zone_plan();
  *request.mutable_object_list() = graph.object_list();
  *request.mutable_constraint_list() = graph.constraint_list();
  *request.mutable_catalog() = optimizer::MakeCatalog();
  return request;
}

v1::SolvedLayout BedroomLayout() {
  v1::SolvedLayout layout;
  *layout.mutable_graph() = BedroomGraph();
  v1::Placement& bed = *layout.add_placements();
  bed.set_object_id("bed");
  bed.set_x_m(2);
  bed.set_y_m(1);
  return layout;
}

v1::ConstraintEdge EdgeOn(const std::string& type, const std::string& parameter, const std::string& object_id) {
  v1::ConstraintEdge edge;
  edge.set_id("e1");
  edge.set_type(type);
  edge.set_weight(1);
  v1::Argument& argument = *edge.add_arguments();
  argument.set_name(parameter);
  argument.mutable_value()->set_text(object_id);
  return edge;
}

}  // namespace flair::contract
