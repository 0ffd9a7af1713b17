// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

namespace {

constexpr size_t kShownOfError = 160;

// Columns whose spread says something about a batch.
bool IsMeasure(const ResultColumn& column) { return column.type == "REAL" && column.name != "cost_usd"; }

Spread SpreadOf(const std::string& column, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
  };
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {.column = column,
          .count = static_cast<int64_t>(values.size()),
          .mean = sum / static_cast<double>(values.size()),
          .p50 = at(0.5),
          .p90 = at(0.9),
          .p99 = at(0.99),
          .most = values.back()};
}

absl::Status AddSpreads(ResultsFile& results, BatchReport& report) {
  for (const ResultColumn& column : ResultColumns()) {
    if (!IsMeasure(column)) continue;
    ASSIGN_OR_RETURN(auto values,
                     results.Numbers(fmt::format("SELECT {0} FROM jobs WHERE {0} IS NOT NULL", column.name)));
    if (!values.empty()) report.spreads.push_back(SpreadOf(column.name, std::move(values)));
  }
  return absl::OkStatus();
}

absl::Status AddFailures(ResultsFile& results, BatchReport& report) {
  for (const std::string& kind : FailureKindWords()) {
    const std::string where = fmt::format("FROM jobs WHERE state = 'failed' AND failure_kind = '{}'", kind);
    ASSIGN_OR_RETURN(const int64_t count, results.Count("SELECT COUNT(*) " + where));
    if (count == 0) continue;
    ASSIGN_OR_RETURN(const int64_t first, results.Count("SELECT MIN(batch_index) " + where));
    ASSIGN_OR_RETURN(const std::optional<ResultRow> row, results.Find(first));
    if (!row.has_value()) continue;
    report.failures.push_back({.kind = kind,
                               .count = count,
                               .batch_index = first,
                               .line = row->Int("line"),
                               .stage = row->Text("stage"),
                               .error = row->Text("error")});
  }
  std::ranges::stable_sort(report.failures, std::greater(), &FailureSummary::count);
  return absl::OkStatus();
}

absl::Status AddCounts(ResultsFile& results, BatchReport& report) {
  const std::pair<const char*, int64_t*> counts[] = {
      {"SELECT COUNT(*) FROM jobs", &report.job_count},
      {"SELECT COUNT(*) FROM jobs WHERE state = 'succeeded'", &report.succeeded_count},
      {"SELECT COUNT(*) FROM jobs WHERE state = 'failed'", &report.failed_count},
      {"SELECT COUNT(*) FROM jobs WHERE state = 'cancelled'", &report.cancelled_count},
      {"SELECT COUNT(*) FROM jobs WHERE state = 'waiting'", &report.waiting_count},
      {"SELECT COUNT(*) FROM jobs WHERE fetch_error IS NOT NULL", &report.not_fetched_count},
      {"SELECT value FROM state WHERE name = 'rejected_count'", &report.rejected_count},
      {"SELECT SUM(satisfied_count) FROM jobs", &report.satisfied_count},
      {"SELECT SUM(violated_count) FROM jobs", &report.violated_count},
      {"SELECT SUM(model_calls) FROM jobs", &report.model_calls},
      {"SELECT SUM(input_tokens) FROM jobs", &report.input_tokens},
      {"SELECT SUM(output_tokens) FROM jobs", &report.output_tokens},
      {"SELECT SUM(size_bytes) FROM jobs", &report.size_bytes}};
  for (const auto& [query, count] : counts) {
    ASSIGN_OR_RETURN(const int64_t value, results.Count(query));
    *count = value;
  }
  const std::pair<const char*, std::string*> texts[] = {
      {"SELECT value FROM state WHERE name = 'batch_id'", &report.batch_id},
      {"SELECT value FROM state WHERE name = 'label'", &report.label},
      {"SELECT MIN(create_time) FROM jobs", &report.first_time},
      {"SELECT MAX(end_time) FROM jobs", &report.last_time}};
  for (const auto& [query, text] : texts) {
    ASSIGN_OR_RETURN(std::string value, results.Text(query));
    *text = std::move(value);
  }
  ASSIGN_OR_RETURN(const std::vector<double> cost, results.Numbers("SELECT COALESCE(SUM(cost_usd), 0.0) FROM jobs"));
  report.cost_usd = cost.empty() ? 0 : cost.front();
  return absl::OkStatus();
}

std::string Figure(double value) {
  if (std::abs(value) < 1e-9) return "0";
  return value >= 1000 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

}  // namespace

