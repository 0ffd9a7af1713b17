// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "cli/input/message_text.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

template <typename Content>
std::string RemarksText(const Content& content, size_t most_rows) {
  return ListTable(content, "diagnostics", "REMARKS", most_rows);
}

using Words = std::map<std::string_view, std::string_view>;

Words WordsOf(const v1::ConstraintList& list) {
  Words words;
  for (const v1::Sentence& sentence : list.sentences()) words.emplace(sentence.id(), sentence.text());
  return words;
}

std::string WordsOfId(const Words& words, const std::string& id) {
  const auto found = words.find(id);
  return found == words.end() ? "" : std::string(found->second);
}

std::string SentencesText(const v1::ConstraintList& list, size_t most_rows) {
  return ListTable(list, "sentences", "SENTENCES", most_rows) + RemarksText(list, most_rows);
}

// How the calls that name an object came out.
struct Verdicts {
  int held = 0;
  int missed = 0;
  int dropped = 0;
  std::string Text() const {
    if (held + missed + dropped == 0) return "";
    std::string text = missed + dropped == 0 ? fmt::format("✓ {}", held) : fmt::format("{} hold", held);
    if (missed > 0) text += fmt::format(", {} missed", missed);
    if (dropped > 0) text += fmt::format(", {} dropped", dropped);
    return text;
  }
};

std::map<std::string_view, Verdicts> VerdictsOf(const v1::SolvedLayout& layout) {
  std::map<std::string_view, Verdicts> verdicts;
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    const v1::OutcomeStatus status = layout.edge_outcomes(i).status();
    const auto count = [&](std::string_view object_id) {
      Verdicts& of = verdicts[object_id];
      ++(status == v1::OUTCOME_STATUS_SATISFIED  ? of.held
         : status == v1::OUTCOME_STATUS_VIOLATED ? of.missed
                                                 : of.dropped);
    };
    for (const v1::Argument& argument : layout.graph().edges(i).arguments()) {
      if (argument.value().has_text()) count(argument.value().text());
      for (const std::string& item : argument.value().texts().items()) count(item);
    }
  }
  return verdicts;
}

std::string PosesText(const v1::SolvedLayout& layout, size_t most_rows) {
  std::map<std::string_view, const v1::Object*> objects;
  for (const v1::Object& object : layout.graph().object_list().objects()) objects.emplace(object.id(), &object);
  const auto object = [&](int i) -> const v1::Object& {
    const auto found = objects.find(layout.placements(i).object_id());
    return found == objects.end() ? v1::Object::default_instance() : *found->second;
  };
  std::map<std::string_view, Verdicts> verdicts = VerdictsOf(layout);
  return ListTable(layout, "placements", "OBJECTS", most_rows,
                   {{"name", [&](int i) { return object(i).name(); }},
                    {"zone", [&](int i) { return object(i).zone_id(); }},
                    {">width m", [&](int i) { return fmt::format("{:.2f}", object(i).width_m()); }},
                    {">depth m", [&](int i) { return fmt::format("{:.2f}", object(i).depth_m()); }},
                    {"its constraints", [&](int i) { return verdicts[layout.placements(i).object_id()].Text(); }}});
}

// The calls that came out so, dearest first, with their ids, which flair resolve takes.
std::string EdgesText(const v1::SolvedLayout& layout, v1::OutcomeStatus status, const std::string& title,
                      size_t most_rows) {
  std::vector<int> edges;
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    if (layout.edge_outcomes(i).status() == status) edges.push_back(i);
  }
  const bool is_violated = status == v1::OUTCOME_STATUS_VIOLATED, is_met = status == v1::OUTCOME_STATUS_SATISFIED;
  if (edges.empty()) return is_violated ? Heading("NOT MET: nothing") : "";
  if (is_violated) {
    std::ranges::stable_sort(edges, std::greater(), [&](int i) { return layout.edge_outcomes(i).weighted_cost(); });
  }
  const Words words = WordsOf(layout.graph().constraint_list());
  Columns table(is_met ? std::vector<std::string>{"edge", "call", "sentence"}
                       : std::vector<std::string>{"edge", ">weighted cost", "why", "call", "sentence"});
  for (const int i : edges) {
    const v1::EdgeOutcome& outcome = layout.edge_outcomes(i);
    const v1::ConstraintEdge& edge = layout.graph().edges(i);
    std::vector<std::string> cells = {edge.id(), CallText(edge), WordsOfId(words, edge.sentence_id())};
    if (!is_met) cells.insert(cells.begin() + 1, {fmt::format("{:.4f}", outcome.weighted_cost()), outcome.reason()});
    table.Add(std::move(cells));
  }
  return Heading(fmt::format("{}, {}{}", title, edges.size(), is_violated ? ", dearest first" : "")) +
         table.Text(most_rows);
}

