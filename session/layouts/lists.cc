// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/lists.h"

#include <utility>

namespace flair::session {

const v1::Object* ObjectOf(const v1::SolvedLayout& layout, std::string_view id) {
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.id() == id) return &object;
  }
  return nullptr;
}

const v1::Placement* PlaceOf(const v1::SolvedLayout& layout, std::string_view id) {
  const auto at = std::ranges::find(layout.placements(), id, &v1::Placement::object_id);
  return at == layout.placements().end() ? nullptr : &*at;
}

std::vector<std::string> TextsOf(const v1::ConstraintEdge& edge) {
  std::vector<std::string> texts;
  for (const v1::Argument& argument : edge.arguments()) {
    if (!argument.value().text().empty()) texts.push_back(argument.value().text());
    const auto& items = argument.value().texts().items();
    texts.insert(texts.end(), items.begin(), items.end());
  }
  return texts;
}

IdSet ObjectsOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph) {
  const std::vector<std::string> texts = TextsOf(edge);
  IdSet named;
  for (const v1::Object& object : graph.object_list().objects()) {
    if (std::ranges::find(texts, object.id()) != texts.end()) named.insert(object.id());
  }
  return named;
}

IdSet ObjectsOf(const IdSet& sentence_ids, const v1::LayoutGraph& graph) {
  IdSet ids;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (sentence_ids.contains(edge.sentence_id())) ids.merge(ObjectsOf(edge, graph));
  }
  return ids;
}

IdSet UsesOf(const v1::LayoutGraph& graph) {
  IdSet uses;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence.use()) uses.insert(sentence.id());
  }
  return uses;
}

v1::Diagnostic Remark(v1::Severity severity, const char* code, const std::string& subject_id, std::string message) {
  v1::Diagnostic remark;
  remark.set_severity(severity);
  remark.set_code(code);
  remark.set_subject_id(subject_id);
  remark.set_message(std::move(message));
  return remark;
}

}  // namespace flair::session
