// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/models_text.h"

#include <algorithm>
#include <set>

#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "orchestrator/pipeline/summary.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

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

v1::ModelUsage UsageOf(const ArtifactsByKind& artifacts) {
  v1::ModelUsage usage;
  for (const auto& [kind, artifact] : artifacts) orchestrator::AddUsage(artifact, usage);
  return usage;
}

std::string ModelsSection(const v1::Report& report, const ArtifactsByKind& artifacts) {
  const bool asked = std::any_of(artifacts.begin(), artifacts.end(),
                                 [](const auto& entry) { return !entry.second.model_calls().empty(); });
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
        StageTable(artifacts) + ListText("What was wrong with answers, and mended, asked again or left out:", faults);
    if (report.model_usage().call_count() != UsageOf(artifacts).call_count()) {
      text += fmt::format("\nMade for this job: {}; the others were made for an earlier one and used again.\n",
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
    if (!call.faults().empty()) {
      text += ", " + Counted(call.faults_size(), "fault");
    }
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
