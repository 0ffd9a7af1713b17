// SPDX-License-Identifier: GPL-3.0-or-later
// A piece in the place of another one.
#include <algorithm>
#include <optional>
#include <utility>

#include "fmt/format.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/edits.h"
#include "session/layouts/placing.h"
#include "session/sentences/names.h"
#include "session/sentences/sentences.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// Whether it is the same piece under another name, or one of its kind in another size.
bool IsOfClass(const v1::Object& object, const v1::Object& by) {
  const bool alike = object.category() == by.category() && object.sat_at() == by.sat_at() && object.seat() == by.seat();
  const bool renamed = object.width_m() == by.width_m() && object.depth_m() == by.depth_m() &&
                       object.height_m() == by.height_m() && object.round() == by.round();
  return alike && (renamed || object.name() == by.name());
}

// The piece with what makes it another one; sizes are an edit, which keeps the back where it was.
void Become(const v1::Object& by, const std::string& id, v1::SolvedLayout& layout) {
  for (v1::Object& object : *layout.mutable_graph()->mutable_object_list()->mutable_objects()) {
    if (object.id() != id) continue;
    object.set_name(by.name());
    object.set_category(by.category());
    object.set_description(by.description());
    object.set_round(by.round());
    object.set_sat_at(by.sat_at());
    object.set_seat(by.seat());
    object.set_requested(true);
    const auto at = std::ranges::find(*layout.mutable_placements(), id, &v1::Placement::object_id);
    if (at != layout.mutable_placements()->end()) FaceIntoRoom(layout.graph().room(), object, true, *at);
  }
}

// The edge without a piece that it lists among others; nothing when it needs that one.
std::optional<v1::ConstraintEdge> WithoutListed(v1::ConstraintEdge edge, const std::string& id) {
  constexpr int kLeast = 2;
  bool fewer = false;
  for (v1::Argument& argument : *edge.mutable_arguments()) {
    if (argument.value().text() == id) return std::nullopt;
    if (!argument.value().has_texts()) continue;
    auto& items = *argument.mutable_value()->mutable_texts()->mutable_items();
    const int had = items.size();
    EraseIf(items, [&](const std::string& item) { return item == id; });
    if (items.size() < had && items.size() < kLeast) return std::nullopt;
    fewer = fewer || items.size() < had;
  }
  return fewer ? std::optional(std::move(edge)) : std::nullopt;
}

// What was said of the piece goes, but for what the user said of it and had: the edges, and from the graph the
// sentences that ask for nothing else.
void ForgetWhatWasSaidOf(const std::string& id, const IdSet& unmet, v1::LayoutGraph& graph, EditList& edits) {
  // Edges that come from no sentence are somebody's own.
  IdSet of_user = {""}, gone, left;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    const bool in_vain = unmet.contains(sentence.id()) && ObjectsOf({sentence.id()}, graph).contains(id);
    if (sentence.origin() == v1::SENTENCE_ORIGIN_BRIEF && !in_vain) of_user.insert(sentence.id());
  }
  FreeIds ids(graph.edges(), "r");
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const bool goes = !of_user.contains(edge.sentence_id()) && ObjectsOf(edge, graph).contains(id);
    std::optional<v1::ConstraintEdge> of_others;
    if (goes) {
      of_others = WithoutListed(edge, id);
      edits.Add()->set_remove_edge_id(edge.id());
    }
    if (of_others) {
      of_others->set_id(ids.Next());
      *edits.Add()->mutable_add_edge() = *of_others;
    }
    (goes && !of_others ? gone : left).insert(edge.sentence_id());
  }
  if (!graph.has_constraint_list()) return;
  EraseIf(*graph.mutable_constraint_list()->mutable_sentences(),
          [&](const v1::Sentence& sentence) { return gone.contains(sentence.id()) && !left.contains(sentence.id()); });
}

// What is still said of the piece calls it by its new name.
void CallIt(const std::string& id, const std::string& was, const std::string& is, v1::LayoutGraph& graph) {
  for (int i = 0; i < graph.constraint_list().sentences_size(); ++i) {
    const v1::Sentence& sentence = graph.constraint_list().sentences(i);
    if (!ObjectsOf({sentence.id()}, graph).contains(id)) continue;
    std::string text = sentence.text();
    for (size_t at = FindWord(text, was); at != std::string::npos; at = FindWord(text, was, at + is.size())) {
      text.replace(at, was.size(), is);
    }
    graph.mutable_constraint_list()->mutable_sentences(i)->set_text(text);
  }
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::Replace(const Standing& standing, const v1::ReplaceObject& replace,
                                          CallContext& call) const {
  const std::string& id = replace.object_id();
  const auto& objects = standing.shown.graph().object_list().objects();
  const auto object = std::ranges::find(objects, id, &v1::Object::id);
  if (object == objects.end()) {
    return InvalidArgument("replace.object_id: \"{}\" is not an object of the room", id.substr(0, 80));
  }
  v1::SolvedLayout shown = standing.shown, settled = standing.settled == nullptr ? shown : *standing.settled;
  for (v1::SolvedLayout* layout : {&shown, &settled}) Become(replace.by(), id, *layout);
  EditList edits;
  v1::ResizeObject& resize = *edits.Add()->mutable_resize_object();
  resize.set_object_id(id);
  resize.set_width_m(replace.by().width_m());
  resize.set_depth_m(replace.by().depth_m());
  resize.set_height_m(replace.by().height_m());
  Aim aim{{}, {id}, false};
  // Without a designer at hand a piece comes as it is.
  absl::StatusOr<v1::LayoutGraph> said = absl::UnavailableError("");
  const bool other_class = !IsOfClass(*object, replace.by());
  if (other_class) {
    for (v1::SolvedLayout* layout : {&shown, &settled}) {
      CallIt(id, object->name(), replace.by().name(), *layout->mutable_graph());
    }
    v1::SolvedLayout with = shown;
    ForgetWhatWasSaidOf(id, UnmetSentences(shown), *with.mutable_graph(), edits);
    for (v1::Object& one : *with.mutable_graph()->mutable_object_list()->mutable_objects()) {
      if (one.id() != id) continue;
      one.set_width_m(replace.by().width_m());
      one.set_depth_m(replace.by().depth_m());
      one.set_height_m(replace.by().height_m());
    }
    said = LetDesignerSpeak({id}, with, shown, edits, aim, call);
  }
  const Standing now{shown, standing.settled == nullptr ? nullptr : &settled, standing.pending, standing.by_hand};
  ASSIGN_OR_RETURN(Acted acted, replace.without_solving() ? Unsolved(now, edits, call)
                                : other_class             ? Tried(now, edits, aim, call)
                                                          : Solved(now, edits, call));
  if (said.ok()) ReturnSubjects(*said, *acted.layout.mutable_graph());
  acted.label = fmt::format("replace the {} by {}", object->name(), WithArticle(replace.by().name()));
  return acted;
}

}  // namespace flair::session
