// SPDX-License-Identifier: GPL-3.0-or-later
// Where artifacts are kept: a store, an orchestrator, the folder of a file.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/artifact_file.h"
#include "cli/input/options.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// Jobs and their artifacts, wherever they are kept.
class ArtifactShelf {
 public:
  virtual ~ArtifactShelf() = default;

  // NOT_FOUND when it is not kept here; DATA_LOSS when it is damaged.
  virtual absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) = 0;
  // Ids that begin so, sorted; `prefix` has at least two digits.
  virtual absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) = 0;
  // NOT_FOUND when there is no such job.
  virtual absl::StatusOr<v1::Job> GetJob(const std::string& id) = 0;
  // For messages: "the store " and its folder, or "the orchestrator at " and its address.
  virtual std::string name() const = 0;
};

// A job store's folder, read directly: nothing is started, and where there is none none is made.
std::unique_ptr<ArtifactShelf> MakeStoreShelf(const std::string& folder);

// Finds what an artifact was made from: in the folder of its file, then on a shelf. Only what has the id of its bytes
// counts. Of a folder's .pb files the first bytes are read; its JSON and protobuf text files, which may be edited ones,
// only when everything else fails, and no more than two megabytes of them.
class ArtifactFinder {
 public:
  // `path` of the artifact's file, empty when it has none; `shelf` must outlive the finder.
  ArtifactFinder(std::string path, ArtifactShelf& shelf) : path_(std::move(path)), shelf_(shelf) {}

  struct Found {
    v1::Artifact artifact;
    std::string place;  // "graph.pb", "the store ..."
  };
  std::optional<Found> Find(const std::string& id);

  // Name of the .pb file beside the artifact's that says to have the id; empty when none does.
  std::string FileBeside(const std::string& id);

  // "neither beside out/graph.pb nor in the store ...".
  std::string SearchedPlaces() const;

 private:
  void ListFolder();
  std::optional<Found> FindInTexts(const std::string& id);

  const std::string path_;
  ArtifactShelf& shelf_;
  bool listed_ = false;
  std::map<std::string, std::string> binary_files_;     // paths by stated id
  std::optional<std::map<std::string, Found>> edited_;  // by id, once they have been read
};

// Artifacts as people name them: FILE, DIGEST or JOB/STAGE. For every command that reads one.

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