std::string ContradictionsText(const v1::SolvedLayout& layout) {
  std::string text = layout.contradictions().empty() ? "" : Heading("CANNOT HOLD TOGETHER");
  for (const v1::Contradiction& clash : layout.contradictions()) {
    text += fmt::format("{}: {}\n", fmt::join(clash.edge_ids(), ", "), clash.explanation());
  }
  return text;
}

std::string CostText(const v1::SolvedLayout& layout) {
  double edges = 0;
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) edges += edge.weighted_cost();
  return fmt::format("cost       {:.4f}, of it {:.4f} of constraints\nmeasures   {}\n", layout.total_cost(), edges,
                     FieldsInWords(layout.metrics()));
}

std::string TermsText(const v1::SolvedLayout& layout) {
  return ListTable(layout, "term_outcomes", "TERMS OF THE WHOLE ROOM", kMostRows,
                   {{">weighted", [&](int i) {
                       return fmt::format("{:.4f}", layout.term_outcomes(i).cost() * layout.term_outcomes(i).factor());
                     }}});
}

}  // namespace

std::string RoomText(const v1::Room& room, size_t most_rows) {
  const auto [width, depth] = ExtentOf(room.floor());
  double doubled_area = 0;
  const auto corner = [&room](int i) -> const v1::Point2& {
    return room.floor().vertices(i % room.floor().vertices_size());
  };
  const int corner_count = room.floor().vertices_size();
  for (int i = 0; i < corner_count; ++i) {
    doubled_area += corner(i).x_m() * corner(i + 1).y_m() - corner(i + 1).x_m() * corner(i).y_m();
  }
  const auto things_in = [&room](int i) {
    std::vector<std::string> ids;
    for (const v1::Opening& opening : room.openings()) {
      if (opening.wall() == room.walls(i).name()) ids.push_back(opening.id());
    }
    for (const v1::Socket& socket : room.sockets()) {
      if (socket.wall() == room.walls(i).name()) ids.push_back(socket.id());
    }
    return fmt::format("{}", fmt::join(ids, ", "));
  };
  const auto point = [&](int i) {
    return corner_count == 0 ? "" : fmt::format("({:.4g}, {:.4g})", corner(i).x_m(), corner(i).y_m());
  };
  const auto length = [&](int i) {
    if (corner_count == 0) return std::string();
    return fmt::format("{:.2f}",
                       std::hypot(corner(i + 1).x_m() - corner(i).x_m(), corner(i + 1).y_m() - corner(i).y_m()));
  };
  return fmt::format("size       {:.4g} m x {:.4g} m, {:.4g} m high, {:.4g} m2\n", width, depth, room.height_m(),
                     doubled_area / 2) +
         FieldLines(room, {"height_m"}) +
         ListTable(room, "walls", "WALLS", most_rows,
                   {{"from", point},
                    {"to", [&](int i) { return point(i + 1); }},
                    {">length m", length},
                    {"with", things_in}}) +
         ListTable(room, "openings", "OPENINGS", most_rows) + ListTable(room, "sockets", "SOCKETS", most_rows) +
         RemarksText(room, most_rows);
}

std::string ObjectsText(const v1::ObjectList& list, size_t most_rows) {
  return ListTable(list, "objects", "OBJECTS", most_rows) + ListTable(list, "omissions", "LEFT OUT", most_rows) +
         RemarksText(list, most_rows);
}

std::string CleanedText(const v1::ConstraintList& list, const v1::ConstraintList* raw, size_t most_rows) {
  std::string text = fmt::format(
      "before     {}\n",
      raw == nullptr ? "not known: the list before cleaning was not found; ids of its sentences stand for them"
                     : fmt::format("{}; after: {}", Counted(raw->sentences_size(), "sentence"), list.sentences_size()));
  if (list.cleaning_steps().empty()) text += "cleaning   nothing to clean\n";
  const Words before = raw == nullptr ? Words() : WordsOf(*raw), after = WordsOf(list);
  for (const v1::CleaningStep& step : list.cleaning_steps()) {
    text += fmt::format("\n{}: {}\n", EnumInWords(step.action()), step.reason());
    for (const std::string& id : step.from_ids()) text += fmt::format("  - {}  {}\n", id, WordsOfId(before, id));
    for (const std::string& id : step.to_ids()) text += fmt::format("  + {}  {}\n", id, WordsOfId(after, id));
  }
  return text + SentencesText(list, most_rows);
}

std::string CompletedText(const v1::ConstraintList& list, size_t most_rows) {
  std::string text;
  for (const v1::CleaningStep& step : list.cleaning_steps()) {
    if (step.action() == v1::CLEANING_ACTION_USE_FIRST) text += fmt::format("gave way   {}\n", step.reason());
  }
  return text + SentencesText(list, most_rows);
}

