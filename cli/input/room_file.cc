// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/room_file.h"

#include "cli/input/artifact_or.h"
#include "fmt/format.h"
#include "room/validation/validate.h"

namespace flair::cli {

absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path) {
  v1::Artifact artifact;
  v1::Room room;
  const absl::StatusOr<bool> is_artifact = ReadArtifactOr(path, artifact, room, [&room] { return FindProblems(room); });
  if (!is_artifact.ok()) return is_artifact.status();
  if (!*is_artifact) return room;
  switch (artifact.content_case()) {
    case v1::Artifact::kRoom:
      return artifact.room();
    case v1::Artifact::kLayoutGraph:
      return artifact.layout_graph().room();
    case v1::Artifact::kSolvedLayout:
      return artifact.solved_layout().graph().room();
    default:
      return absl::InvalidArgumentError(
          fmt::format("{}: an artifact without a room; should be room.pb or room.json of a design", path.string()));
  }
}

}  // namespace flair::cli
