// SPDX-License-Identifier: GPL-3.0-or-later
// A furnished room, its picture and its account.
#include <algorithm>
#include <map>
#include <numbers>
#include <string_view>
#include <vector>

#include "cli/input/message_words.h"
#include "cli/inspect/content_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "orchestrator/pipeline/summary.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr size_t kWorst = 12;

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

using VerdictsByObject = std::map<std::string_view, Verdicts>;

void Count(const v1::EdgeOutcome& outcome, std::string_view object_id, VerdictsByObject& verdicts) {
  Verdicts& of = verdicts[object_id];
  ++(outcome.status() == v1::OUTCOME_STATUS_SATISFIED  ? of.held
     : outcome.status() == v1::OUTCOME_STATUS_VIOLATED ? of.missed
                                                       : of.dropped);
}

VerdictsByObject VerdictsOf(const v1::SolvedLayout& layout) {
  VerdictsByObject verdicts;
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    for (const v1::Argument& argument : layout.graph().edges(i).arguments()) {
      if (argument.value().has_text()) Count(layout.edge_outcomes(i), argument.value().text(), verdicts);
      for (const std::string& item : argument.value().texts().items()) Count(layout.edge_outcomes(i), item, verdicts);
    }
  }
  return verdicts;
}

std::string PosesText(const v1::SolvedLayout& layout, const ContentStyle& style) {
  std::map<std::string_view, const v1::Object*> objects;
  for (const v1::Object& object : layout.graph().object_list().objects()) objects.emplace(object.id(), &object);
  const VerdictsByObject verdicts = VerdictsOf(layout);
  Columns table(
      {"object", "name", "zone", ">x m", ">y m", ">z m", ">heading", ">width m", ">depth m", "its constraints"});
  for (const v1::Placement& placement : layout.placements()) {
    const auto found = objects.find(placement.object_id());
    const v1::Object& object = found == objects.end() ? v1::Object::default_instance() : *found->second;
    const auto verdict = verdicts.find(placement.object_id());
    table.Add({placement.object_id(), object.name(), object.zone_id(), fmt::format("{:.3f}", placement.x_m()),
               fmt::format("{:.3f}", placement.y_m()), fmt::format("{:.3f}", placement.z_m()),
               fmt::format("{:.1f}°", placement.theta_rad() * 180 / std::numbers::pi),
               fmt::format("{:.2f}", object.width_m()), fmt::format("{:.2f}", object.depth_m()),
               verdict == verdicts.end() ? "" : verdict->second.Text()});
  }
  return Heading(fmt::format("OBJECTS, {}", layout.placements_size())) + table.Text(style.most_rows);
}

std::string SentenceOf(const v1::LayoutGraph& graph, const std::string& id) {
  const auto& sentences = graph.constraint_list().sentences();
  const auto found = std::find_if(sentences.begin(), sentences.end(),
                                  [&id](const v1::Sentence& sentence) { return sentence.id() == id; });
  return found == sentences.end() ? "" : found->text();
}

// Indices of the edges with the status, dearest first.
std::vector<int> EdgesWith(const v1::SolvedLayout& layout, v1::OutcomeStatus status) {
  std::vector<int> edges;
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    if (layout.edge_outcomes(i).status() == status) edges.push_back(i);
  }
  std::stable_sort(edges.begin(), edges.end(), [&layout](int a, int b) {
    return layout.edge_outcomes(a).weighted_cost() > layout.edge_outcomes(b).weighted_cost();
  });
  return edges;
}

std::string OffendersText(const v1::SolvedLayout& layout, const ContentStyle& style) {
  const std::vector<int> edges = EdgesWith(layout, v1::OUTCOME_STATUS_VIOLATED);
  if (edges.empty()) return Heading("NOT MET: nothing");
  Columns table({"edge", ">weighted cost", "missed", "call", "sentence"});
  for (const int i : edges) {
    const v1::EdgeOutcome& outcome = layout.edge_outcomes(i);
    const v1::ConstraintEdge& edge = layout.graph().edges(i);
    table.Add({edge.id(), fmt::format("{:.4f}", outcome.weighted_cost()), outcome.reason(), CallText(edge),
               SentenceOf(layout.graph(), edge.sentence_id())});
  }
  return Heading(fmt::format("NOT MET, {}, dearest first", edges.size())) +
         table.Text(std::max(kWorst, style.most_rows));
}

// With their ids, which flair resolve takes.
std::string MetText(const v1::SolvedLayout& layout, const ContentStyle& style) {
  std::vector<int> edges = EdgesWith(layout, v1::OUTCOME_STATUS_SATISFIED);
  if (edges.empty()) return "";
  std::ranges::sort(edges);
  Columns table({"edge", "call", "sentence"});
  for (const int i : edges) {
    const v1::ConstraintEdge& edge = layout.graph().edges(i);
    table.Add({edge.id(), CallText(edge), SentenceOf(layout.graph(), edge.sentence_id())});
  }
  return Heading(fmt::format("MET, {}", edges.size())) + table.Text(style.most_rows);
}

std::string DroppedText(const v1::SolvedLayout& layout, const ContentStyle& style) {
  const std::vector<int> edges = EdgesWith(layout, v1::OUTCOME_STATUS_DROPPED);
  if (edges.empty()) return "";
  Columns table({"edge", "why", "call"});
  for (const int i : edges) {
    table.Add({layout.graph().edges(i).id(), layout.edge_outcomes(i).reason(), CallText(layout.graph().edges(i))});
  }
  return Heading(fmt::format("DROPPED, {}", edges.size())) + table.Text(style.most_rows);
}

