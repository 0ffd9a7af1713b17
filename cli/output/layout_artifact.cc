// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/layout_artifact.h"

#include "cli/output/artifact_text.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

std::string Finish(v1::Artifact artifact, const std::string& command, const std::string& build) {
  v1::Producer& producer = *artifact.mutable_producer();
  producer.set_program("flair");
  producer.set_method(command);
  producer.set_version("1");
  producer.set_build(build);
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  return ArtifactBytes(artifact);
}

}  // namespace

std::string LayoutArtifactBytes(const v1::SolvedLayout& layout, const std::string& command, const std::string& build) {
  v1::Artifact artifact;
  *artifact.mutable_solved_layout() = layout;
  return Finish(std::move(artifact), command, build);
}

std::string GraphArtifactBytes(const v1::LayoutGraph& graph, const std::string& command, const std::string& build) {
  v1::Artifact artifact;
  *artifact.mutable_layout_graph() = graph;
  return Finish(std::move(artifact), command, build);
}

}  // namespace flair::cli
