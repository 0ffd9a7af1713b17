// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/batch/results_file.h"
#include "nlohmann/json_fwd.hpp"

namespace flair::cli {

// How the values of a column are spread over the jobs that have one.
struct Spread {
  std::string column;
  int64_t count = 0;
  double mean = 0;
  double p50 = 0;
  double p90 = 0;
  double p99 = 0;
  double most = 0;
};

// A kind of failure with one example of it.
struct FailureSummary {
  std::string kind;
  int64_t count = 0;
  int64_t batch_index = 0;
  // 0 when nobody knows.
  int64_t line = 0;
  std::string stage;
  std::string error;
};

// What became of a batch, made of results.db alone.
struct BatchReport {
  std::string batch_id;
  std::string label;
  int64_t job_count = 0;
  int64_t succeeded_count = 0;
  int64_t failed_count = 0;
  int64_t cancelled_count = 0;
  int64_t waiting_count = 0;
  int64_t rejected_count = 0;
  int64_t not_fetched_count = 0;
  // From the first job's creation to the last one's end; empty when none has ended.
  std::string first_time;
  std::string last_time;
  std::vector<FailureSummary> failures;
  // Measures and times, in the order of the columns.
  std::vector<Spread> spreads;
  int64_t satisfied_count = 0;
  int64_t violated_count = 0;
  int64_t model_calls = 0;
  int64_t input_tokens = 0;
  int64_t output_tokens = 0;
  double cost_usd = 0;
  int64_t size_bytes = 0;
};

absl::StatusOr<BatchReport> MakeBatchReport(ResultsFile& results);

// For people.
std::string BatchReportText(const BatchReport& report);
// The lines on which it says how the jobs ended and why some failed.
std::string BatchOutcomeText(const BatchReport& report);
nlohmann::ordered_json BatchReportJson(const BatchReport& report);

// All rows as RFC 4180 CSV with the names of the columns first, whole or not at all.
absl::Status WriteResultsCsv(ResultsFile& results, const std::string& path);

}  // namespace flair::cli
