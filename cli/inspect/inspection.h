// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/input/artifact_file.h"
#include "cli/input/artifact_shelf.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// An artifact for people: what it is, whether it is whole and good, who made it from what, and its content. `name` is
// how the user called it.
std::string InspectionText(const std::string& name, const ArtifactFile& file, ArtifactFinder& finder, size_t most_rows);

// A job: its state, and its artifacts, a line each.
std::string JobText(const v1::Job& job, ArtifactShelf& shelf);

}  // namespace flair::cli
