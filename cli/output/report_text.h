// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// The artifacts of one job by kind.
using ArtifactsByKind = std::map<v1::ArtifactKind, v1::Artifact>;

// What of the brief was done otherwise or not at all, one sentence each: what was not understood, what was left out,
// and places that the layout does not keep. In report.md and on the terminal.
std::vector<std::string> NotAsAsked(const v1::SolvedLayout& layout);

// report.md: what is not as asked, what stands in the room and why, what holds, measures and times. For people.
std::string WriteReport(const v1::Job& job, const ArtifactsByKind& artifacts);

}  // namespace flair::cli
