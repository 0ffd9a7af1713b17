// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/brief.pb.h"

namespace flair::cli {

// A stored layout and, where its folder still holds all that it was made from, the brief it goes back to.
struct LayoutFile {
  v1::Artifact artifact;  // with a solved_layout
  std::optional<v1::Brief> brief;
};

// As ReadArtifact; INVALID_ARGUMENT when it holds no layout. A brief that lies beside it is only taken when the ids
// lead to it.
absl::StatusOr<LayoutFile> ReadLayoutFile(const std::filesystem::path& path);

// Writes where a picture or scene comes from into a RenderRequest or ExportSceneRequest, as the pipeline does: the same
// layout gives the same bytes wherever it is drawn.
template <typename Request>
void SetOrigin(const LayoutFile& file, Request& request) {
  *request.mutable_solved_layout() = file.artifact.solved_layout();
  request.set_job_id(file.artifact.id());
  if (!file.brief) return;
  request.set_brief_text(file.brief->text());
  request.set_brief_seed(file.brief->seed());
}

}  // namespace flair::cli
