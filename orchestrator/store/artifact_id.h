// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::orchestrator {

// The id that belongs to the artifact's content and origin: SHA-256 of its canonical bytes with `id` empty.
std::string ComputeArtifactId(v1::Artifact artifact);

// An artifact as it is stored.
struct SealedArtifact {
  v1::ArtifactRef ref;
  // Canonical.
  std::string bytes;
};

// Gives the artifact its id and serializes it: ComputeArtifactId without doing anything twice.
SealedArtifact SealArtifact(v1::Artifact& artifact);

// True when these are the canonical bytes of the artifact with that id.
bool AreBytesOf(std::string_view bytes, std::string_view id);

// The artifact of stored bytes. DATA_LOSS, naming `place`, when they are not those of the artifact with that id.
absl::StatusOr<v1::Artifact> ParseArtifact(const std::string& bytes, std::string_view id, std::string_view place);

// Which content it has; UNSPECIFIED when it has none.
v1::ArtifactKind KindOf(const v1::Artifact& artifact);

// True for 64 characters 0-9 and a-f: an id that can be a file name.
bool IsArtifactId(std::string_view id);

// The brief that all of a job is made from: as it was asked for, without white space around it.
v1::Brief BriefOf(const v1::JobSpec& spec);

// Key of the index for re-use: the stage, what makes it (see StageClients::Revision), its options and its inputs. With
// `job_id`, a key that no other job finds.
std::string ResultKey(std::string_view stage, std::string_view revision, std::string_view options_digest,
                      const std::vector<std::string>& input_ids, std::string_view job_id = "");

}  // namespace flair::orchestrator
