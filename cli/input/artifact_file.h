// SPDX-License-Identifier: GPL-3.0-or-later
// Artifacts as files: binary as Flair writes them, or JSON and protobuf text, which people may change; and the files
// that stand for a brief, a room or a layout.
#pragma once

#include <google/protobuf/message.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/room.pb.h"
#include "room/validation/field.h"

namespace flair::cli {

// An artifact whose file could be read, good or not.
struct ArtifactFile {
  // As it is to be used: its id is the digest of its bytes unless `whole` says that it is not.
  v1::Artifact artifact;
  // Whether it was changed outside of Flair (MarkEdited).
  bool edited = false;
  // The id that the file states; empty when it states none.
  std::string stated_id;
  // DATA_LOSS when a binary file's bytes do not have the id that it states.
  absl::Status whole;
  // INVALID_ARGUMENT with what is wrong with its content, a line each: "graph.json:41: layout_graph.edges[3].weight:
  // ...".
  absl::Status good;
};

// Refuses what is no artifact: other kinds of files, cut off and damaged ones (DATA_LOSS), text with faults and
// artifacts of a newer Flair (INVALID_ARGUMENT); otherwise as ReadFile.
absl::StatusOr<ArtifactFile> ReadArtifactFile(const std::filesystem::path& path);
// The same of the file's bytes.
absl::StatusOr<ArtifactFile> ParseArtifactFile(const std::filesystem::path& path, const std::string& bytes);

// A whole and good one, see ArtifactFile.
absl::StatusOr<v1::Artifact> ReadArtifact(const std::filesystem::path& path);

// DATA_LOSS when the artifact's id is not the digest of its bytes.
absl::Status CheckArtifactId(const v1::Artifact& artifact, const std::filesystem::path& path);

// Makes of an artifact that was changed outside of Flair one of its own: made from the one that it was and from what
// that was made from, by "flair", method "edited by hand", version "of " and who made it before the change; with a new
// id.
void MarkEdited(v1::Artifact& artifact);

// Whether it is one of MarkEdited.
bool IsEdited(const v1::Artifact& artifact);

// Reads a file that holds a whole and good artifact, or a message of another type by itself: fills the one or the other
// and returns whether it was the artifact. The message by itself is checked with `problems` once it is filled. Errors
// as ReadArtifact, about what the file seems to hold.
absl::StatusOr<bool> ReadArtifactOr(const std::filesystem::path& path, v1::Artifact& artifact,
                                    google::protobuf::Message& alone,
                                    const std::function<std::vector<validation::Problem>()>& problems);

// A whole brief, with the user's own room, zones, objects or constraints where it brings them: the artifact of an
// earlier design (.pb or .json), or a Brief as JSON or as protobuf text. INVALID_ARGUMENT names `flag`, the path, the
// place and what would be right; NOT_FOUND and FAILED_PRECONDITION as ReadFile. A Brief may leave out its text.
absl::StatusOr<v1::Brief> ReadBrief(const std::string& flag, const std::string& path);

// A stored layout and, where its folder still holds all that it was made from, the brief it goes back to.
struct LayoutFile {
  v1::Artifact artifact;  // with a solved_layout
  std::optional<v1::Brief> brief;
};

// As ReadArtifact; INVALID_ARGUMENT when it holds no layout. A brief that lies beside it is only taken when the ids
// lead to it.
absl::StatusOr<LayoutFile> ReadLayoutFile(const std::filesystem::path& path);

// Writes where a picture or scene comes from into a RenderRequest or ExportSceneRequest, as the pipeline does: the same
// layout gives the same bytes wherever it is drawn.
template <typename Request>
void SetOrigin(const LayoutFile& file, Request& request) {
  *request.mutable_solved_layout() = file.artifact.solved_layout();
  request.set_job_id(file.artifact.id());
  if (!file.brief) return;
  request.set_brief_text(file.brief->text());
  request.set_brief_seed(file.brief->seed());
}

// Artifacts as bytes: what a file holds, and the binary form.

enum class ArtifactForm { kBinary, kJson, kProtobufText };

// How a message is written, by the ending of its file's name (.json; .textproto, .txtpb, .pbtxt) or else by its bytes.
// What begins as Flair's binary artifacts do is one, whatever its name.
ArtifactForm FormOf(const std::filesystem::path& path, std::string_view bytes);

// What the bytes are when they are some well-known other kind of file: "a PNG picture", "a program"; empty otherwise.
std::string ForeignKind(std::string_view bytes);

// The id with which a binary artifact begins; empty when it begins otherwise.
std::string_view LeadingId(std::string_view bytes);

// Bytes before the rest of a binary artifact that begins with an id.
inline constexpr size_t kLeadingIdBytes = 66;

// The artifact in its binary form, with the id as it states it. DATA_LOSS, "NAME: ...", for bytes that are cut off,
// damaged or none of an artifact; INVALID_ARGUMENT for whole artifacts with parts that only a newer Flair knows.
absl::StatusOr<v1::Artifact> ParseBinaryArtifact(const std::string& name, const std::string& bytes);

// Whether the artifact that was read from these bytes has the id of its bytes.
bool IsWhole(const v1::Artifact& artifact, const std::string& bytes);

// A user's own room, and what it may leave out (docs/rooms.md).

// A room: an artifact that holds one (also a layout's or graph's), or a Room message itself, completed, in any of their
// forms. Errors as ReadArtifact.
absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path);

// Fills in what a hand-written room leaves out and brings it into the form that the protocol asks for:
//   - height_m 0: 3 m;
//   - no walls: the sides of an upright rectangle are named south, east, north and west, those of any other floor
//     wall_1, wall_2, ... in the order in which the corners were given;
//   - a door without leaf opens inward, hinged at its start, by 90 degrees; an opening without id or head height gets
//     one;
//   - corners listed clockwise are turned round, with walls, offsets and hinges, so that everything stays in its place;
//   - the floor is moved so that its bounding box begins at (0, 0).
// Leaves everything else, faults included, as it is.
void CompleteRoom(v1::Room& room);

}  // namespace flair::cli