absl::StatusOr<BatchReport> MakeBatchReport(ResultsFile& results) {
  BatchReport report;
  absl::Status status = AddCounts(results, report);
  if (status.ok()) status = AddFailures(results, report);
  if (status.ok()) status = AddSpreads(results, report);
  if (!status.ok()) return status;
  return report;
}

std::string BatchOutcomeText(const BatchReport& report) {
  std::string text = fmt::format("{}: {} succeeded", Counted(report.job_count, "job"), report.succeeded_count);
  const std::pair<int64_t, const char*> others[] = {{report.failed_count, "failed"},
                                                    {report.cancelled_count, "cancelled"},
                                                    {report.waiting_count, "have not ended"},
                                                    {report.not_fetched_count, "could not be fetched"}};
  for (const auto& [count, words] : others) {
    if (count > 0) text += fmt::format(", {} {}", count, words);
  }
  if (report.rejected_count > 0)
    text += fmt::format("; {} rejected (rejected.jsonl)", Counted(report.rejected_count, "line"));
  text += "\n";
  for (const FailureSummary& failure : report.failures) {
    text += fmt::format("{:>7} {}, such as job {}{}: {}: {}\n", failure.count, failure.kind, failure.batch_index,
                        failure.line > 0 ? fmt::format(" (line {})", failure.line) : "",
                        failure.stage.empty() ? "no stage" : failure.stage,
                        Shortened(PrintableLine(failure.error), kShownOfError));
  }
  return text;
}

std::string BatchReportText(const BatchReport& report) {
  std::string text = fmt::format("batch {}{}\n", report.batch_id,
                                 report.label.empty() ? "" : fmt::format("  {}", Printable(report.label)));
  text += BatchOutcomeText(report);
  if (!report.last_time.empty()) text += fmt::format("from {} to {} UTC\n", report.first_time, report.last_time);
  const int64_t held = report.satisfied_count + report.violated_count;
  if (held > 0) {
    text += fmt::format("{} of {} ({:.1f} %)\n", report.satisfied_count,
                        Counted(held, "constraint holds", "constraints hold"),
                        100.0 * static_cast<double>(report.satisfied_count) / static_cast<double>(held));
  }
  if (report.model_calls > 0) {
    text += fmt::format("{} of models, {} + {} tokens, {:.4f} USD\n", Counted(report.model_calls, "call"),
                        report.input_tokens, report.output_tokens, report.cost_usd);
  }
  if (report.size_bytes > 0)
    text += fmt::format("{:.1f} MiB kept\n", static_cast<double>(report.size_bytes) / (1 << 20));
  if (report.spreads.empty()) return text;
  const TextTable table({"", "jobs", "mean", "p50", "p90", "p99", "most"}, 24, 9);
  text += "\n" + table.Header();
  for (const Spread& spread : report.spreads) {
    text += table.Row({spread.column, std::to_string(spread.count), Figure(spread.mean), Figure(spread.p50),
                       Figure(spread.p90), Figure(spread.p99), Figure(spread.most)});
  }
  return text;
}

nlohmann::ordered_json BatchReportJson(const BatchReport& report) {
  nlohmann::ordered_json json = {{"batch_id", report.batch_id},
                                 {"label", report.label},
                                 {"job_count", report.job_count},
                                 {"succeeded_count", report.succeeded_count},
                                 {"failed_count", report.failed_count},
                                 {"cancelled_count", report.cancelled_count},
                                 {"waiting_count", report.waiting_count},
                                 {"rejected_count", report.rejected_count},
                                 {"not_fetched_count", report.not_fetched_count},
                                 {"first_time", report.first_time},
                                 {"last_time", report.last_time},
                                 {"satisfied_count", report.satisfied_count},
                                 {"violated_count", report.violated_count},
                                 {"model_calls", report.model_calls},
                                 {"input_tokens", report.input_tokens},
                                 {"output_tokens", report.output_tokens},
                                 {"cost_usd", report.cost_usd},
                                 {"size_bytes", report.size_bytes}};
  json["failures"] = nlohmann::ordered_json::array();
  for (const FailureSummary& failure : report.failures) {
    json["failures"].push_back({{"kind", failure.kind},
                                {"count", failure.count},
                                {"batch_index", failure.batch_index},
                                {"line", failure.line},
                                {"stage", failure.stage},
                                {"error", failure.error}});
  }
  json["columns"] = nlohmann::ordered_json::object();
  for (const Spread& spread : report.spreads) {
    json["columns"][spread.column] = {{"count", spread.count}, {"mean", spread.mean}, {"p50", spread.p50},
                                      {"p90", spread.p90},     {"p99", spread.p99},   {"most", spread.most}};
  }
  return json;
}

}  // namespace flair::cli
