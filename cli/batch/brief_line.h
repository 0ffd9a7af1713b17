// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"

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

}  // namespace flair::cli
