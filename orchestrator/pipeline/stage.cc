// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage.h"

#include <fmt/format.h>

#include "orchestrator/store/artifact_id.h"

namespace flair::orchestrator {

std::span<const Stage> Stages() {
  using namespace v1;  // Their kinds in one table.
  static const std::vector<Stage> stages = {
      {"brief", ARTIFACT_KIND_BRIEF, {}, AskedBrief, nullptr, RunBrief},
      {"room", ARTIFACT_KIND_ROOM, {ARTIFACT_KIND_BRIEF}, AskedOfModels, nullptr, RunRoom},
      {"zones", ARTIFACT_KIND_ZONE_PLAN, {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM}, AskedOfModels, nullptr, RunZones},
      {"objects",
       ARTIFACT_KIND_OBJECT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN},
       AskedOfModels,
       nullptr,
       RunObjects},
      {"style",
       ARTIFACT_KIND_STYLE_SHEET,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST},
       AskedOfModels,
       nullptr,
       RunStyle},
      {"constraints",
       ARTIFACT_KIND_RAW_CONSTRAINT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST},
       AskedOfModels,
       nullptr,
       RunConstraints},
      {"cleaning",
       ARTIFACT_KIND_CONSTRAINT_LIST,
       {ARTIFACT_KIND_ROOM, ARTIFACT_KIND_OBJECT_LIST, ARTIFACT_KIND_RAW_CONSTRAINT_LIST},
       AskedOfModels,
       nullptr,
       RunCleaning},
      {"translation",
       ARTIFACT_KIND_LAYOUT_GRAPH,
       {ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST, ARTIFACT_KIND_STYLE_SHEET,
        ARTIFACT_KIND_CONSTRAINT_LIST},
       AskedOfModels,
       TranslationOptions,
       RunTranslation},
      {"solve", ARTIFACT_KIND_SOLVED_LAYOUT, {ARTIFACT_KIND_LAYOUT_GRAPH}, AskedOfSolver, nullptr, RunSolve},
      {"render", ARTIFACT_KIND_PREVIEW, {ARTIFACT_KIND_SOLVED_LAYOUT}, AskedOfRenderer, nullptr, RunRender},
      {"report",
       ARTIFACT_KIND_REPORT,
       {ARTIFACT_KIND_RAW_CONSTRAINT_LIST, ARTIFACT_KIND_SOLVED_LAYOUT, ARTIFACT_KIND_PREVIEW},
       nullptr,
       ReportOptions,
       RunReport},
      FurtherViewStage(0),
      FurtherViewStage(1),
      FurtherViewStage(2),
      FurtherViewStage(3),
  };
  return stages;
}

int StageIndex(std::string_view name) {
  const std::span<const Stage> stages = Stages();
  for (size_t i = 0; i < stages.size(); ++i) {
    if (stages[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

std::string StageNames() {
  std::string names;
  for (const Stage& stage : Stages()) names += (names.empty() ? "" : ", ") + std::string(stage.name);
  return names;
}

const v1::Artifact& Input(const StageRun& run, v1::ArtifactKind kind) {
  for (const v1::Artifact* artifact : run.inputs) {
    if (KindOf(*artifact) == kind) return *artifact;
  }
  return v1::Artifact::default_instance();
}

std::string RequestId(const StageRun& run, std::string_view stage) { return fmt::format("{}/{}", run.job_id, stage); }

}  // namespace flair::orchestrator
