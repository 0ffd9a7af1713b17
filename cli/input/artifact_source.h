// SPDX-License-Identifier: GPL-3.0-or-later
// Artifacts as people name them: FILE, DIGEST or JOB/STAGE. For every command that reads one.
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cli/input/artifact_file.h"
#include "cli/input/artifact_shelf.h"
#include "cli/input/options.h"

namespace flair::cli {

// Where what is no file is looked up.
struct SourceFlags : Options {
  using Options::Options;
  std::string& store = Text("--store DIR", "Look up ids and jobs in this store (that of flair jobs)");
  std::string& orchestrator = Text("--orchestrator HOST:PORT", "Look them up at this orchestrator", {"--store"});
};

// For the help of an argument that names an artifact.
inline constexpr char kSourceHelp[] = "a file (.pb, .json or .textproto), 6 or more digits of its id, or JOB/STAGE";

// INVALID_ARGUMENT for an address that is none.
absl::StatusOr<std::unique_ptr<ArtifactShelf>> OpenShelf(const SourceFlags& flags);

// What was found: an artifact with what is wrong with it, or a job.
struct FoundSource {
  ArtifactFile file;
  std::string path;  // of the file; empty for one of the shelf
  bool is_job = false;
  v1::Job job;
};

// A file that is there goes first; else digits of an id, of which only one artifact may begin so; else the job, or its
// artifact of that stage (named as in `flair jobs artifacts`, JobEvent.stage, or as its file: "solve" or "layout").
// NOT_FOUND and INVALID_ARGUMENT say what there is instead; otherwise as ReadArtifactFile.
absl::StatusOr<FoundSource> FindSource(const std::string& source, ArtifactShelf& shelf);

// The artifact, whole and good; INVALID_ARGUMENT for a job without stage.
absl::StatusOr<v1::Artifact> OpenArtifact(const std::string& source, const SourceFlags& flags);

}  // namespace flair::cli
