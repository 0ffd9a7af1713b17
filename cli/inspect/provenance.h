// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/input/artifact_shelf.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// One artifact on the way from the brief.
struct ProvenanceStep {
  std::string id;
  std::string place = {};                     // where it was found, "here" for the one that was asked about
  std::optional<v1::Artifact> artifact = {};  // nothing when it was not found
};

// Everything that the artifact goes back to, before what was made from it; the artifact itself is the last. At most
// `most` artifacts are looked at.
std::vector<ProvenanceStep> FindProvenance(const v1::Artifact& artifact, ArtifactFinder& finder, size_t most = 200);

// A list of the steps, two to four lines each; `places` says where what is missing was looked for.
std::string ProvenanceText(const std::vector<ProvenanceStep>& steps, const std::string& places);
// The same as a JSON array.
std::string ProvenanceJson(const std::vector<ProvenanceStep>& steps);
// The way in one line: "brief > room > zones > ...", with what is missing.
std::string ProvenanceLine(const std::vector<ProvenanceStep>& steps);

// Of its kind, as its file is called: "graph"; empty for an artifact that was not found.
std::string NameOf(const ProvenanceStep& step);

// "flair-solver, slsqp, version 1, build 0123"; who edited it, when somebody did.
std::string MakerText(const v1::Artifact& artifact);

}  // namespace flair::cli
