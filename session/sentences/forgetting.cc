// SPDX-License-Identifier: GPL-3.0-or-later
// What is not said any more once an act has answered it.
#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "evaluation/metrics/measures.h"
#include "fmt/format.h"
#include "session/sentences/names.h"
#include "session/sentences/said.h"
#include "session/sentences/sentences.h"

namespace flair::session {
namespace {

// Sentences that ask for something.
IdSet Asking(const v1::LayoutGraph& graph) {
  IdSet ids;
  for (const v1::ConstraintEdge& edge : graph.edges()) ids.insert(edge.sentence_id());
  return ids;
}

IdSet NamesOf(const v1::LayoutGraph& graph) {
  IdSet names;
  for (const v1::Object& object : graph.object_list().objects()) names.insert(absl::AsciiStrToLower(object.name()));
  return names;
}

IdSet Without(IdSet all, const IdSet& gone) {
  for (const std::string& id : gone) all.erase(id);
  return all;
}

// Whether a sentence of the room's field is about one of these.
bool IsSaidOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph, const IdSet& ids) {
  if (!edge.sentence_id().starts_with(kSaid)) return false;
  const IdSet here = IdsOf(graph.object_list().objects());
  for (const std::string& text : TextsOf(edge)) {
    if (here.contains(text)) return ids.contains(text);
  }
  return false;
}

// "Coffee table" answers who missed a table.
bool Supplies(const std::string& name, const std::string& missed) {
  return name == missed || absl::EndsWith(name, " " + missed);
}

}  // namespace

void ForgetWhatIsAnswered(const v1::LayoutGraph& before, v1::SolvedLayout& layout) {
  v1::LayoutGraph& graph = *layout.mutable_graph();
  const v1::ConstraintList& wishes = graph.constraint_list();
  const v1::ObjectList& objects = graph.object_list();
  const IdSet silenced = Without(Asking(before), Asking(graph));
  const IdSet lost = Without(IdsOf(before.object_list().objects()), IdsOf(objects.objects()));
  const IdSet came = Without(NamesOf(graph), NamesOf(before));
  IdSet gone = lost, holding = Without(Asking(graph), UnmetSentences(layout));
  holding.erase("");
  for (const v1::Sentence& sentence : before.constraint_list().sentences()) {
    const auto is_lost = [&](const std::string& id) { return lost.contains(id); };
    const bool orphan = !sentence.subject_ids().empty() && std::ranges::all_of(sentence.subject_ids(), is_lost);
    if (orphan || silenced.contains(sentence.id())) gone.insert(sentence.id());
  }
  const int had = wishes.sentences_size();
  if (had > 0) {
    EraseIf(*graph.mutable_constraint_list()->mutable_sentences(),
            [&](const v1::Sentence& sentence) { return gone.contains(sentence.id()); });
  }
  if (wishes.sentences_size() < had) {
    EraseIf(*layout.mutable_metrics()->mutable_findings(),
            [](const v1::Finding& finding) { return finding.kind() == v1::FINDING_KIND_USE_NOT_MET; });
    evaluation::AddUses(graph, layout.placements(), layout.edge_outcomes(), *layout.mutable_metrics());
  }
  const auto answered = [&](const v1::Diagnostic& remark) {
    if (gone.contains(remark.subject_id())) return true;
    // Nothing stands badly for a piece that has gone.
    const bool of_act = remark.code() == "edge_removed" || remark.code() == "edge_dropped";
    const std::string& said = remark.message();
    if (!of_act && std::ranges::any_of(
                       lost, [&](const std::string& id) { return said.find('"' + id + '"') != std::string::npos; })) {
      return true;
    }
    // What of a sentence was not understood is not answered by the rest of it.
    if (holding.contains(remark.subject_id()) && remark.code() != "partial") return true;
    const bool misses = remark.code() == "names_absent_object" || remark.code() == "essential_missing";
    return misses && std::ranges::any_of(came, [&](const std::string& name) {
             return FindWord(absl::AsciiStrToLower(remark.message()), name) != std::string::npos;
           });
  };
  // What is not there must not come to be by being asked.
  if (graph.room().diagnostics_size() > 0) EraseIf(*graph.mutable_room()->mutable_diagnostics(), answered);
  if (graph.zone_plan().diagnostics_size() > 0) EraseIf(*graph.mutable_zone_plan()->mutable_diagnostics(), answered);
  if (objects.diagnostics_size() > 0) EraseIf(*graph.mutable_object_list()->mutable_diagnostics(), answered);
  if (wishes.diagnostics_size() > 0) EraseIf(*graph.mutable_constraint_list()->mutable_diagnostics(), answered);
  EraseIf(*graph.mutable_diagnostics(), answered);
  EraseIf(*layout.mutable_diagnostics(), answered);
  if (objects.omissions().empty()) return;
  EraseIf(*graph.mutable_object_list()->mutable_omissions(), [&](const v1::Omission& omission) {
    const std::string missed = absl::AsciiStrToLower(omission.name());
    return std::ranges::any_of(came, [&](const std::string& name) { return Supplies(name, missed); });
  });
}

