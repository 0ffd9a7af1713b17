// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cli/input/artifact_shelf.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// One artifact on the way from the brief.
struct ProvenanceStep {
  std::string id;
  std::string name;   // of its kind, as its file is called: "graph"; empty for one that was not found
  std::string place;  // where it was found, "here" for the one that was asked about; empty for one that was not found
  std::string stage;  // that makes such artifacts: "translation"
  std::vector<std::string> made_from_ids;
  v1::Producer producer;
  std::string options_digest;
  bool edited = false;
  // Of a brief: what was asked and with which seed. Of a layout: the seeds of its solve.
  std::string text;
  std::vector<int64_t> seeds;
  std::set<std::string> models;           // that were asked for it
  std::set<std::string> prompt_versions;  // of the questions
  int model_call_count = 0;
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

}  // namespace flair::cli
