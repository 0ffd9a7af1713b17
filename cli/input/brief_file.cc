// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/brief_file.h"

#include "cli/input/artifact_or.h"
#include "fmt/format.h"
#include "room/validation/validate.h"

namespace flair::cli {

namespace {

constexpr char kExample[] = "a Brief, such as: text: \"A bedroom.\" object_list { objects { id: \"bed\" ... } }";

// A brief whose text is said elsewhere may be without one.
std::vector<validation::Problem> ProblemsBesidesText(v1::Brief brief) {
  if (brief.text().empty()) brief.set_text("A room.");
  return FindProblems(brief);
}

}  // namespace

absl::StatusOr<v1::Brief> ReadBrief(const std::string& flag, const std::string& path) {
  v1::Artifact artifact;
  v1::Brief brief;
  const absl::StatusOr<bool> is_artifact =
      ReadArtifactOr(path, artifact, brief, [&brief] { return ProblemsBesidesText(brief); });
  if (!is_artifact.ok()) {
    const absl::Status& status = is_artifact.status();
    const std::string advice = absl::IsInvalidArgument(status) ? fmt::format("; should hold {}", kExample) : "";
    return absl::Status(status.code(), fmt::format("{}: {}{}", flag, std::string(status.message()), advice));
  }
  if (!*is_artifact) return brief;
  if (artifact.has_brief()) return artifact.brief();
  return absl::InvalidArgumentError(fmt::format(
      "{}: {}: an artifact without a brief; should be brief.pb or brief.json of a design, or a Brief", flag, path));
}

}  // namespace flair::cli
