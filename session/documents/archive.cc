// SPDX-License-Identifier: GPL-3.0-or-later
// A document's layout with all that led to it.
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "session/documents/documents.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using cli::OutputFile;
using runtime::CallContext;

// A document of 500 states, and the stages before it.
constexpr size_t kMostArtifacts = 600;

bool IsGone(const absl::Status& status) {
  return absl::IsNotFound(status) || absl::IsDataLoss(status) || absl::IsInvalidArgument(status);
}

// As a design's folder names them; of several of a kind, the later the older: "layout.pb", "layout_2.pb".
void AddFiles(const v1::Artifact& artifact, std::set<std::string>& names, std::vector<OutputFile>& files,
              size_t& left) {
  const std::string stem = cli::FileStem(orchestrator::KindOf(artifact));
  if (stem.empty()) return;
  OutputFile binary{"", cli::ArtifactBytes(artifact)};
  OutputFile json{"", cli::ToJson(artifact)};
  const size_t size = binary.content.size() + json.content.size();
  if (size > left) return;
  left -= size;
  std::string name = stem;
  for (int i = 2; !names.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
  binary.name = name + ".pb";
  json.name = name + ".json";
  files.push_back(std::move(binary));
  files.push_back(std::move(json));
}

}  // namespace

absl::StatusOr<std::vector<OutputFile>> Documents::ArtifactFilesOf(const Layout& shown, size_t most,
                                                                   CallContext& call) {
  // The nearest first.
  std::vector<v1::Artifact> found = {*shown};
  std::set<std::string> seen = {shown->id()};
  size_t bytes = shown->ByteSizeLong();
  for (size_t at = 0; at < found.size(); ++at) {
    const std::vector<std::string> ids(found[at].made_from_ids().begin(), found[at].made_from_ids().end());
    for (const std::string& id : ids) {
      if (found.size() >= kMostArtifacts || !seen.insert(id).second) continue;
      absl::StatusOr<v1::Artifact> artifact = GetArtifact(id, call);
      if (!artifact.ok() && !IsGone(artifact.status())) return artifact.status();
      if (!artifact.ok()) continue;
      bytes += artifact->ByteSizeLong();
      // There will be no room for it: it only leads on.
      if (artifact->has_solved_layout() && bytes > most) artifact->clear_content();
      found.push_back(*std::move(artifact));
    }
  }
  // What is shown and what the stages made; then, as many as there is room for, the layouts in between.
  std::stable_sort(found.begin() + 1, found.end(), [](const v1::Artifact& one, const v1::Artifact& other) {
    return !one.has_solved_layout() && other.has_solved_layout();
  });
  std::vector<OutputFile> files;
  std::set<std::string> names;
  size_t left = most;
  for (const v1::Artifact& artifact : found) AddFiles(artifact, names, files, left);
  return files;
}

}  // namespace flair::session
