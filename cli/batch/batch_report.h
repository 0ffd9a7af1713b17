// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "cli/batch/results_file.h"
#include "nlohmann/json_fwd.hpp"

namespace flair::cli {

// What became of a batch, made of results.db alone: batch_id, label, counts of jobs, lines, constraints, model calls
// and bytes, first_time and last_time (from the first job's creation to the last one's end; empty when none has ended);
// "failures", a list with an example of each kind: kind, count, batch_index, line (0 when nobody knows), stage, error;
// and "columns" by name, measures and times, how their values are spread: count, mean, p50, p90, p99, most.
using BatchReport = nlohmann::ordered_json;

absl::StatusOr<BatchReport> MakeBatchReport(ResultsFile& results);
int64_t CountIn(const BatchReport& report, const char* name);

// For people.
std::string BatchReportText(const BatchReport& report);
// The lines on which it says how the jobs ended and why some failed.
std::string BatchOutcomeText(const BatchReport& report);

// All rows as RFC 4180 CSV with the names of the columns first, whole or not at all.
absl::Status WriteResultsCsv(ResultsFile& results, const std::string& path);

}  // namespace flair::cli
