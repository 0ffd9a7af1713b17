// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/translate.h"

#include <string>
#include <utility>

#include "translator_worker/catalog/catalog_index.h"
#include "translator_worker/grammar/scene_names.h"
#include "translator_worker/grammar/sentence_translator.h"

namespace flair::translator {

v1::LayoutGraph Translate(const v1::TranslateRequest& request) {
  v1::LayoutGraph graph;
  *graph.mutable_room() = request.room();
  *graph.mutable_zone_plan() = request.zone_plan();
  *graph.mutable_object_list() = request.object_list();
  if (request.has_style_sheet()) *graph.mutable_style_sheet() = request.style_sheet();
  *graph.mutable_constraint_list() = request.constraint_list();
  graph.set_catalog_library(request.catalog().library());
  const SceneNames all_names(request.room(), request.zone_plan(), request.object_list());
  const SceneNames floor_names(request.room(), request.zone_plan(), request.object_list(), NamedObjects::kFloorFirst);
  const CatalogIndex catalog(request.catalog());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    const SceneNames& names = sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY ? all_names : floor_names;
    Translation translation = TranslateSentence(request, names, catalog, sentence);
    for (Call& call : translation.calls) {
      v1::ConstraintEdge& edge = *graph.add_edges();
      edge.set_id("e" + std::to_string(graph.edges_size()));
      edge.set_type(call.type);
      for (v1::Argument& argument : call.arguments) *edge.add_arguments() = std::move(argument);
      edge.set_weight((sentence.weight() > 0 ? sentence.weight() : 1) * translation.weight_factor);
      edge.set_sentence_id(sentence.id());
    }
    for (v1::Diagnostic& diagnostic : translation.diagnostics) *graph.add_diagnostics() = std::move(diagnostic);
  }
  return graph;
}

}  // namespace flair::translator
