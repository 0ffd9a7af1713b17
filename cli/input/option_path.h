// SPDX-License-Identifier: GPL-3.0-or-later
// Options of a job by name, as a person says them (optimizer.restarts=500), and fields read from text.
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// True for numbers, words, truth values and durations, and for lists of them; false for other messages.
bool IsValue(const google::protobuf::FieldDescriptor& field);

// What such a field takes, in words: "whole number", "true or false", "plan, birdseye or perspective", "numbers with
// commas between".
std::string ValuesInWords(const google::protobuf::FieldDescriptor& field);

// Sets the field from text; clears it when the text is empty. False when the text is no value of the field, which then
// is as it was. Words of enums may be long or short, with - or _: PREVIEW_VIEW_PLAN, plan.
bool SetValue(const std::string& text, const google::protobuf::FieldDescriptor& field,
              google::protobuf::Message& message);

// Options of a job by name, as a person says them: optimizer.restarts=500.

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