std::string TermsText(const v1::SolvedLayout& layout) {
  std::vector<const v1::TermOutcome*> terms;
  for (const v1::TermOutcome& term : layout.term_outcomes()) terms.push_back(&term);
  std::stable_sort(terms.begin(), terms.end(), [](const v1::TermOutcome* a, const v1::TermOutcome* b) {
    return a->cost() * a->factor() > b->cost() * b->factor();
  });
  std::string text = fmt::format("{:<11}{:.4f} in all", "cost", layout.total_cost());
  for (const v1::TermOutcome* term : terms) {
    if (term->cost() * term->factor() > 0)
      text += fmt::format(", {} {:.4f}", term->term(), term->cost() * term->factor());
  }
  return text + "\n";
}

std::string MeasuresText(const v1::LayoutMetrics& m) {
  return fmt::format(
      "{:<11}OOB {:.4f} %, OOR {:.4f} %, deepest overlap {:.1f} mm; reached: {:.0f} % of the floor, {:.0f} % of the "
      "fronts; pathway cost {:.4f} m3\n",
      "measures", m.oob_percent(), m.oor_percent(), 1e3 * m.deepest_overlap_m(), 100 * m.reachable_floor_share(),
      100 * m.reachable_front_share(), m.pathway_cost_m3());
}

std::string StagesText(const v1::SolvedLayout& layout, const ContentStyle& style) {
  if (layout.stage_outcomes().empty()) return "";
  Columns table({"stage", "zone", ">restarts", ">best one", ">evaluations", ">seed", ">cost", "note"});
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) {
    table.Add({stage.stage(), stage.zone_id(), fmt::format("{}", stage.restart_count()),
               fmt::format("{}", stage.best_restart()), fmt::format("{}", stage.evaluation_count()),
               fmt::format("{}", stage.seed()), fmt::format("{:.4f}", stage.cost()),
               stage.stopped_early() ? "stopped by the time limit" : ""});
  }
  return Heading("HOW IT WAS SOLVED") + table.Text(style.most_rows);
}

}  // namespace

std::string LayoutText(const v1::SolvedLayout& layout, const ContentStyle& style) {
  std::string text = TermsText(layout) + MeasuresText(layout.metrics());
  if (!layout.runner_ups().empty()) {
    std::vector<std::string> costs;
    for (const v1::RunnerUp& other : layout.runner_ups()) costs.push_back(fmt::format("{:.4f}", other.cost()));
    text += fmt::format("{:<11}{} nearly as good, of cost {}\n", "runner-ups", Counted(std::ssize(costs), "other"),
                        ListNames(costs, 8));
  }
  text += PosesText(layout, style) + OffendersText(layout, style) + DroppedText(layout, style) + MetText(layout, style);
  if (!layout.contradictions().empty()) {
    text += Heading("CANNOT HOLD TOGETHER");
    for (const v1::Contradiction& clash : layout.contradictions()) {
      text += fmt::format("{}: {}\n", fmt::join(clash.edge_ids(), ", "), clash.explanation());
    }
  }
  return text + StagesText(layout, style) + RemarksText(layout.diagnostics(), style);
}

std::string PreviewText(const v1::Preview& preview, const ContentStyle& style) {
  std::string text = fmt::format("{:<11}{}, {}, {} x {} px, {} bytes\n", "picture",
                                 ShortName(v1::PreviewView_Name(preview.view()), "PREVIEW_VIEW_"),
                                 ShortName(v1::PreviewFormat_Name(preview.format()), "PREVIEW_FORMAT_"),
                                 preview.width_px(), preview.height_px(), preview.image().size());
  text += fmt::format("{:<11}--field preview.image --out FILE writes the picture\n", "get it");
  if (!preview.has_annotations()) return text;
  const v1::CameraParameters& camera = preview.annotations().camera();
  text += fmt::format("{:<11}focal length {:.1f} x {:.1f} px, centre {:.1f}, {:.1f} px\n", "camera",
                      camera.focal_x_px(), camera.focal_y_px(), camera.center_x_px(), camera.center_y_px());
  Columns table({">instance", "class", "what", ">pixels"});
  for (const v1::Instance& instance : preview.annotations().instances()) {
    table.Add({fmt::format("{}", instance.instance_id()), instance.class_name(), instance.subject_id(),
               fmt::format("{}", instance.visible_pixel_count())});
  }
  return text + Heading("IN THE PICTURE") + table.Text(style.most_rows);
}

std::string ReportText(const v1::Report& report, const ContentStyle& style) {
  const v1::ConstraintSummary& counts = report.constraints();
  std::string text = fmt::format("{:<11}{}\n", "job", report.job_id()) + MeasuresText(report.metrics());
  text +=
      fmt::format("{:<11}{} hold, {} do not, {} dropped, {} not understood\n", "sentences", counts.satisfied_count(),
                  counts.violated_count(), counts.dropped_count(), counts.untranslated_count());
  if (report.has_model_usage()) {
    text += fmt::format("{:<11}{}, {}\n", "models", Counted(report.model_usage().call_count(), "call"),
                        orchestrator::SummarizeUsage(report.model_usage()));
  }
  Columns table({"stage", ">seconds", ""});
  for (const v1::StageTiming& timing : report.stage_timings()) {
    table.Add(
        {timing.stage(),
         fmt::format("{:.3f}", static_cast<double>(timing.duration().seconds()) + 1e-9 * timing.duration().nanos()),
         timing.reused() ? "as before" : ""});
  }
  return text + Heading("TIMES") + table.Text(style.most_rows) + RemarksText(report.diagnostics(), style);
}

}  // namespace flair::cli
