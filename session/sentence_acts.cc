// SPDX-License-Identifier: GPL-3.0-or-later
// Acts on what sentences ask: one more, another weight, none.
#include <algorithm>
#include <set>

#include "absl/strings/ascii.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "session/act_words.h"
#include "session/layout_acts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// An id that no sentence or edge has yet.
template <typename Items>
std::string FreeId(const Items& items, const std::string& letter) {
  std::set<std::string> taken;
  for (const auto& item : items) taken.insert(item.id());
  for (int n = items.size() + 1;; ++n) {
    if (std::string id = letter + std::to_string(n); !taken.contains(id)) return id;
  }
}

// What a call is about: the first object that it names.
std::string SubjectOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph) {
  std::set<std::string> ids;
  for (const v1::Object& object : graph.object_list().objects()) ids.insert(object.id());
  for (const v1::Argument& argument : edge.arguments()) {
    if (ids.contains(argument.value().text())) return argument.value().text();
    for (const std::string& text : argument.value().texts().items()) {
      if (ids.contains(text)) return text;
    }
  }
  return "";
}

// Why a sentence does not hold; empty when it does.
std::string Unmet(const v1::SolvedLayout& layout, const std::string& sentence_id) {
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    const v1::EdgeOutcome& outcome = layout.edge_outcomes(i);
    if (layout.graph().edges(i).sentence_id() != sentence_id) continue;
    if (outcome.status() == v1::OUTCOME_STATUS_SATISFIED) continue;
    return outcome.reason().empty() ? "other wishes stand against it" : outcome.reason();
  }
  return "";
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::Say(const Standing& standing, const v1::SaySentence& say, CallContext& call) const {
  const std::string text(absl::StripAsciiWhitespace(say.text()));
  if (text.empty() || text.size() > 400) {
    return InvalidArgument("say.text: {} characters; one sentence of 1 to 400", text.size());
  }
  const v1::LayoutGraph& graph = standing.shown.graph();
  v1::TranslateRequest request;
  request.set_request_id("flair-session");
  *request.mutable_room() = graph.room();
  *request.mutable_zone_plan() = graph.zone_plan();
  *request.mutable_object_list() = graph.object_list();
  *request.mutable_style_sheet() = graph.style_sheet();
  ASSIGN_OR_RETURN(*request.mutable_catalog(), stages_.Catalog(call));
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id(FreeId(graph.constraint_list().sentences(), "said_"));
  sentence.set_text(text);
  sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
  sentence.set_weight(1);
  sentence.set_reason(fmt::format("you said \"{}\"", text));
  sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(const v1::TranslateResponse translated, stages_.Translate(request, call));
  const v1::LayoutGraph& understood = translated.layout_graph();
  if (understood.edges().empty()) {
    return InvalidArgument("say.text: \"{}\" is not understood{}", text,
                           understood.diagnostics().empty() ? "" : ": " + understood.diagnostics(0).message());
  }
  v1::SolvedLayout shown = standing.shown, settled = standing.settled == nullptr ? shown : *standing.settled;
  EditList edits;
  for (v1::SolvedLayout* layout : {&shown, &settled}) {
    *layout->mutable_graph()->mutable_constraint_list()->add_sentences() = sentence;
  }
  std::string id = FreeId(graph.edges(), "e");
  for (const v1::ConstraintEdge& edge : understood.edges()) {
    v1::ConstraintEdge& added = *edits.Add()->mutable_add_edge();
    added = edge;
    added.set_id(id);
    id = "e" + std::to_string(std::stoi(id.substr(1)) + 1);
  }
  // Who says something of a piece that was moved by hand wants it to move.
  const std::string subject = SubjectOf(understood.edges(0), graph);
  EditList pending;
  for (const v1::LayoutEdit& edit : standing.pending) {
    if (!edit.has_move_object() || edit.move_object().object_id() != subject) *pending.Add() = edit;
  }
  const v1::SolvedLayout* const from = standing.settled == nullptr ? nullptr : &settled;
  ASSIGN_OR_RETURN(Acted acted, Solved({shown, from, pending}, edits, call));
  if (from != nullptr && !Unmet(acted.layout, sentence.id()).empty()) {
    // From where it stands it does not get there: it is placed anew.
    for (int i = settled.placements_size() - 1; i >= 0; --i) {
      if (settled.placements(i).object_id() == subject) settled.mutable_placements()->DeleteSubrange(i, 1);
    }
    absl::StatusOr<Acted> anew = Solved({shown, from, pending}, edits, call);
    if (anew.ok() && Unmet(anew->layout, sentence.id()).empty()) acted = *std::move(anew);
  }
  acted.label = fmt::format("say \"{}\"", text);
  acted.diagnostics.insert(acted.diagnostics.end(), understood.diagnostics().begin(), understood.diagnostics().end());
  if (const std::string why = Unmet(acted.layout, sentence.id()); !why.empty()) {
    v1::Diagnostic& unmet = acted.diagnostics.emplace_back();
    unmet.set_severity(v1::SEVERITY_WARNING);
    unmet.set_code("said_in_vain");
    unmet.set_message(fmt::format("\"{}\" is noted but does not hold: {}", text, why));
    unmet.set_subject_id(subject);
  }
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Weigh(const Standing& standing, const v1::WeighSentence& weigh,
                                        CallContext& call) const {
  if (!(weigh.weight() >= 0 && weigh.weight() <= 100)) {
    return InvalidArgument("weigh.weight: {}; must be in [0, 100], 0 drops the sentence", weigh.weight());
  }
  EditList edits;
  for (const v1::ConstraintEdge& edge : standing.shown.graph().edges()) {
    if (edge.sentence_id() != weigh.sentence_id()) continue;
    if (weigh.weight() == 0) {
      edits.Add()->set_remove_edge_id(edge.id());
    } else {
      v1::SetEdgeWeight& set = *edits.Add()->mutable_set_edge_weight();
      set.set_edge_id(edge.id());
      set.set_weight(weigh.weight());
    }
  }
  if (edits.empty()) {
    return InvalidArgument("weigh.sentence_id: no constraint comes from a sentence \"{}\"",
                           weigh.sentence_id().substr(0, 80));
  }
  ASSIGN_OR_RETURN(Acted acted, Solved(standing, edits, call));
  acted.label = WeighLabel(standing.shown, weigh);
  return acted;
}

}  // namespace flair::session
