// SPDX-License-Identifier: GPL-3.0-or-later
// How a job ended, and what came of it.
#pragma once

#include "absl/status/statusor.h"
#include "cli/output/report_text.h"
#include "cli/progress/progress.h"
#include "cli/session/session.h"

namespace flair::cli {

// What a failed job ends the program with. A model's failures have an exit code of their own.
absl::Status ErrorOf(const v1::Job& job);

// Shows `progress` what happens until the job ends; OK when it succeeded.
absl::Status WaitForJob(Session& session, const std::string& id, Progress& progress);

// The artifacts that a job has stored so far. DATA_LOSS when one is not what it was.
absl::StatusOr<ArtifactsByKind> StoredArtifacts(Session& session, const v1::Job& job);

// The same of a job that succeeded, with a layout and a picture.
absl::StatusOr<ArtifactsByKind> CollectArtifacts(Session& session, const v1::Job& job);

}  // namespace flair::cli
