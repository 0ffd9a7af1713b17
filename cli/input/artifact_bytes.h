// SPDX-License-Identifier: GPL-3.0-or-later
// Artifacts as bytes: what a file holds, and the binary form.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

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

}  // namespace flair::cli
