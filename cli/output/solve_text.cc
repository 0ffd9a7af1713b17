// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <vector>

#include "cli/output/artifact_text.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

template <typename Layout>  // SolvedLayout or RunnerUp
int CountOf(const Layout& layout, v1::OutcomeStatus status) {
  return static_cast<int>(std::ranges::count_if(
      layout.edge_outcomes(), [status](const v1::EdgeOutcome& edge) { return edge.status() == status; }));
}

template <typename Layout>
std::vector<std::string> VariantCells(int number, double cost, const Layout& layout) {
  const v1::LayoutMetrics& m = layout.metrics();
  return {fmt::format("{}", number),
          fmt::format("{:.4f}", cost),
          fmt::format("{}", CountOf(layout, v1::OUTCOME_STATUS_SATISFIED)),
          fmt::format("{}", CountOf(layout, v1::OUTCOME_STATUS_VIOLATED)),
          fmt::format("{:.4f}", m.oob_percent()),
          fmt::format("{:.4f}", m.oor_percent()),
          fmt::format("{:.3f}", m.reachable_floor_share()),
          fmt::format("{:.3f}", m.reachable_front_share()),
          fmt::format("{:.4f}", m.pathway_cost_m3())};
}

// Of the floor objects at the end: what runner-ups are compared by.
double FloorCost(const v1::SolvedLayout& layout) {
  double cost = 0;
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) {
    if (stage.stage() != "tertiary") cost = stage.cost();
  }
  return cost;
}

constexpr int kListedDrops = 20;

std::vector<std::string> Row(const std::string& stage, const std::string& models, int repairs,
                             const v1::ModelUsage& usage) {
  return {stage,
          models,
          std::to_string(usage.call_count()),
          std::to_string(repairs),
          fmt::format("{}{}", usage.estimated() ? "about " : "", usage.input_token_count()),
          std::to_string(usage.output_token_count()),
          usage.cost_usd() > 0 ? fmt::format("{:.4f} USD", usage.cost_usd()) : ""};
}

std::string StageTable(const ArtifactsByKind& artifacts) {
  std::vector<std::vector<std::string>> rows;
  int all_repairs = 0;
  for (const auto& [kind, artifact] : artifacts) {
    if (artifact.model_calls().empty()) continue;
    std::set<std::string> models;
    for (const v1::ModelCall& call : artifact.model_calls()) models.insert(call.model());
    const int repairs = static_cast<int>(std::ranges::count_if(artifact.model_calls(), orchestrator::IsRepair));
    v1::ModelUsage usage;
    orchestrator::AddUsage(artifact, usage);
    rows.push_back(Row(KindName(kind), fmt::format("{}", fmt::join(models, ", ")), repairs, usage));
    all_repairs += repairs;
  }
  rows.push_back(Row("**all**", "", all_repairs, UsageOf(artifacts)));
  return MarkdownTable({"stage", "model", "calls", "repairs", "tokens asked", "answered", "cost"}, rows);
}

// Lines of a list under a sentence; nothing without any.
std::string ListText(const char* sentence, const std::vector<std::string>& items) {
  std::string text = items.empty() ? "" : fmt::format("\n{}\n\n", sentence);
  for (const std::string& item : items) text += fmt::format("- {}\n", MarkdownCell(item));
  return text;
}

}  // namespace

std::string LayoutLine(const v1::SolvedLayout& layout) {
  const int count = layout.edge_outcomes_size();
  const std::string held = count == 0 ? ""
                                      : fmt::format("{} of {}, ", CountOf(layout, v1::OUTCOME_STATUS_SATISFIED),
                                                    Counted(count, "constraint holds", "constraints hold"));
  const v1::LayoutMetrics& metrics = layout.metrics();
  const std::string uses =
      metrics.use_count() == 0 ? "" : fmt::format("{} of {} uses met, ", metrics.met_use_count(), metrics.use_count());
  const std::string solids =
      metrics.has_oor_3d_percent() ? fmt::format(" ({:.2f} % in 3D)", metrics.oor_3d_percent()) : "";
  return fmt::format("{}{}OOB {:.2f} %, OOR {:.2f} %{}", held, uses, metrics.oob_percent(), metrics.oor_percent(),
                     solids);
}

bool IsComplete(const v1::RunnerUp& runner_up) { return runner_up.has_metrics(); }

