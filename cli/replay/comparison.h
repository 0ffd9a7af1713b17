// SPDX-License-Identifier: GPL-3.0-or-later
// A job and its replay, side by side: which stages gave the same again, and where they part.
#pragma once

#include <google/protobuf/message.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output/report_text.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// Where two messages part, by fields; for what that means, see flair diff.

struct FieldDifference {
  // Such as "placements[2].x_m".
  std::string path;
  // Both values, long ones cut short; "none" where there is none.
  std::string first;
  std::string second;
  // How many fields differ in all, this one included. A message that only one side has counts as one.
  int field_count = 0;

  // "placements[2].x_m: 1.2 -> 1.24".
  std::string InWords() const;
};

// The first field, in the order of the numbers of fields, in which two messages of one type differ; nothing when they
// are equal. `aside` names fields of the messages themselves that are looked at only when all others are equal, such as
// a copy of an input.
std::optional<FieldDifference> FirstDifference(const google::protobuf::Message& first,
                                               const google::protobuf::Message& second,
                                               const std::vector<std::string>& aside = {});

// The stages of both jobs.

enum class Agreement {
  kTaken,        // the earlier job's artifact; the stage was not run
  kSameBytes,    // one id: content and origin are the same
  kSameContent,  // the content is the same, who made it or what it was made from is not
  kDiffers,
  kFirstOnly,   // the replay has no artifact of the stage
  kReplayOnly,  // the earlier job had none
  kNeither,
};

struct StageComparison {
  std::string_view stage;
  Agreement agreement = Agreement::kNeither;
  // Other options were given that reach this stage.
  bool asked = false;
  // Where the contents part; set when they do.
  std::optional<FieldDifference> content;
  // What else parts, likely causes first: fields of the producer, options, what a model was asked and answered.
  std::vector<FieldDifference> origin;
  // The first stage among the inputs whose artifact is another one; empty when none is.
  std::string_view input;

  // Differs without having been asked to.
  bool Parts() const;
};

// All stages in their order. Reports are compared without what belongs to one job: its id, times and consumption.
std::vector<StageComparison> CompareStages(const v1::Job& first, const ArtifactsByKind& first_artifacts,
                                           const v1::Job& replay, const ArtifactsByKind& replay_artifacts);

// True when no stage parts.
bool AllAgree(const std::vector<StageComparison>& stages);

// What a replay showed, for people and for programs.

// A line or two per stage, ending in newlines.
std::string ComparisonTable(const std::vector<StageComparison>& stages);

// One line: what agrees, where the jobs part first, and the likely cause.
std::string ComparisonSummary(const std::vector<StageComparison>& stages);

// One JSON object on one line, without the newline: both ids, "agrees", and the stages.
std::string ComparisonJson(const std::vector<StageComparison>& stages, const std::string& first_id,
                           const std::string& replay_id);

}  // namespace flair::cli
