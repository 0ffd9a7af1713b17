// SPDX-License-Identifier: GPL-3.0-or-later
// Artifacts as bytes and as text; the same artifact gives the same bytes.
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// Deterministic binary form, with the id.
std::string ArtifactBytes(const v1::Artifact& artifact);
// Proto JSON with the field names of the .proto files, indented, ending in a newline.
std::string ToJson(const google::protobuf::Message& message);
// The same on one line, without the newline.
std::string ToJsonLine(const google::protobuf::Message& message);
// Protobuf text format.
std::string ToText(const google::protobuf::Message& message);

// File name without extension: "zones", "layout"; empty for kinds that the output folder does not hold.
std::string FileStem(v1::ArtifactKind kind);
// The stage that makes artifacts of a kind, see JobEvent.stage, such as "solve"; empty for none.
std::string StageOf(v1::ArtifactKind kind);
// Kind for people, such as "zone plan".
std::string KindName(v1::ArtifactKind kind);

}  // namespace flair::cli