std::string VariantsTable(const v1::SolvedLayout& layout, const std::vector<std::string>& files) {
  std::vector<std::string> titles = {"layout", "cost",  "held",   "missed", "OOB %",
                                     "OOR %",  "floor", "fronts", "path m3"};
  if (!files.empty()) titles.push_back("file");
  const TextTable table(titles, 8, 8);
  const auto row = [&](std::vector<std::string> cells, size_t i) {
    if (!files.empty()) cells.push_back(i < files.size() ? files[i] : "");
    return table.Row(cells);
  };
  std::string text = table.Header() + row(VariantCells(1, FloorCost(layout), layout), 0);
  size_t count = 1;
  for (const v1::RunnerUp& runner_up : layout.runner_ups()) {
    if (!IsComplete(runner_up)) continue;
    text += row(VariantCells(static_cast<int>(count) + 1, runner_up.cost(), runner_up), count);
    ++count;
  }
  return text;
}

v1::SolvedLayout VariantOf(const v1::SolvedLayout& layout, int index) {
  const v1::RunnerUp& runner_up = layout.runner_ups(index);
  v1::SolvedLayout variant;
  *variant.mutable_graph() = layout.graph();
  *variant.mutable_placements() = runner_up.placements();
  *variant.mutable_zone_regions() = runner_up.zone_regions();
  *variant.mutable_edge_outcomes() = runner_up.edge_outcomes();
  *variant.mutable_metrics() = runner_up.metrics();
  *variant.mutable_diagnostics() = runner_up.diagnostics();
  return variant;
}

std::string LayoutRemarks(const v1::SolvedLayout& layout) {
  std::string text;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) {
    text += fmt::format("{:<11}{}\n", "remark", diagnostic.message());
  }
  int dropped = 0;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    if (outcome.status() != v1::OUTCOME_STATUS_DROPPED || ++dropped > kListedDrops) continue;
    text += fmt::format("{:<11}{}: {}\n", "dropped", outcome.edge_id(), outcome.reason());
  }
  if (dropped > kListedDrops) text += fmt::format("{:<11}{} more\n", "dropped", dropped - kListedDrops);
  for (const v1::Contradiction& contradiction : layout.contradictions()) {
    text += fmt::format("{:<11}{}\n", "clash", contradiction.explanation());
  }
  return text;
}

v1::ModelUsage UsageOf(const ArtifactsByKind& artifacts) {
  v1::ModelUsage usage;
  for (const auto& [kind, artifact] : artifacts) orchestrator::AddUsage(artifact, usage);
  return usage;
}

std::string ModelsSection(const v1::Report& report, const ArtifactsByKind& artifacts) {
  const bool asked =
      std::ranges::any_of(artifacts, [](const auto& entry) { return !entry.second.model_calls().empty(); });
  std::vector<std::string> stand_ins, faults;
  for (const v1::Diagnostic& remark : report.diagnostics()) {
    if (remark.code() == "stand_in") stand_ins.push_back(remark.message());
  }
  for (const auto& [kind, artifact] : artifacts) {
    for (const v1::ModelCall& call : artifact.model_calls()) {
      for (const std::string& fault : call.faults()) faults.push_back(call.step() + ": " + fault);
    }
  }
  if (!asked && stand_ins.empty()) return "";
  std::string text = "\n## Models\n\n";
  if (asked) {
    text +=
        StageTable(artifacts) + ListText("Faults in answers, which were corrected, asked again or left out:", faults);
    if (report.model_usage().call_count() != UsageOf(artifacts).call_count()) {
      text += fmt::format("\nMade for this job: {}; the others are reused from an earlier one.\n",
                          report.model_usage().call_count());
    }
  }
  return text + ListText("Without the model:", stand_ins);
}

std::string ModelCallLines(const v1::Artifact& artifact) {
  std::string text;
  for (const v1::ModelCall& call : artifact.model_calls()) {
    text += fmt::format("{:<11}{}: {}, {}", text.empty() ? "asked" : "", call.step(), call.model(),
                        orchestrator::SummarizeUsage(call.usage()));
    if (!call.faults().empty()) text += ", " + Counted(call.faults_size(), "fault");
    text += '\n';
  }
  return text;
}

std::string ModelCallTexts(const v1::Artifact& artifact) {
  std::string text;
  for (const v1::ModelCall& call : artifact.model_calls()) {
    text += fmt::format("{}=== {}: {}, prompts {}, {} tokens asked, {} answered\n", text.empty() ? "" : "\n",
                        call.step(), call.model(), call.prompt_version(), call.usage().input_token_count(),
                        call.usage().output_token_count());
    for (const v1::ModelMessage& message : call.messages()) {
      text += fmt::format("--- {}\n{}\n", message.role(), Printable(message.text()));
    }
    if (call.messages().empty()) {
      text += "(the texts were left out)\n";
    } else {
      text += fmt::format("--- answer\n{}\n", Printable(call.answer()));
    }
    for (const std::string& fault : call.faults()) text += fmt::format("--- fault: {}\n", Printable(fault));
  }
  return text;
}

}  // namespace flair::cli
