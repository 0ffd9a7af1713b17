// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// The artifacts of one job by kind.
using ArtifactsByKind = std::map<v1::ArtifactKind, v1::Artifact>;

// report.md: what stands in the room and why, what holds, what was left out, measures and times. For people.
std::string WriteReport(const v1::Job& job, const ArtifactsByKind& artifacts);

}  // namespace flair::cli
