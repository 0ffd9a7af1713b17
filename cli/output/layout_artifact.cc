// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/layout_artifact.h"

#include "cli/output/artifact_text.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

std::string Finish(v1::Artifact artifact) {
  artifact.mutable_producer()->set_program("flair");
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  return ArtifactBytes(artifact);
}

}  // namespace

std::string LayoutArtifactBytes(const v1::SolvedLayout& layout, const std::string& made_from_id) {
  v1::Artifact artifact;
  if (!made_from_id.empty()) artifact.add_made_from_ids(made_from_id);
  *artifact.mutable_solved_layout() = layout;
  return Finish(std::move(artifact));
}

std::string GraphArtifactBytes(const v1::LayoutGraph& graph) {
  v1::Artifact artifact;
  *artifact.mutable_layout_graph() = graph;
  return Finish(std::move(artifact));
}

}  // namespace flair::cli
