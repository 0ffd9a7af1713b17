// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"

namespace flair::cli {

// A whole brief, with the user's own room, zones, objects or constraints where it brings them: the artifact of an
// earlier design (.pb or .json), or a Brief as JSON or as protobuf text. INVALID_ARGUMENT names `flag`, the path, the
// place and what would be right; NOT_FOUND and FAILED_PRECONDITION as ReadFile. A Brief may leave out its text.
absl::StatusOr<v1::Brief> ReadBrief(const std::string& flag, const std::string& path);

}  // namespace flair::cli
