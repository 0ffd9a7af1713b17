// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/models_text.h"

#include <algorithm>
#include <set>

#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/summary.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

std::string CostText(const v1::ModelUsage& usage) {
  return usage.cost_usd() > 0 ? fmt::format("{:.4f} USD", usage.cost_usd()) : "";
}

std::string TableRow(const std::string& stage, const std::string& models, int repairs, const v1::ModelUsage& usage) {
  return fmt::format("| {} | {} | {} | {} | {}{} | {} | {} |\n", stage, MarkdownCell(models), usage.call_count(),
                     repairs, usage.estimated() ? "about " : "", usage.input_token_count(), usage.output_token_count(),
                     CostText(usage));
}

std::string StageTable(const ArtifactsByKind& artifacts) {
  std::string text =
      "| stage | model | calls | repairs | tokens asked | answered | cost |\n| --- | --- | --- | --- | --- | --- | --- "
      "|\n";
  int all_repairs = 0;
  for (const auto& [kind, artifact] : artifacts) {
    if (artifact.model_calls().empty()) continue;
    std::set<std::string> models;
    for (const v1::ModelCall& call : artifact.model_calls()) models.insert(call.model());
    const int repairs = static_cast<int>(
        std::count_if(artifact.model_calls().begin(), artifact.model_calls().end(), orchestrator::IsRepair));
    v1::ModelUsage usage;
    orchestrator::AddUsage(artifact, usage);
    text += TableRow(KindName(kind), fmt::format("{}", fmt::join(models, ", ")), repairs, usage);
    all_repairs += repairs;
  }
  return text + TableRow("**all**", "", all_repairs, UsageOf(artifacts));
}

std::string FaultList(const ArtifactsByKind& artifacts) {
  std::string text;
  for (const auto& [kind, artifact] : artifacts) {
    for (const v1::ModelCall& call : artifact.model_calls()) {
      for (const std::string& fault : call.faults())
        text += fmt::format("- {}: {}\n", call.step(), MarkdownCell(fault));
    }
  }
  return text.empty() ? "" : "\nWhat was wrong with answers, and mended, asked again or left out:\n\n" + text;
}

std::string StandIns(const v1::Report& report) {
  std::string text;
  for (const v1::Diagnostic& remark : report.diagnostics()) {
    if (remark.code() == "stand_in") text += fmt::format("- {}\n", MarkdownCell(remark.message()));
  }
  return text.empty() ? "" : "\nWithout the model:\n\n" + text;
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
  const std::string stand_ins = StandIns(report);
  if (!asked && stand_ins.empty()) return "";
  std::string text = "\n## Models\n\n";
  if (asked) {
    text += StageTable(artifacts) + FaultList(artifacts);
    if (report.model_usage().call_count() != UsageOf(artifacts).call_count()) {
      text += fmt::format("\nMade for this job: {}; the others were made for an earlier one and used again.\n",
                          report.model_usage().call_count());
    }
  }
  return text + stand_ins;
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