bool IsSaidOf(const v1::LayoutGraph& graph, const IdSet& ids) {
  return std::ranges::any_of(graph.edges(), [&](const v1::ConstraintEdge& edge) { return IsSaidOf(edge, graph, ids); });
}

EditList SaidOtherwise(const v1::SolvedLayout& layout, const IdSet& ids) {
  const IdSet unmet = UnmetSentences(layout);
  IdSet overtaken;
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    if (unmet.contains(edge.sentence_id()) && IsSaidOf(edge, layout.graph(), ids)) overtaken.insert(edge.sentence_id());
  }
  EditList drops;
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    if (overtaken.contains(edge.sentence_id())) drops.Add()->set_remove_edge_id(edge.id());
  }
  return drops;
}

void Drop(const EditList& edits, v1::SolvedLayout& layout) {
  v1::LayoutGraph& graph = *layout.mutable_graph();
  for (const v1::LayoutEdit& edit : edits) {
    const auto edge = std::ranges::find(graph.edges(), edit.remove_edge_id(), &v1::ConstraintEdge::id);
    if (edge == graph.edges().end()) continue;
    const int at = static_cast<int>(edge - graph.edges().begin());
    graph.mutable_edges()->DeleteSubrange(at, 1);
    if (at < layout.edge_outcomes_size()) layout.mutable_edge_outcomes()->DeleteSubrange(at, 1);
  }
}

void KeepForgotten(const v1::LayoutGraph& shown, v1::LayoutGraph& graph) {
  const IdSet known = IdsOf(shown.constraint_list().sentences());
  if (graph.constraint_list().sentences_size() > 0) {
    EraseIf(*graph.mutable_constraint_list()->mutable_sentences(),
            [&](const v1::Sentence& sentence) { return !known.contains(sentence.id()); });
  }
  if (graph.has_constraint_list()) {
    *graph.mutable_constraint_list()->mutable_diagnostics() = shown.constraint_list().diagnostics();
  }
  *graph.mutable_diagnostics() = shown.diagnostics();
  *graph.mutable_object_list()->mutable_omissions() = shown.object_list().omissions();
  *graph.mutable_object_list()->mutable_diagnostics() = shown.object_list().diagnostics();
}

std::string StandingBadly(const v1::SolvedLayout& layout, const ObjectIds& by_hand) {
  constexpr size_t kMost = 3;
  const IdSet locked = IdsOf(layout.graph().pinned_placements()), held(by_hand.begin(), by_hand.end());
  const IdSet here = IdsOf(layout.graph().object_list().objects());
  std::vector<std::string> causes;
  IdSet told;
  const auto tell = [&](const std::string& id, const std::string& reason) {
    if (reason.empty() || causes.size() == kMost || !told.insert(reason).second) return;
    const std::string name = NameOf(layout, id);
    const std::string stays = locked.contains(id) ? fmt::format(" (the {} is locked)", name)
                              : held.contains(id) ? fmt::format(" (the {} stays where you put it)", name)
                                                  : "";
    causes.push_back(reason + stays);
  };
  for (const v1::Finding& finding : layout.metrics().findings()) {
    if (finding.sentence_id().empty()) tell(finding.object_id(), finding.message());
  }
  ForOutcomes(layout, [&](const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) {
    if (outcome.status() != v1::OUTCOME_STATUS_VIOLATED) return;
    const std::vector<std::string> texts = TextsOf(edge);
    const auto first = std::ranges::find_if(texts, [&](const std::string& text) { return here.contains(text); });
    if (first != texts.end()) tell(*first, outcome.reason());
  });
  return absl::StrJoin(causes, "; ");
}

v1::Diagnostic WhyNothingMoves(const v1::SolvedLayout& layout, const ObjectIds& by_hand) {
  const std::string wrong = StandingBadly(layout, by_hand);
  return Remark(v1::SEVERITY_NOTE, "nothing_moved", "",
                wrong.empty() ? "Nothing moved: all is as good as it gets."
                              : fmt::format("Nothing moved: no better places were found, although {}.", wrong));
}

}  // namespace flair::session
