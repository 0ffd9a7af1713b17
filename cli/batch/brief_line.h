// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"
#include "nlohmann/json_fwd.hpp"

namespace flair::cli {

// One line of a file of briefs, as docs/batches.md describes them.
struct BriefLine {
  v1::JobSpec spec;
  // What the user calls it ("id"); empty when nothing.
  std::string key;
};

// Reads a line without its break: a sentence, a JSON string, or a JSON object with the fields of a Brief (or a Brief in
// "brief") and id, variants, views, solve, render, models. What it leaves out is taken from `defaults`, whose brief has
// no text. INVALID_ARGUMENT says in one line what is wrong: field, value and what would be right.
absl::StatusOr<BriefLine> ReadBriefLine(std::string_view line, const v1::JobSpec& defaults);

// The pictures that a job draws: the first goes to render_options, the others to further_views. `views` are changes of
// what render_options has been set to so far.
void SetViews(const std::vector<v1::RenderOptions>& views, v1::JobSpec& spec);

// Messages as people write them in JSON: only what they want to change, enums by their short words.

// Whether a JSON text nests at most `most` deep; those that read it do so by recursion.
bool NestsWithin(std::string_view json, int most);

// Sets the fields of `message` that the JSON object names and leaves the others as they are; parts that are messages
// are changed likewise, lists are replaced. Enums may be short words: "birdseye" for PREVIEW_VIEW_BIRDSEYE.
// INVALID_ARGUMENT begins with `path` and the field: "solve.max_restart_count: is "x"; expected ...".
absl::Status SetFromJson(const nlohmann::json& object, std::string_view path, google::protobuf::Message& message);

}  // namespace flair::cli
