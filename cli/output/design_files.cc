// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/design_files.h"

#include "cli/output/artifact_text.h"

namespace flair::cli {

std::vector<std::string> DesignFileNames() {
  std::vector<std::string> names = {"plan.png", "birdseye.png", "perspective.png", "report.md"};
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    if (stem.empty()) continue;
    names.push_back(stem + ".pb");
    names.push_back(stem + ".json");
  }
  return names;
}

std::vector<OutputFile> MakeDesignFiles(const v1::Job& job, const ArtifactsByKind& artifacts) {
  std::vector<OutputFile> files;
  for (const auto& [kind, artifact] : artifacts) {
    if (kind == v1::ARTIFACT_KIND_PREVIEW) files.push_back({"plan.png", artifact.preview().image()});
    const std::string stem = FileStem(kind);
    if (stem.empty()) continue;
    files.push_back({stem + ".pb", ArtifactBytes(artifact)});
    files.push_back({stem + ".json", ToJson(artifact)});
  }
  files.push_back({"report.md", WriteReport(job, artifacts)});
  return files;
}

}  // namespace flair::cli
