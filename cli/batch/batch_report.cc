// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdio.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <numeric>
#include <utility>

#include "cli/batch/results_file.h"
#include "cli/output/output_folder.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

using nlohmann::ordered_json;

constexpr size_t kShownOfError = 160;

// One JSON object.
constexpr char kCounts[] = R"sql(
  SELECT json_object(
    'batch_id', COALESCE((SELECT value FROM state WHERE name = 'batch_id'), ''),
    'label', COALESCE((SELECT value FROM state WHERE name = 'label'), ''),
    'job_count', COUNT(*),
    'succeeded_count', COUNT(*) FILTER (WHERE state = 'succeeded'),
    'failed_count', COUNT(*) FILTER (WHERE state = 'failed'),
    'cancelled_count', COUNT(*) FILTER (WHERE state = 'cancelled'),
    'waiting_count', COUNT(*) FILTER (WHERE state = 'waiting'),
    'rejected_count', CAST(COALESCE((SELECT value FROM state WHERE name = 'rejected_count'), 0) AS INTEGER),
    'not_fetched_count', COUNT(fetch_error),
    'first_time', COALESCE(MIN(create_time), ''),
    'last_time', COALESCE(MAX(end_time), ''),
    'satisfied_count', COALESCE(SUM(satisfied_count), 0),
    'violated_count', COALESCE(SUM(violated_count), 0),
    'use_count', COALESCE(SUM(use_count), 0),
    'met_use_count', COALESCE(SUM(met_use_count), 0),
    'with_findings_count', COUNT(*) FILTER (WHERE findings != ''),
    'model_calls', COALESCE(SUM(model_calls), 0),
    'input_tokens', COALESCE(SUM(input_tokens), 0),
    'output_tokens', COALESCE(SUM(output_tokens), 0),
    'cost_usd', TOTAL(cost_usd),
    'size_bytes', COALESCE(SUM(size_bytes), 0)) FROM jobs)sql";

// A list of JSON objects, the most frequent kind first. With MIN, SQLite takes the other columns from that row.
constexpr char kFailures[] = R"sql(
  SELECT json_group_array(json_object('kind', failure_kind, 'count', count, 'batch_index', first,
                                      'line', COALESCE(line, 0), 'stage', COALESCE(stage, ''),
                                      'error', COALESCE(error, '')))
  FROM (SELECT failure_kind, COUNT(*) AS count, MIN(batch_index) AS first, line, stage, error FROM jobs
        WHERE state = 'failed' AND failure_kind IS NOT NULL GROUP BY failure_kind ORDER BY count DESC, first))sql";

absl::StatusOr<ordered_json> JsonOf(ResultsFile& results, const char* query) {
  ASSIGN_OR_RETURN(const std::string text, results.Text(query));
  ordered_json json = ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) return absl::DataLossError("results.db: holds text that is not UTF-8");
  return json;
}

// Columns whose spread says something about a batch.
bool IsMeasure(const ResultColumn& column) { return column.type == "REAL" && column.name != "cost_usd"; }

ordered_json SpreadOf(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
  };
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {{"count", values.size()}, {"mean", sum / static_cast<double>(values.size())},
          {"p50", at(0.5)},         {"p90", at(0.9)},
          {"p99", at(0.99)},        {"most", values.back()}};
}

