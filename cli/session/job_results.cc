// SPDX-License-Identifier: GPL-3.0-or-later
// How a job ended, and what it made.
#include <algorithm>
#include <array>
#include <string_view>

#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/output/artifact_text.h"
#include "cli/session/session.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

absl::Status ErrorOf(const v1::Job& job) {
  constexpr std::array<std::string_view, 7> kModelStages = {"room",        "zones",    "objects",    "style",
                                                            "constraints", "cleaning", "translation"};
  const auto code = static_cast<absl::StatusCode>(job.error_code());
  // Neither artifacts that are taken from an earlier job nor what the store holds are a model's answers.
  const bool taken = job.failure_kind() == v1::FAILURE_KIND_STORE ||
                     (job.spec().has_replay() &&
                      orchestrator::StageIndex(job.stage()) < orchestrator::FirstStageOf(job.spec().replay()));
  const bool of_model = code == absl::StatusCode::kDataLoss || code == absl::StatusCode::kFailedPrecondition ||
                        code == absl::StatusCode::kPermissionDenied;
  if (of_model && !taken && std::ranges::find(kModelStages, job.stage()) != kModelStages.end())
    return ModelError(job.error());
  return absl::Status(code, job.error());
}

absl::Status WaitForJob(Session& session, const std::string& id, Progress& progress) {
  RETURN_IF_ERROR(session.Watch(id, [&](const v1::JobEvent& event) { progress.See(event); }));
  ASSIGN_OR_RETURN(const v1::Job job, session.GetJob(id));
  switch (job.state()) {
    case v1::JOB_STATE_SUCCEEDED:
      return absl::OkStatus();
    case v1::JOB_STATE_CANCELLED:
      return absl::CancelledError(fmt::format("job {} was cancelled", id));
    case v1::JOB_STATE_FAILED:
      return ErrorOf(job);
    default:
      return Internal("job {} has not ended; see: flair jobs show {}", id, id);
  }
}

absl::StatusOr<ArtifactsByKind> StoredArtifacts(Session& session, const v1::Job& job) {
  ArtifactsByKind artifacts;
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    ASSIGN_OR_RETURN(v1::Artifact artifact, session.GetArtifact(ref.id()));
    RETURN_IF_ERROR(CheckArtifactId(artifact, "artifact " + ref.id()));
    // The first of its kind: further views come after the preview.
    artifacts.try_emplace(ref.kind(), std::move(artifact));
  }
  return artifacts;
}

absl::StatusOr<ArtifactsByKind> CollectArtifacts(Session& session, const v1::Job& job) {
  ASSIGN_OR_RETURN(ArtifactsByKind artifacts, StoredArtifacts(session, job));
  for (const v1::ArtifactKind kind : {v1::ARTIFACT_KIND_SOLVED_LAYOUT, v1::ARTIFACT_KIND_PREVIEW}) {
    if (!artifacts.contains(kind)) return Internal("job {} succeeded without a {}", job.id(), KindName(kind));
  }
  return artifacts;
}

}  // namespace flair::cli
