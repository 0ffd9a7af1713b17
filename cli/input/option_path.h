// SPDX-License-Identifier: GPL-3.0-or-later
// Options of a job by name, as a person says them: optimizer.restarts=500.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// Every option of a job: the fields of SolveOptions under "optimizer.", of RenderOptions under "renderer.", of
// ModelOptions under "models.", and "brief.seed"; short names where there are some.
struct OptionName {
  // Such as "optimizer.restarts" or "optimizer.lambdas.balanced".
  std::string name;
  // What it takes, such as "whole number" or "plan, birdseye or perspective".
  std::string values;
};
std::vector<OptionName> OptionNames();

// Sets the option that "NAME=VALUE" names; "NAME=" gives it back to the stage, which then takes its default. Numbers
// and words of a list have commas between. Returns the name of the first stage that takes such options, such as
// "solve". INVALID_ARGUMENT says which names there are, or what VALUE should be. Ranges are checked by Validate.
absl::StatusOr<std::string_view> SetOption(const std::string& assignment, v1::JobSpec& spec);

}  // namespace flair::cli
