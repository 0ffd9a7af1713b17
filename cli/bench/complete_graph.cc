// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/complete_graph.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "absl/strings/str_replace.h"
#include "flair/v1/translator_service.pb.h"
#include "language_worker/handbook/completion/complete_constraints.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/parts/furniture_index.h"
#include "optimizer_worker/constraints/registry.h"
#include "translator_worker/grammar/translate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

// What an edge says, as a sentence of its own.
v1::Sentence SentenceOf(const v1::ConstraintEdge& edge, const std::map<std::string, v1::ObjectRole>& roles) {
  v1::Sentence sentence;
  sentence.set_id(edge.id());
  sentence.set_text(absl::StrReplaceAll(edge.type(), {{"_", " "}}));
  sentence.set_weight(edge.weight());
  const auto add = [&](const std::string& text) {
    if (roles.contains(text)) sentence.add_subject_ids(text);
  };
  for (const v1::Argument& argument : edge.arguments()) {
    if (argument.value().has_text()) add(argument.value().text());
    for (const std::string& item : argument.value().texts().items()) add(item);
  }
  const bool alone = sentence.subject_ids_size() < 2;
  sentence.set_scope(alone ? v1::SENTENCE_SCOPE_INTRA : v1::SENTENCE_SCOPE_INTER);
  if (sentence.subject_ids_size() > 0 && roles.at(sentence.subject_ids(0)) == v1::OBJECT_ROLE_TERTIARY) {
    sentence.set_scope(v1::SENTENCE_SCOPE_TERTIARY);
  }
  return sentence;
}

// The objects as completion sees them: recorded problems have no heights, so a wardrobe is as tall as wardrobes are.
v1::ObjectList WithUsualHeights(const v1::ObjectList& objects, const language::Handbook& handbook) {
  const language::FurnitureIndex index(handbook);
  v1::ObjectList tall = objects;
  for (v1::Object& object : *tall.mutable_objects()) {
    const language::hb::Furniture* furniture = index.Find(object.name());
    if (furniture != nullptr && object.kind() == v1::OBJECT_KIND_FLOOR) {
      object.set_height_m(furniture->height_m().typical());
    }
  }
  return tall;
}

}  // namespace

absl::Status CompleteGraph(v1::LayoutGraph& graph) {
  ASSIGN_OR_RETURN(const std::unique_ptr<const language::Handbook> handbook,
                   language::LoadHandbook(language::DefaultHandbookFolder()));
  v1::Brief brief;
  brief.set_text(graph.room().title().empty() ? graph.room().room_type() : graph.room().title());
  std::map<std::string, v1::ObjectRole> roles;
  for (const v1::Object& object : graph.object_list().objects()) roles[object.id()] = object.role();
  v1::ConstraintList said;
  for (const v1::ConstraintEdge& edge : graph.edges()) *said.add_sentences() = SentenceOf(edge, roles);
  const v1::ConstraintList completed = language::CompleteConstraints(
      {brief, graph.room(), graph.zone_plan()}, WithUsualHeights(graph.object_list(), *handbook), said, *handbook);

  v1::TranslateRequest request;
  std::set<std::string> kept;
  for (const v1::Sentence& sentence : completed.sentences()) {
    if (sentence.origin() == v1::SENTENCE_ORIGIN_IMPLIED) {
      *request.mutable_constraint_list()->add_sentences() = sentence;
    } else {
      kept.insert(sentence.id());
    }
  }
  auto& edges = *graph.mutable_edges();
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](const v1::ConstraintEdge& edge) { return !kept.contains(edge.id()); }),
              edges.end());
  *request.mutable_room() = graph.room();
  *request.mutable_zone_plan() = graph.zone_plan();
  *request.mutable_object_list() = graph.object_list();
  *request.mutable_style_sheet() = graph.style_sheet();
  *request.mutable_catalog() = optimizer::MakeCatalog();
  v1::LayoutGraph implied = translator::Translate(request);
  for (v1::ConstraintEdge& edge : *implied.mutable_edges()) {
    edge.set_id("implied_" + edge.id());
    *edges.Add() = std::move(edge);
  }
  graph.mutable_constraint_list()->MergeFrom(request.constraint_list());
  graph.mutable_diagnostics()->MergeFrom(implied.diagnostics());
  return absl::OkStatus();
}

}  // namespace flair::cli
