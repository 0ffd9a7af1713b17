// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/layout_file.h"

#include <deque>
#include <map>
#include <set>
#include <string>

#include "cli/input/artifact_file.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// What a folder holds, by id, with the artifacts that are not what they say left out.
std::map<std::string, v1::Artifact> Beside(const std::filesystem::path& folder) {
  std::map<std::string, v1::Artifact> artifacts;
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    std::error_code error;
    const std::filesystem::path path = folder / (stem + ".pb");
    if (stem.empty() || !std::filesystem::is_regular_file(path, error)) continue;
    absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path);
    if (artifact.ok()) artifacts[artifact->id()] = *std::move(artifact);
  }
  return artifacts;
}

std::optional<v1::Brief> BriefOf(const v1::Artifact& layout, const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(folder / "brief.pb", error)) return std::nullopt;
  const std::map<std::string, v1::Artifact> artifacts = Beside(folder);
  std::set<std::string> seen;
  std::deque<std::string> ids(layout.made_from_ids().begin(), layout.made_from_ids().end());
  for (; !ids.empty(); ids.pop_front()) {
    const auto found = artifacts.find(ids.front());
    if (found == artifacts.end() || !seen.insert(ids.front()).second) continue;
    if (found->second.has_brief()) return found->second.brief();
    ids.insert(ids.end(), found->second.made_from_ids().begin(), found->second.made_from_ids().end());
  }
  return std::nullopt;
}

}  // namespace

absl::StatusOr<LayoutFile> ReadLayoutFile(const std::filesystem::path& path) {
  absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path);
  if (!artifact.ok()) return artifact.status();
  if (!artifact->has_solved_layout()) {
    return absl::InvalidArgumentError(fmt::format("{}: not a layout; give the layout.pb of a design", path.string()));
  }
  LayoutFile file{.artifact = *std::move(artifact), .brief = {}};
  file.brief = BriefOf(file.artifact, path.parent_path());
  return file;
}

}  // namespace flair::cli
