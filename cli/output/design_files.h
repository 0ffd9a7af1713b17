// SPDX-License-Identifier: GPL-3.0-or-later
// The folder that a design ends in.
#pragma once

#include <string>
#include <vector>

#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"

namespace flair::cli {

// The file of a job's picture: "plan.png", "birdseye.exr".
std::string PictureName(const v1::Preview& preview);

// Every file that it may hold.
std::vector<std::string> DesignFileNames();

// The picture, report.md and each stage's artifact as .pb and .json.
std::vector<OutputFile> MakeDesignFiles(const v1::Job& job, const ArtifactsByKind& artifacts);

}  // namespace flair::cli
