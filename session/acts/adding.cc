// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that are new, and what is left behind by those that go.
#include <algorithm>
#include <map>

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

// A piece of that name that the room has no place for; null when there is none.
const v1::Object* LeftOut(const v1::SolvedLayout& layout, const std::string& name) {
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.name() == name && PlaceOf(layout, object.id()) == nullptr) return &object;
  }
  return nullptr;
}

// An added piece comes in the place of one of its name that was left out, and inherits what the user said of that.
EditList InPlaceOfLeftOut(const v1::SolvedLayout& layout, const EditList& edits) {
  IdSet of_user, gone;
  for (const v1::Sentence& sentence : layout.graph().constraint_list().sentences()) {
    if (sentence.origin() == v1::SENTENCE_ORIGIN_BRIEF) of_user.insert(sentence.id());
  }
  EditList all;
  for (const v1::LayoutEdit& edit : edits) {
    const v1::Object* const left_out =
        edit.has_add_object() ? LeftOut(layout, edit.add_object().object().name()) : nullptr;
    if (left_out == nullptr || !gone.insert(left_out->id()).second) {
      *all.Add() = edit;
      continue;
    }
    all.Add()->set_remove_object_id(left_out->id());
    v1::LayoutEdit& added = *all.Add();
    added = edit;
    for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
      if (!of_user.contains(edge.sentence_id()) || !ObjectsOf(edge, layout.graph()).contains(left_out->id())) continue;
      v1::ConstraintEdge& inherited = *added.mutable_add_object()->add_edges();
      inherited = edge;
      inherited.clear_id();
      for (v1::Argument& argument : *inherited.mutable_arguments()) {
        if (argument.value().text() == left_out->id()) {
          argument.mutable_value()->set_text(edit.add_object().object().id());
        }
      }
    }
  }
  return all;
}

// The layout with what is added, without places.
v1::SolvedLayout With(v1::SolvedLayout layout, const EditList& edits) {
  auto& objects = *layout.mutable_graph()->mutable_object_list()->mutable_objects();
  for (const v1::LayoutEdit& edit : edits) {
    if (!edit.remove_object_id().empty()) {
      EraseIf(objects, [&](const v1::Object& object) { return object.id() == edit.remove_object_id(); });
    } else if (edit.has_add_object()) {
      *objects.Add() = edit.add_object().object();
    }
  }
  return layout;
}

}  // namespace

absl::StatusOr<v1::LayoutGraph> LayoutActs::SaidOf(const IdSet& added, const v1::SolvedLayout& before,
                                                   const v1::SolvedLayout& with, CallContext& call) const {
  v1::LayoutGraph said;
  if (sentences_of_ == nullptr) return said;
  const v1::LayoutGraph& graph = with.graph();
  IdSet known = IdsOf(with.placements());
  known.insert(added.begin(), added.end());
  v1::TranslateRequest request;
  *request.mutable_room() = graph.room();
  *request.mutable_zone_plan() = graph.zone_plan();
  for (const v1::Object& object : graph.object_list().objects()) {
    if (!known.contains(object.id())) continue;
    v1::Object& one = *request.mutable_object_list()->add_objects();
    one = object;
    if (!known.contains(one.host_id())) one.clear_host_id();
  }
  // What has gone from `with` may still be in the looks of the room.
  *request.mutable_style_sheet() = LooksOf(request.object_list(), before);
  // Objects are listed by role.
  std::ranges::stable_sort(*request.mutable_object_list()->mutable_objects(), {}, &v1::Object::role);
  ASSIGN_OR_RETURN(const v1::ConstraintList list,
                   sentences_of_(graph.room(), graph.zone_plan(), request.object_list()));
  FreeIds ids(graph.constraint_list().sentences(), "new_");
  // "The chairs surround the table" is said of more chairs than before.
  std::map<std::string, std::string> known_by_text, said_before;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    known_by_text.emplace(sentence.text(), sentence.id());
  }
  for (const v1::Sentence& sentence : list.sentences()) {
    const bool of_added =
        std::ranges::any_of(sentence.subject_ids(), [&](const std::string& id) { return added.contains(id); });
    if (!of_added) continue;
    v1::Sentence& one = *request.mutable_constraint_list()->add_sentences();
    one = sentence;
    one.set_id(ids.Next());
    one.clear_made_from_ids();
    const auto before = known_by_text.find(one.text());
    if (before != known_by_text.end()) said_before.emplace(one.id(), before->second);
  }
  if (request.constraint_list().sentences().empty()) return said;
  ASSIGN_OR_RETURN(*request.mutable_catalog(), stages_.Catalog(call));
  ASSIGN_OR_RETURN(const v1::TranslateResponse translated, stages_.Translate(request, call));
  IdSet used;
  for (const v1::ConstraintEdge& edge : translated.layout_graph().edges()) {
    const IdSet named = ObjectsOf(edge, graph);
    if (std::ranges::none_of(named, [&](const std::string& id) { return added.contains(id); })) continue;
    v1::ConstraintEdge& about = *said.add_edges();
    about = edge;
    const auto before = said_before.find(edge.sentence_id());
    if (before != said_before.end()) {
      about.set_sentence_id(before->second);
    } else {
      used.insert(edge.sentence_id());
    }
  }
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    if (used.contains(sentence.id())) *said.mutable_constraint_list()->add_sentences() = sentence;
  }
  return said;
}

