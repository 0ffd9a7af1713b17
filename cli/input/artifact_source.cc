// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_shelf.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/session/session.h"
#include "orchestrator/pipeline/stage.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr size_t kFewestDigits = 6;
constexpr size_t kIdDigits = 64;
// "20261121T142826741576-896a12".
constexpr size_t kDateDigits = 8;

bool IsHex(const std::string& text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](char c) { return absl::ascii_isxdigit(static_cast<unsigned char>(c)); });
}

bool LooksLikeJob(const std::string& text) {
  return text.size() > kDateDigits && text[kDateDigits] == 'T' && text.find('-') != std::string::npos &&
         std::all_of(text.begin(), text.begin() + kDateDigits,
                     [](char c) { return absl::ascii_isdigit(static_cast<unsigned char>(c)); });
}

// The artifact with what is wrong with it; one of a store has been found to be whole.
absl::StatusOr<FoundSource> FromShelf(const std::string& source, const std::string& id, ArtifactShelf& shelf) {
  ASSIGN_OR_RETURN(v1::Artifact artifact, shelf.GetArtifact(id));
  FoundSource found;
  found.file.stated_id = artifact.id();
  found.file.whole = CheckArtifactId(artifact, source);
  found.file.good = ListProblems(source, FindProblems(artifact));
  found.file.artifact = std::move(artifact);
  return found;
}

absl::StatusOr<FoundSource> FindByDigits(const std::string& digits, ArtifactShelf& shelf) {
  const std::string prefix = absl::AsciiStrToLower(digits);
  if (prefix.size() == kIdDigits) return FromShelf(digits, prefix, shelf);
  ASSIGN_OR_RETURN(const std::vector<std::string> ids, shelf.FindIds(prefix));
  if (ids.size() == 1) return FromShelf(digits, ids.front(), shelf);
  if (ids.empty()) {
    return NotFound("{}: no such file, and no artifact in {} has an id that begins like this", digits, shelf.name());
  }
  return InvalidArgument("{}: {} artifacts have ids that begin like this: {}; give more digits", digits, ids.size(),
                         ListNames(ids, 5));
}

// The kind that a stage makes, by the stage's name or by that of the file that holds it.
v1::ArtifactKind KindOfStage(const std::string& name) {
  for (const orchestrator::Stage& stage : orchestrator::Stages()) {
    if (stage.name == name || (FileStem(stage.output) == name && !name.empty())) return stage.output;
  }
  return name == "plan" || name == "preview" ? v1::ARTIFACT_KIND_PREVIEW : v1::ARTIFACT_KIND_UNSPECIFIED;
}

absl::StatusOr<FoundSource> FindInJob(const std::string& source, ArtifactShelf& shelf) {
  const size_t slash = source.find('/');
  absl::StatusOr<v1::Job> job = shelf.GetJob(source.substr(0, slash));
  if (absl::IsNotFound(job.status())) {
    return NotFound("{}: no such job in {}; flair jobs lists them", source, shelf.name());
  }
  if (!job.ok()) return job.status();
  if (slash == std::string::npos) {
    FoundSource found;
    found.is_job = true;
    found.job = *std::move(job);
    return found;
  }
  const v1::ArtifactKind kind = KindOfStage(source.substr(slash + 1));
  std::vector<std::string> stages;
  for (const v1::ArtifactRef& ref : job->artifacts()) {
    if (ref.kind() == kind) return FromShelf(source, ref.id(), shelf);
    stages.push_back(StageOf(ref.kind()));
  }
  const std::string has = stages.empty() ? "it has no artifacts yet" : "it has " + ListNames(stages);
  if (kind != v1::ARTIFACT_KIND_UNSPECIFIED) {
    return NotFound("{}: the job has no artifact of that stage; {}", source, has);
  }
  const std::string stage = source.substr(slash + 1);
  return InvalidArgument("{}: \"{}\" is not a stage{}; {}", source, stage, DidYouMean(stage, stages), has);
}

}  // namespace

absl::StatusOr<std::unique_ptr<ArtifactShelf>> OpenShelf(const SourceFlags& flags) {
  if (!flags.orchestrator.empty()) return Session::Open(flags.orchestrator);
  return MakeStoreShelf(flags.store.empty() ? DefaultStorePath() : flags.store);
}

absl::StatusOr<FoundSource> FindSource(const std::string& source, ArtifactShelf& shelf) {
  std::error_code error;
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(source, error));
  if (!is_there && IsHex(source) && source.size() >= kFewestDigits && source.size() <= kIdDigits) {
    return FindByDigits(source, shelf);
  }
  if (!is_there && LooksLikeJob(source)) return FindInJob(source, shelf);
  absl::StatusOr<ArtifactFile> file = ReadArtifactFile(source);
  if (absl::IsNotFound(file.status()) && !is_there && source.find_first_of("/.") == std::string::npos) {
    return NotFound(
        "{}: no such file; nor is it {} or more digits of an artifact's id, or a job as flair jobs lists them", source,
        kFewestDigits);
  }
  if (!file.ok()) return file.status();
  FoundSource found;
  found.file = *std::move(file);
  found.path = source;
  return found;
}

absl::StatusOr<v1::Artifact> OpenArtifact(const std::string& source, const SourceFlags& flags) {
  ASSIGN_OR_RETURN(const std::unique_ptr<ArtifactShelf> shelf, OpenShelf(flags));
  ASSIGN_OR_RETURN(FoundSource found, FindSource(source, *shelf));
  if (found.is_job) {
    std::vector<std::string> stages;
    for (const v1::ArtifactRef& ref : found.job.artifacts()) stages.push_back(StageOf(ref.kind()));
    return InvalidArgument("{0}: a job; which of its artifacts, such as {0}/solve? It has {1}", source,
                           ListNames(stages));
  }
  if (!found.file.whole.ok()) return found.file.whole;
  if (!found.file.good.ok()) return found.file.good;
  return std::move(found.file.artifact);
}

}  // namespace flair::cli
