// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/lent_request.h"
#include "orchestrator/pipeline/stage.h"

namespace flair::orchestrator {
namespace {

// What the optimizer finds in its layout, looking at it as at anybody's; what it said when it solved, when that is all
// it can tell.
absl::StatusOr<v1::EvaluateResponse> Evaluate(const StageRun& run, const v1::SolvedLayout& layout) {
  LentRequest<v1::EvaluateRequest> request;
  request->set_request_id(RequestId(run, "report"));
  request.Lend(&v1::EvaluateRequest::unsafe_arena_set_allocated_layout_graph, layout.graph());
  *request->mutable_placements() = layout.placements();
  *request->mutable_options() = run.spec.solve_options();
  absl::StatusOr<v1::EvaluateResponse> response = run.clients.Evaluate(*request, run.call);
  if (!absl::IsUnimplemented(response.status())) return response;
  v1::EvaluateResponse said;
  *said.mutable_edge_outcomes() = layout.edge_outcomes();
  if (layout.has_metrics()) *said.mutable_metrics() = layout.metrics();
  return said;
}

// Counts outcomes of edges, and sentences without an edge.
v1::ConstraintSummary Summarize(const v1::SolvedLayout& layout, const v1::EvaluateResponse& evaluation) {
  v1::ConstraintSummary summary;
  for (const v1::EdgeOutcome& outcome : evaluation.edge_outcomes()) {
    switch (outcome.status()) {
      case v1::OUTCOME_STATUS_SATISFIED:
        summary.set_satisfied_count(summary.satisfied_count() + 1);
        break;
      case v1::OUTCOME_STATUS_VIOLATED:
        summary.set_violated_count(summary.violated_count() + 1);
        break;
      default:
        summary.set_dropped_count(summary.dropped_count() + 1);
    }
  }
  for (const v1::Sentence& sentence : layout.graph().constraint_list().sentences()) {
    bool translated = false;
    for (const v1::ConstraintEdge& edge : layout.graph().edges()) translated |= edge.sentence_id() == sentence.id();
    if (!translated) summary.set_untranslated_count(summary.untranslated_count() + 1);
  }
  return summary;
}

void AddDiagnostics(const google::protobuf::RepeatedPtrField<v1::Diagnostic>& from, v1::Report& report) {
  report.mutable_diagnostics()->MergeFrom(from);
}

}  // namespace

// A report belongs to one job and is never used for another.
absl::StatusOr<StageOptions> ReportOptions(const StageRun& run) { return StageOptions{run.job_id, nullptr}; }

absl::StatusOr<v1::Artifact> RunReport(const StageRun& run) {
  const v1::SolvedLayout& layout = Input(run, v1::ARTIFACT_KIND_SOLVED_LAYOUT).solved_layout();
  const absl::StatusOr<v1::EvaluateResponse> response = Evaluate(run, layout);
  if (!response.ok()) return response.status();

  v1::Artifact artifact;
  artifact.mutable_producer()->set_program("flair-orchestrator");
  artifact.mutable_producer()->set_method("report");
  artifact.mutable_producer()->set_version("1");
  artifact.mutable_producer()->set_build(run.build);
  v1::Report& report = *artifact.mutable_report();
  report.set_job_id(run.job_id);
  if (response->has_metrics()) *report.mutable_metrics() = response->metrics();
  *report.mutable_constraints() = Summarize(layout, *response);
  report.mutable_stage_timings()->Assign(run.timings.begin(), run.timings.end());
  if (run.model_usage.call_count() > 0) *report.mutable_model_usage() = run.model_usage;
  const v1::LayoutGraph& graph = layout.graph();
  AddDiagnostics(graph.room().diagnostics(), report);
  AddDiagnostics(graph.zone_plan().diagnostics(), report);
  AddDiagnostics(graph.object_list().diagnostics(), report);
  AddDiagnostics(graph.style_sheet().diagnostics(), report);
  AddDiagnostics(Input(run, v1::ARTIFACT_KIND_RAW_CONSTRAINT_LIST).raw_constraint_list().diagnostics(), report);
  AddDiagnostics(graph.constraint_list().diagnostics(), report);
  AddDiagnostics(graph.diagnostics(), report);
  AddDiagnostics(layout.diagnostics(), report);
  return artifact;
}

}  // namespace flair::orchestrator
