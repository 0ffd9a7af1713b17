// SPDX-License-Identifier: GPL-3.0-or-later
// What a design ends in: its report and its files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/output/output_folder.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

// The artifacts of one job by kind.
using ArtifactsByKind = std::map<v1::ArtifactKind, v1::Artifact>;

// What of the brief was done otherwise or not at all, one sentence each: what was not understood, what was left out,
// and places that the layout does not keep. In report.md and on the terminal.
std::vector<std::string> NotAsAsked(const v1::SolvedLayout& layout);

// "All 7 uses are met." "5 of 7 uses are met." Empty when the layout says nothing of uses, or none is asked.
std::string UsesInWords(const v1::LayoutMetrics& metrics);

// What cannot be so in a real room and which uses are not met, one sentence each, at most `most` and how many more.
std::vector<std::string> WrongInWords(const v1::LayoutMetrics& metrics, size_t most);

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

// What language models were asked, for people.

// What they consumed in all artifacts of a job, also in those that are used again from an earlier one.
v1::ModelUsage UsageOf(const ArtifactsByKind& artifacts);

// The section of report.md: stage by stage what was asked and consumed, the faults that were asked about again, and
// where the handbook or the grammar stood in. Empty when no model was asked and none was to be.
std::string ModelsSection(const v1::Report& report, const ArtifactsByKind& artifacts);

// The calls behind one artifact, a line each.
std::string ModelCallLines(const v1::Artifact& artifact);

// The calls behind one artifact with all that was said and answered.
std::string ModelCallTexts(const v1::Artifact& artifact);

// What a solve did and found, for people.

// A line for the layout and each of its runner-ups that is complete. `files` names where each went, in that order;
// empty when they went nowhere.
std::string VariantsTable(const v1::SolvedLayout& layout, const std::vector<std::string>& files);

// Runner-up `index` of a layout as a layout of its own; its whole-room terms are not known here.
v1::SolvedLayout VariantOf(const v1::SolvedLayout& layout, int index);

// "45 of 50 constraints hold, 5 of 7 uses met, OOB 0.00 %, OOR 0.00 % (0.01 % in 3D)", for a caption.
std::string LayoutLine(const v1::SolvedLayout& layout);

// A runner-up with an account of all edges; the others hold floor objects only.
bool IsComplete(const v1::RunnerUp& runner_up);

// What a person should know of a layout: its diagnostics, the edges that mean nothing (the first twenty) and the
// constraints that contradict each other, a line each ("remark", "dropped", "clash"), in the form of flair inspect;
// empty when there is nothing.
std::string LayoutRemarks(const v1::SolvedLayout& layout);

}  // namespace flair::cli
