// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold: sentences before and after cleaning, and the graph of their calls.
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/inspect/content_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

using Words = std::map<std::string_view, const v1::Sentence*>;

Words WordsOf(const v1::ConstraintList& list) {
  Words words;
  for (const v1::Sentence& sentence : list.sentences()) words.emplace(sentence.id(), &sentence);
  return words;
}

std::string ScopeTitle(v1::SentenceScope scope) {
  switch (scope) {
    case v1::SENTENCE_SCOPE_INTRA:
      return "ONE OBJECT AND THE ROOM";
    case v1::SENTENCE_SCOPE_INTER:
      return "OBJECTS AMONG EACH OTHER";
    case v1::SENTENCE_SCOPE_TERTIARY:
      return "WHERE THE SMALL THINGS GO";
    default:
      return "NO SCOPE";
  }
}

std::string ActionText(v1::CleaningAction action) {
  switch (action) {
    case v1::CLEANING_ACTION_MERGED:
      return "merged";
    case v1::CLEANING_ACTION_SPLIT:
      return "split";
    case v1::CLEANING_ACTION_CONTRADICTION_REMOVED:
      return "dropped as contradictory";
    case v1::CLEANING_ACTION_SIMPLIFIED:
      return "put more simply";
    default:
      return "changed";
  }
}

// Sentences of one side of a cleaning step, a line each, marked - or +.
std::string SideText(const google::protobuf::RepeatedPtrField<std::string>& ids, const Words& words, char mark) {
  std::string text;
  for (const std::string& id : ids) {
    const auto found = words.find(id);
    text += fmt::format("  {} {}{}\n", mark, id, found == words.end() ? "" : "  " + found->second->text());
  }
  return text;
}

// How the calls of a sentence, or their lack, look beside it.
class CallsOf {
 public:
  explicit CallsOf(const v1::LayoutGraph& graph) {
    for (const v1::ConstraintEdge& edge : graph.edges()) edges_[edge.sentence_id()].push_back(&edge);
    for (const v1::Diagnostic& remark : graph.diagnostics()) why_.emplace(remark.subject_id(), remark.message());
  }
  const std::vector<const v1::ConstraintEdge*>& Of(const std::string& sentence_id) { return edges_[sentence_id]; }
  std::string WhyNone(const std::string& sentence_id) const {
    const auto found = why_.find(sentence_id);
    return found == why_.end() ? "no call" : "no call: " + found->second;
  }

 private:
  std::map<std::string, std::vector<const v1::ConstraintEdge*>> edges_;
  std::map<std::string, std::string> why_;
};

}  // namespace

std::string SentencesText(const v1::ConstraintList& list, const ContentStyle& style) {
  std::string text;
  for (int scope = v1::SENTENCE_SCOPE_UNSPECIFIED; scope < v1::SentenceScope_ARRAYSIZE; ++scope) {
    Columns table({"id", "sentence", "about", ">weight", "from", "why"});
    int count = 0;
    for (const v1::Sentence& sentence : list.sentences()) {
      if (sentence.scope() != scope) continue;
      ++count;
      table.Add({sentence.id(), sentence.text(), fmt::format("{}", fmt::join(sentence.subject_ids(), ", ")),
                 fmt::format("{:g}", sentence.weight()), fmt::format("{}", fmt::join(sentence.made_from_ids(), ", ")),
                 sentence.reason()});
    }
    if (count == 0) continue;
    text += Heading(fmt::format("{}, {}", ScopeTitle(static_cast<v1::SentenceScope>(scope)), count));
    text += table.Text(style.most_rows);
  }
  return text + RemarksText(list.diagnostics(), style);
}

std::string CleanedText(const v1::ConstraintList& list, const v1::ConstraintList* raw, const ContentStyle& style) {
  const Words before = raw == nullptr ? Words() : WordsOf(*raw);
  const Words after = WordsOf(list);
  std::string text = fmt::format(
      "{:<11}{}\n", "before",
      raw == nullptr ? "not known: the list before cleaning was not found; ids of its sentences stand for them"
                     : fmt::format("{}; after: {}", Counted(raw->sentences_size(), "sentence"), list.sentences_size()));
  if (list.cleaning_steps().empty()) text += fmt::format("{:<11}nothing was to clean\n", "cleaning");
  for (const v1::CleaningStep& step : list.cleaning_steps()) {
    text += fmt::format("\n{}: {}\n", ActionText(step.action()), step.reason());
    text += SideText(step.from_ids(), before, '-') + SideText(step.to_ids(), after, '+');
  }
  return text + SentencesText(list, style);
}

std::string GraphText(const v1::LayoutGraph& graph, const ContentStyle& style) {
  std::string text = fmt::format(
      "{:<11}{}, {}, {}; {}, {} for {}\n", "problem",
      graph.room().room_type().empty() ? "room" : graph.room().room_type(),
      Counted(graph.object_list().objects_size(), "object"), Counted(graph.zone_plan().zones_size(), "zone"),
      Counted(graph.constraint_list().sentences_size(), "sentence"), Counted(graph.edges_size(), "call"),
      graph.catalog_library().empty() ? "no named library" : graph.catalog_library());
  CallsOf calls(graph);
  Columns table({"id", "sentence", "edge", "call"});
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    const std::vector<const v1::ConstraintEdge*>& edges = calls.Of(sentence.id());
    if (edges.empty()) table.Add({sentence.id(), sentence.text(), "-", calls.WhyNone(sentence.id())});
    for (size_t i = 0; i < edges.size(); ++i) {
      table.Add({i == 0 ? sentence.id() : "", i == 0 ? sentence.text() : "", edges[i]->id(), CallText(*edges[i])});
    }
  }
  if (!table.empty()) text += Heading("SENTENCES AND CALLS") + table.Text(style.most_rows);
  if (const auto& others = calls.Of(""); !others.empty()) {
    Columns without({"edge", "call"});
    for (const v1::ConstraintEdge* edge : others) without.Add({edge->id(), CallText(*edge)});
    text += Heading(fmt::format("CALLS OF NO SENTENCE, {}", others.size())) + without.Text(style.most_rows);
  }
  if (!graph.pinned_placements().empty()) {
    Columns pins({"pinned", ">x m", ">y m"});
    for (const v1::Placement& pin : graph.pinned_placements()) {
      pins.Add({pin.object_id(), fmt::format("{:.3f}", pin.x_m()), fmt::format("{:.3f}", pin.y_m())});
    }
    text += Heading("PINNED") + pins.Text(style.most_rows);
  }
  return text + ObjectsText(graph.object_list(), style) + RemarksText(graph.diagnostics(), style);
}

}  // namespace flair::cli
