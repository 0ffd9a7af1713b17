// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/artifact_file.h"
#include "cli/input/artifact_shelf.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

// An artifact for people: what it is, whether it is whole and good, who made it from what, and its content. `name` is
// how the user called it.
std::string InspectionText(const std::string& name, const ArtifactFile& file, ArtifactFinder& finder, size_t most_rows);

// "20260521T134501123456-3fa2c1 from solve"; empty when the job is no replay.
std::string ReplayText(const v1::Job& job);
// What was asked for and how far it came, a line each.
std::string JobLines(const v1::Job& job);
// With its artifacts, a line each.
std::string JobText(const v1::Job& job, ArtifactShelf& shelf);

// Every kind of content as a readable summary: what cli/output/message_view.h makes of it, with what belongs together
// side by side.

// Rows of a table before it says how many more there are.
inline constexpr size_t kMostRows = 100;

std::string RoomText(const v1::Room& room, size_t most_rows = kMostRows);
// Equal pieces share a row that counts them.
std::string ObjectsText(const v1::ObjectList& list, size_t most_rows = kMostRows);
// Sentences, after what cleaning did to `raw`: with the words before and after where `raw` is known.
std::string CleanedText(const v1::ConstraintList& list, const v1::ConstraintList* raw, size_t most_rows = kMostRows);
// Sentences with their calls.
std::string GraphText(const v1::LayoutGraph& graph, size_t most_rows = kMostRows);
// Objects with their poses and verdicts, what costs most, what was dropped and why, and measures.
std::string LayoutText(const v1::SolvedLayout& layout, size_t most_rows = kMostRows);

// What is in the artifact. `raw` is the list before cleaning of a cleaned one; null where it is not known.
std::string ContentText(const v1::Artifact& artifact, const v1::ConstraintList* raw, size_t most_rows = kMostRows);

// What a solve did and found: measures, terms, what does not hold and why, and each stage with its time.
std::string SolveStats(const v1::SolveResponse& response);

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

// A part of a message. Valid as long as the message.
struct FieldView {
  const google::protobuf::Message* parent = nullptr;
  const google::protobuf::FieldDescriptor* field = nullptr;
  int index = -1;  // of a list's item; -1 for a whole field
};

// The part that a path names, such as solved_layout.placements[3].theta_rad. Items of lists are named by number, from 0
// on, or by id: objects[desk]. What begins with a field of the artifact's content may leave out the content's name.
// INVALID_ARGUMENT names the part of the path that is wrong and what exists there.
absl::StatusOr<FieldView> FindField(const google::protobuf::Message& message, const std::string& path);

enum class FieldFormat { kText, kJson };

// The part as text: a number, a word, a message as protobuf text, a list with an item a line (messages: one after the
// other, with an empty line between); or all of it as JSON. Bytes are as they are as text, base64 in JSON.
std::string FieldText(const FieldView& view, FieldFormat format);

}  // namespace flair::cli
