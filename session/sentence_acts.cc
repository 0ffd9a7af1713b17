// SPDX-License-Identifier: GPL-3.0-or-later
// Acts on what sentences ask: one more, another weight, none.
#include <algorithm>
#include <set>

#include "absl/strings/ascii.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "session/act_words.h"
#include "session/layout_acts.h"
#include "session/naming.h"
#include "session/trying.h"
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

// What nobody asked for gives way to what the user says: twice the heaviest of a designer's sentences.
double WeightOfSaid(const v1::ConstraintList& list) {
  constexpr double kLeast = 4, kMost = 10;
  double heaviest = 0;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.origin() != v1::SENTENCE_ORIGIN_BRIEF) heaviest = std::max(heaviest, sentence.weight());
  }
  return std::clamp(2 * heaviest, kLeast, kMost);
}

v1::Diagnostic Remark(v1::Severity severity, const char* code, const std::string& subject, std::string message) {
  v1::Diagnostic remark;
  remark.set_severity(severity);
  remark.set_code(code);
  remark.set_subject_id(subject);
  remark.set_message(std::move(message));
  return remark;
}

// What does not hold of all that is said of these or of what is in their reach, but for `sentence_id`.
IdSet WaitingFor(const v1::SolvedLayout& layout, const IdSet& ids, const std::string& sentence_id) {
  const IdSet reach = InReach(layout, ids);
  IdSet waiting;
  for (const std::string& one : UnmetSentences(layout)) {
    const IdSet named = ObjectsOf({one}, layout.graph());
    const bool near = std::ranges::any_of(named, [&](const std::string& id) { return reach.contains(id); });
    if (near && one != sentence_id) waiting.insert(one);
  }
  return waiting;
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
  const IdSet selected(say.selected_object_ids().begin(), say.selected_object_ids().end());
  *request.mutable_object_list() = MeantBy(text, standing.shown, selected);
  *request.mutable_style_sheet() = LooksOf(request.object_list(), standing.shown);
  ASSIGN_OR_RETURN(*request.mutable_catalog(), stages_.Catalog(call));
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id(FreeId(graph.constraint_list().sentences(), "said_"));
  sentence.set_text(text);
  sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
  sentence.set_weight(WeightOfSaid(graph.constraint_list()));
  sentence.set_reason(fmt::format("you said \"{}\"", text));
  sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(const v1::TranslateResponse translated, stages_.Translate(request, call));
  const v1::LayoutGraph& understood = translated.layout_graph();
  if (understood.edges().empty()) {
    std::string why = understood.diagnostics().empty() ? "" : understood.diagnostics(0).message();
    // The sentence is quoted once already.
    if (const std::string quoted = fmt::format("\"{}\": ", text); why.starts_with(quoted)) why.erase(0, quoted.size());
    return InvalidArgument("say.text: \"{}\" is not understood{}{}", text, why.empty() ? "" : ": ",
                           WithNames(why, standing.shown));
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
  const std::string subject = SubjectOf(understood.edges(0), graph);
  Aim aim{{sentence.id()}, {}};
  for (const v1::ConstraintEdge& edge : understood.edges()) aim.object_ids.insert(SubjectOf(edge, graph));
  ASSIGN_OR_RETURN(Acted acted, Tried({shown, standing.settled == nullptr ? nullptr : &settled, standing.pending},
                                      edits, aim, call));
  acted.label = fmt::format("say \"{}\"", text);
  for (const v1::Diagnostic& one : understood.diagnostics()) {
    acted.diagnostics.push_back(one);
    acted.diagnostics.back().set_message(WithNames(one.message(), standing.shown));
  }
  if (const std::string unmet = WhyUnmet(acted.layout, aim.sentence_ids); !unmet.empty()) {
    ASSIGN_OR_RETURN(const std::string why, WhyNot(acted.layout, aim, call));
    acted.diagnostics.push_back(Remark(v1::SEVERITY_WARNING, "said_in_vain", subject,
                                       fmt::format("\"{}\" is noted but does not hold: {}; {}", text, unmet, why)));
  }
  return acted;
}

absl::StatusOr<Acted> LayoutActs::Weigh(const Standing& standing, const v1::WeighSentence& weigh,
                                        CallContext& call) const {
  if (!(weigh.weight() >= 0 && weigh.weight() <= 100)) {
    return InvalidArgument("weigh.weight: {}; must be in [0, 100], 0 drops the sentence", weigh.weight());
  }
  EditList edits;
  double before = 0;
  for (const v1::ConstraintEdge& edge : standing.shown.graph().edges()) {
    if (edge.sentence_id() != weigh.sentence_id()) continue;
    before = std::max(before, edge.weight());
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
  const v1::SolvedLayout& shown = standing.shown;
  const IdSet it = {weigh.sentence_id()};
  const bool held = WhyUnmet(shown, it).empty();
  Aim aim{it, ObjectsOf(it, shown.graph())};
  // What is dropped or counts no more than before makes room for others.
  const bool more = weigh.weight() > before && !held;
  if (!more) aim.sentence_ids = WaitingFor(shown, aim.object_ids, weigh.sentence_id());
  ASSIGN_OR_RETURN(Acted acted, Tried(standing, edits, aim, call));
  acted.label = WeighLabel(shown, weigh);
  const std::string subject = aim.object_ids.empty() ? "" : *aim.object_ids.begin();
  const std::string unmet = WhyUnmet(acted.layout, aim.sentence_ids);
  const std::string of_it = QuotedTexts(shown.graph(), it);
  if (aim.sentence_ids.empty()) {
    if (!acted.moved_ids.empty()) return acted;
    const bool raised = weigh.weight() > before;
    acted.diagnostics.push_back(
        Remark(v1::SEVERITY_NOTE, "nothing_waits", subject,
               raised ? fmt::format("Nothing moves: {} holds already", of_it)
                      : fmt::format("Nothing moves: all else that is wished around here holds already")));
  } else if (!unmet.empty() && (more || acted.moved_ids.empty())) {
    ASSIGN_OR_RETURN(const std::string why, WhyNot(acted.layout, aim, call));
    acted.diagnostics.push_back(Remark(
        v1::SEVERITY_WARNING, "weighed_in_vain", subject,
        fmt::format("{} still does not hold: {}; {}", QuotedTexts(shown.graph(), aim.sentence_ids), unmet, why)));
  }
  return acted;
}

}  // namespace flair::session
