// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// What of a job's results is kept: words with commas between, see docs/batches.md.
class KeptFiles {
 public:
  static constexpr char kDefault[] = "layout,pictures,report";

  // INVALID_ARGUMENT names the word and says which there are.
  static absl::StatusOr<KeptFiles> Parse(const std::string& words);
  // The same set in one form, whatever the order of the words was.
  std::string Words() const;

  // Whether anything of such an artifact is kept.
  bool Needs(v1::ArtifactKind kind) const;
  bool empty() const { return words_.empty(); }

  // The files that are kept of a job's artifacts, which are in stage order; and job.json, unless nothing is kept.
  std::vector<OutputFile> FilesOf(const v1::Job& job, const std::vector<v1::Artifact>& artifacts) const;

 private:
  bool Has(const std::string& word) const { return words_.contains(word); }
  void AddPicture(const v1::Preview& preview, std::vector<OutputFile>& files) const;

  std::set<std::string> words_;
};

}  // namespace flair::cli