absl::StatusOr<v1::LayoutGraph> LayoutActs::LetDesignerSpeak(const IdSet& added, const v1::SolvedLayout& with,
                                                             v1::SolvedLayout& shown, EditList& edits, Aim& aim,
                                                             CallContext& call) const {
  ASSIGN_OR_RETURN(v1::LayoutGraph said, SaidOf(added, shown, with, call));
  LendSentences(said, *shown.mutable_graph());
  for (const v1::ConstraintEdge& edge : said.edges()) aim.sentence_ids.insert(edge.sentence_id());
  for (const v1::ConstraintEdge& old : shown.graph().edges()) {
    const IdSet named = ObjectsOf(old, with.graph());
    const bool is_grown = named.size() > 1 && std::ranges::any_of(said.edges(), [&](const v1::ConstraintEdge& edge) {
                            return edge.sentence_id() == old.sentence_id() && edge.type() == old.type() &&
                                   std::ranges::includes(ObjectsOf(edge, with.graph()), named);
                          });
    if (is_grown) edits.Add()->set_remove_edge_id(old.id());
  }
  FreeIds ids(shown.graph().edges(), "n");
  for (const v1::ConstraintEdge& edge : said.edges()) {
    v1::ConstraintEdge& one = *edits.Add()->mutable_add_edge();
    one = edge;
    one.set_id(ids.Next());
  }
  return said;
}

absl::StatusOr<Acted> LayoutActs::Add(const Standing& standing, const v1::EditLayout& edit, CallContext& call) const {
  const EditList asked = Completed(standing.shown, edit.edits());
  EditList edits = InPlaceOfLeftOut(standing.shown, asked);
  PutCopiesBeside(standing.shown, edits);
  IdSet added;
  for (const v1::LayoutEdit& one : edits) {
    if (one.has_add_object()) added.insert(one.add_object().object().id());
  }
  v1::SolvedLayout shown = standing.shown;
  // Without a designer at hand a piece comes as it is.
  // Who adds a piece has not asked to move the others.
  Aim aim{{}, added, false};
  const absl::StatusOr<v1::LayoutGraph> said =
      LetDesignerSpeak(added, With(standing.shown, edits), shown, edits, aim, call);
  const Standing now{shown, standing.settled, standing.pending, standing.by_hand};
  ASSIGN_OR_RETURN(Acted acted, edit.without_solving() ? Unsolved(now, edits, call) : Tried(now, edits, aim, call));
  if (said.ok()) ReturnSubjects(*said, *acted.layout.mutable_graph());
  acted.label = EditLabel(standing.shown, asked);
  return acted;
}

std::vector<v1::Diagnostic> LeftBehind(const v1::SolvedLayout& before, const EditList& edits) {
  IdSet gone;
  for (const v1::LayoutEdit& edit : edits) {
    if (!edit.remove_object_id().empty()) gone.insert(edit.remove_object_id());
  }
  if (gone.empty()) return {};
  const v1::LayoutGraph& graph = before.graph();
  const IdSet uses = UsesOf(graph);
  std::map<std::string, const v1::Object*> objects;
  for (const v1::Object& object : graph.object_list().objects()) objects[object.id()] = &object;
  const auto area = [&](const std::string& id) { return objects[id]->width_m() * objects[id]->depth_m(); };
  // By a smaller piece, the larger ones that it is used with.
  std::map<std::string, IdSet> used_with;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (!uses.contains(edge.sentence_id())) continue;
    const IdSet named = ObjectsOf(edge, graph);
    for (const std::string& one : named) {
      for (const std::string& other : named) {
        if (area(one) < area(other)) used_with[one].insert(other);
      }
    }
  }
  std::vector<v1::Diagnostic> told;
  for (const auto& [id, partners] : used_with) {
    const v1::Object& object = *objects[id];
    const bool stands = object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over() && !gone.contains(id) &&
                        LeftOut(before, object.name()) != &object;
    if (!stands || !std::ranges::includes(gone, partners)) continue;
    told.push_back(Remark(v1::SEVERITY_NOTE, "left_behind", id,
                          fmt::format("the {} was used at the {}, which is gone, and has no other use here",
                                      object.name(), NameOf(before, *partners.begin()))));
  }
  return told;
}

}  // namespace flair::session