std::string Figure(double value) {
  if (std::abs(value) < 1e-9) return "0";
  return value >= 1000 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

std::string Quoted(std::string text) {
  // What spreadsheets would take for a formula, they take for text with this before it.
  if (text.find_first_of("=+-@\t\r") == 0) text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string Cell(const ResultValue& value) {
  if (const auto* number = std::get_if<int64_t>(&value)) return fmt::format("{}", *number);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  if (const auto* text = std::get_if<std::string>(&value)) return Quoted(*text);
  return "";
}

absl::Status WriteRows(ResultsFile& results, std::ofstream& file) {
  std::string line;
  for (const ResultColumn& column : ResultColumns()) line += (line.empty() ? "" : ",") + column.name;
  file << line << "\r\n";
  return results.ForEach("", [&](const ResultRow& row) {
    line.clear();
    for (size_t i = 0; i < row.values().size(); ++i) line += (i == 0 ? "" : ",") + Cell(row.values()[i]);
    file << line << "\r\n";
    return file.fail() ? absl::UnavailableError("") : absl::OkStatus();
  });
}

}  // namespace

absl::StatusOr<BatchReport> MakeBatchReport(ResultsFile& results) {
  ASSIGN_OR_RETURN(BatchReport report, JsonOf(results, kCounts));
  ASSIGN_OR_RETURN(report["failures"], JsonOf(results, kFailures));
  report["columns"] = ordered_json::object();
  for (const ResultColumn& column : ResultColumns()) {
    if (!IsMeasure(column)) continue;
    ASSIGN_OR_RETURN(std::vector<double> values,
                     results.Numbers(fmt::format("SELECT {0} FROM jobs WHERE {0} IS NOT NULL", column.name)));
    if (!values.empty()) report["columns"][column.name] = SpreadOf(std::move(values));
  }
  return report;
}

int64_t CountIn(const BatchReport& report, const char* name) { return report.at(name).get<int64_t>(); }

std::string BatchOutcomeText(const BatchReport& report) {
  std::string text =
      fmt::format("{}: {} succeeded", Counted(CountIn(report, "job_count"), "job"), CountIn(report, "succeeded_count"));
  const std::pair<const char*, const char*> others[] = {{"failed_count", "failed"},
                                                        {"cancelled_count", "cancelled"},
                                                        {"waiting_count", "have not ended"},
                                                        {"not_fetched_count", "could not be fetched"}};
  for (const auto& [name, words] : others) {
    if (CountIn(report, name) > 0) text += fmt::format(", {} {}", CountIn(report, name), words);
  }
  const int64_t rejected = CountIn(report, "rejected_count");
  if (rejected > 0) text += fmt::format("; {} rejected (rejected.jsonl)", Counted(rejected, "line"));
  text += "\n";
  for (const ordered_json& failure : report.at("failures")) {
    const int64_t line = CountIn(failure, "line");
    const std::string stage = failure.at("stage");
    text += fmt::format("{:>7} {}, such as job {}{}: {}: {}\n", CountIn(failure, "count"),
                        failure.at("kind").get<std::string>(), CountIn(failure, "batch_index"),
                        line > 0 ? fmt::format(" (line {})", line) : "", stage.empty() ? "no stage" : stage,
                        Shortened(PrintableLine(failure.at("error").get<std::string>()), kShownOfError));
  }
  return text;
}

std::string BatchReportText(const BatchReport& report) {
  const auto text_of = [&report](const char* name) { return report.at(name).get<std::string>(); };
  std::string text = fmt::format("batch {}{}\n", text_of("batch_id"),
                                 text_of("label").empty() ? "" : fmt::format("  {}", Printable(text_of("label"))));
  text += BatchOutcomeText(report);
  if (!text_of("last_time").empty()) {
    text += fmt::format("from {} to {} UTC\n", text_of("first_time"), text_of("last_time"));
  }
  const int64_t satisfied = CountIn(report, "satisfied_count"), held = satisfied + CountIn(report, "violated_count");
  if (held > 0) {
    text += fmt::format("{} of {} ({:.1f} %)\n", satisfied, Counted(held, "constraint holds", "constraints hold"),
                        100.0 * static_cast<double>(satisfied) / static_cast<double>(held));
  }
  if (const int64_t uses = CountIn(report, "use_count"); uses > 0) {
    text += fmt::format("{} of {} met\n", CountIn(report, "met_use_count"), Counted(uses, "use is", "uses are"));
  }
  if (const int64_t wrong = CountIn(report, "with_findings_count"); wrong > 0) {
    text += fmt::format("{} something wrong (column \"findings\")\n", Counted(wrong, "job has", "jobs have"));
  }
  if (CountIn(report, "model_calls") > 0) {
    text += fmt::format("{} of models, {} + {} tokens, {:.4f} USD\n", Counted(CountIn(report, "model_calls"), "call"),
                        CountIn(report, "input_tokens"), CountIn(report, "output_tokens"),
                        report.at("cost_usd").get<double>());
  }
  const int64_t size_bytes = CountIn(report, "size_bytes");
  if (size_bytes > 0) text += fmt::format("{:.1f} MiB kept\n", static_cast<double>(size_bytes) / (1 << 20));
  if (report.at("columns").empty()) return text;
  const TextTable table({"", "jobs", "mean", "p50", "p90", "p99", "most"}, 24, 9);
  text += "\n" + table.Header();
  for (const auto& [column, spread] : report.at("columns").items()) {
    std::vector<std::string> cells = {column, std::to_string(CountIn(spread, "count"))};
    for (const char* name : {"mean", "p50", "p90", "p99", "most"}) cells.push_back(Figure(spread.at(name)));
    text += table.Row(cells);
  }
  return text;
}

absl::Status WriteResultsCsv(ResultsFile& results, const std::string& path) {
  RETURN_IF_ERROR(CheckOutputFile(path));
  std::error_code error;
  // A device or pipe is written to as it is.
  const bool in_place = std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
  const std::string made = in_place ? path : path + ".partial";
  std::ofstream file(made, std::ios::binary | std::ios::trunc);
  const absl::Status status = WriteRows(results, file);
  file.close();
  if (file.fail() || (status.ok() && !in_place && ::rename(made.c_str(), path.c_str()) != 0)) {
    const int reason = errno;
    if (!in_place) std::filesystem::remove(made, error);
    return CannotWrite(path, reason);
  }
  return status;
}

}  // namespace flair::cli