std::string GraphText(const v1::LayoutGraph& graph, size_t most_rows) {
  std::map<std::string_view, std::vector<const v1::ConstraintEdge*>> calls;
  for (const v1::ConstraintEdge& edge : graph.edges()) calls[edge.sentence_id()].push_back(&edge);
  std::map<std::string_view, std::string_view> why_none;
  for (const v1::Diagnostic& remark : graph.diagnostics()) why_none.emplace(remark.subject_id(), remark.message());
  Columns table({"id", "sentence", "edge", "call"});
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    std::string id = sentence.id(), words = sentence.text();
    if (calls[id].empty()) {
      const auto why = why_none.find(id);
      table.Add({id, words, "-", why == why_none.end() ? "no call" : fmt::format("no call: {}", why->second)});
    }
    for (const v1::ConstraintEdge* edge : calls[sentence.id()]) {
      table.Add({std::exchange(id, ""), std::exchange(words, ""), edge->id(), CallText(*edge)});
    }
  }
  for (const v1::ConstraintEdge* edge : calls[""]) table.Add({"-", "(no sentence)", edge->id(), CallText(*edge)});
  std::string text = FieldLines(graph);
  if (!table.empty()) text += Heading("SENTENCES AND CALLS") + table.Text(most_rows);
  return text + ListTable(graph, "pinned_placements", "PINNED", most_rows) +
         ObjectsText(graph.object_list(), most_rows) + RemarksText(graph, most_rows);
}

std::string LayoutText(const v1::SolvedLayout& layout, size_t most_rows) {
  std::string text = CostText(layout);
  if (!layout.runner_ups().empty()) {
    std::vector<std::string> costs;
    for (const v1::RunnerUp& other : layout.runner_ups()) costs.push_back(fmt::format("{:.4f}", other.cost()));
    text += fmt::format("{:<11}{} nearly as good, of cost {}\n", "runner-ups", Counted(std::ssize(costs), "other"),
                        ListNames(costs, 8));
  }
  return text + PosesText(layout, most_rows) + EdgesText(layout, v1::OUTCOME_STATUS_VIOLATED, "NOT MET", most_rows) +
         EdgesText(layout, v1::OUTCOME_STATUS_DROPPED, "DROPPED", most_rows) +
         EdgesText(layout, v1::OUTCOME_STATUS_SATISFIED, "MET", most_rows) + ContradictionsText(layout) +
         TermsText(layout) + ListTable(layout, "stage_outcomes", "HOW IT WAS SOLVED", most_rows) +
         RemarksText(layout, most_rows);
}

std::string ContentText(const v1::Artifact& artifact, const v1::ConstraintList* raw, size_t most_rows) {
  switch (artifact.content_case()) {
    case v1::Artifact::kBrief: {
      const v1::Brief& brief = artifact.brief();
      std::string text = FieldLines(brief);
      if (brief.has_room()) text += Heading("THE USER'S OWN ROOM") + RoomText(brief.room(), most_rows);
      return text + MessageText(brief.zone_plan(), most_rows) + ObjectsText(brief.object_list(), most_rows) +
             SentencesText(brief.constraint_list(), most_rows);
    }
    case v1::Artifact::kRoom:
      return RoomText(artifact.room(), most_rows);
    case v1::Artifact::kZonePlan:
      return MessageText(artifact.zone_plan(), most_rows);
    case v1::Artifact::kObjectList:
      return ObjectsText(artifact.object_list(), most_rows);
    case v1::Artifact::kStyleSheet:
      return MessageText(artifact.style_sheet(), most_rows);
    case v1::Artifact::kRawConstraintList:
      return SentencesText(artifact.raw_constraint_list(), most_rows);
    case v1::Artifact::kConstraintList:
      return CleanedText(artifact.constraint_list(), raw, most_rows);
    case v1::Artifact::kCompletedConstraintList:
      return CompletedText(artifact.completed_constraint_list(), most_rows);
    case v1::Artifact::kLayoutGraph:
      return GraphText(artifact.layout_graph(), most_rows);
    case v1::Artifact::kSolvedLayout:
      return LayoutText(artifact.solved_layout(), most_rows);
    case v1::Artifact::kPreview:
      return MessageText(artifact.preview(), most_rows) +
             "get it     --field preview.image --out FILE writes the picture\n";
    case v1::Artifact::kReport:
      return MessageText(artifact.report(), most_rows);
    case v1::Artifact::CONTENT_NOT_SET:
      break;
  }
  return "";
}

std::string SolveStats(const v1::SolveResponse& response) {
  const v1::SolvedLayout& layout = response.solved_layout();
  const auto wall_ms = [&response](int i) {
    if (i >= response.stage_durations_size()) return std::string("-");
    return fmt::format("{:.1f}", 1e3 * SecondsOf(response.stage_durations(i)));
  };
  return CostText(layout) + TermsText(layout) + EdgesText(layout, v1::OUTCOME_STATUS_VIOLATED, "NOT MET", SIZE_MAX) +
         EdgesText(layout, v1::OUTCOME_STATUS_DROPPED, "DROPPED", SIZE_MAX) +
         ListTable(layout, "stage_outcomes", "STAGES OF THE BRANCH THAT WON", SIZE_MAX, {{">wall ms", wall_ms}});
}

}  // namespace flair::cli
