// SPDX-License-Identifier: GPL-3.0-or-later
// What a design ends in: its report and its files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/output/output_folder.h"
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

// The folder that a design ends in.

// The file of a job's picture: "plan.png", "birdseye.exr".
std::string PictureName(const v1::Preview& preview);

// The picture of all variants, where a design has several.
inline constexpr char kVariantsPicture[] = "variants.png";

// Every file that it may hold.
std::vector<std::string> DesignFileNames();

// The picture, report.md and each stage's artifact as .pb and .json.
std::vector<OutputFile> MakeDesignFiles(const v1::Job& job, const ArtifactsByKind& artifacts);

}  // namespace flair::cli
