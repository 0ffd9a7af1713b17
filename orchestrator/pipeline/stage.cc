// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage.h"

#include <fmt/format.h>

#include "orchestrator/store/artifact_id.h"

namespace flair::orchestrator {

std::span<const Stage> Stages() {
  using namespace v1;  // Eleven kinds in one table.
  static const std::vector<Stage> stages = {
      {"brief", ARTIFACT_KIND_BRIEF, {}, nullptr, RunBrief},
      {"room", ARTIFACT_KIND_ROOM, {ARTIFACT_KIND_BRIEF}, LanguageOptions, RunRoom},
      {"zones", ARTIFACT_KIND_ZONE_PLAN, {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM}, LanguageOptions, RunZones},
      {"objects",
       ARTIFACT_KIND_OBJECT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN},
       LanguageOptions,
       RunObjects},
      {"style",
       ARTIFACT_KIND_STYLE_SHEET,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST},
       LanguageOptions,
       RunStyle},
      {"constraints",
       ARTIFACT_KIND_RAW_CONSTRAINT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST},
       LanguageOptions,
       RunConstraints},
      {"cleaning",
       ARTIFACT_KIND_CONSTRAINT_LIST,
       {ARTIFACT_KIND_ROOM, ARTIFACT_KIND_OBJECT_LIST, ARTIFACT_KIND_RAW_CONSTRAINT_LIST},
       LanguageOptions,
       RunCleaning},
      {"translation",
       ARTIFACT_KIND_LAYOUT_GRAPH,
       {ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST, ARTIFACT_KIND_STYLE_SHEET,
        ARTIFACT_KIND_CONSTRAINT_LIST},
       TranslationOptions,
       RunTranslation},
      {"solve", ARTIFACT_KIND_SOLVED_LAYOUT, {ARTIFACT_KIND_LAYOUT_GRAPH}, SolverOptions, RunSolve},
      {"render", ARTIFACT_KIND_PREVIEW, {ARTIFACT_KIND_SOLVED_LAYOUT}, RendererOptions, RunRender},
      {"report",
       ARTIFACT_KIND_REPORT,
       {ARTIFACT_KIND_RAW_CONSTRAINT_LIST, ARTIFACT_KIND_SOLVED_LAYOUT, ARTIFACT_KIND_PREVIEW},
       ReportOptions,
       RunReport},
  };
  return stages;
}

const v1::Artifact& Input(const StageRun& run, v1::ArtifactKind kind) {
  for (const v1::Artifact* artifact : run.inputs) {
    if (KindOf(*artifact) == kind) return *artifact;
  }
  return v1::Artifact::default_instance();
}

std::string RequestId(const StageRun& run, std::string_view stage) { return fmt::format("{}/{}", run.job_id, stage); }

}  // namespace flair::orchestrator
