// SPDX-License-Identifier: GPL-3.0-or-later
// What language models were asked, for people.
#pragma once

#include <string>

#include "cli/output/report_text.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// What they consumed in all artifacts of a job, also in those that are used again from an earlier one.
v1::ModelUsage UsageOf(const ArtifactsByKind& artifacts);

// The section of report.md: stage by stage what was asked and consumed, the faults that were asked about again, and
// where the handbook or the grammar stood in. Empty when no model was asked and none was to be.
std::string ModelsSection(const v1::Report& report, const ArtifactsByKind& artifacts);

// The calls behind one artifact, a line each.
std::string ModelCallLines(const v1::Artifact& artifact);

// The calls behind one artifact with all that was said and answered.
std::string ModelCallTexts(const v1::Artifact& artifact);

}  // namespace flair::cli
