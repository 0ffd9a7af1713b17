// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/output/text.h"
#include "cli/top/cluster_state.h"
#include "cli/top/terminal.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using Json = nlohmann::ordered_json;
using Cell = std::function<std::string(const Json& row)>;

// A column of a table of the state's rows. One of no width takes what the others leave; one of a width below 0 is set
// to the left.
struct Column {
  const char* title;
  int width;
  Cell cell;
  std::function<Style(const Json& row)> style = [](const Json&) { return Style::kPlain; };
};

Cell Text(const char* field) {
  return [field](const Json& row) { return row[field].get<std::string>(); };
}

Cell Count(const char* field) {
  return [field](const Json& row) { return Grouped(row[field]); };
}

std::string RateText(const Json& per_second) {
  if (per_second.is_null()) return "-";
  const double rate = per_second;
  return rate < 10 ? fmt::format("{:.1f}", rate) : fmt::format("{:.0f}", rate);
}

Cell Rate(const char* field) {
  return [field](const Json& row) { return RateText(row[field]); };
}

Column Failures(const char* field) {
  return {"FAILED", 8, Count(field),
          [field](const Json& row) { return row[field] == 0 ? Style::kPlain : Style::kBad; }};
}

std::string Latency(const Json& row) {
  const double seconds = row["call_duration_s"];
  if (seconds <= 0) return "-";
  if (seconds < 0.9995) return fmt::format("{:.0f} ms", std::max(1.0, 1e3 * seconds));
  return seconds < 100 ? fmt::format("{:.1f} s", seconds) : ShortDuration(absl::Seconds(seconds));
}

Style StyleOfState(const Json& row) {
  const std::string state = row["state"];
  if (state == "ready") return Style::kGood;
  if (state == "gone") return Style::kWarning;
  return state == "broken" ? Style::kBad : Style::kDim;
}

int64_t EndedCount(const Json& batch) { return batch["job_count"].get<int64_t>() - batch["open_count"].get<int64_t>(); }

double EndedShare(const Json& batch) {
  return batch["job_count"] == 0 ? 0 : static_cast<double>(EndedCount(batch)) / batch["job_count"].get<double>();
}

std::string Bar(const Json& batch) {
  constexpr int kWidth = 10;
  const int full = static_cast<int>(std::floor(std::clamp(EndedShare(batch), 0.0, 1.0) * kWidth));
  std::string bar;
  for (int i = 0; i < kWidth; ++i) bar += i < full ? "█" : "░";
  return bar;
}

std::string BatchEnding(const Json& batch) {
  if (batch["state"] != "active" && batch["state"] != "unspecified") return batch["state"];
  if (batch["open"]) return "more follow";
  const Json& remaining = batch["remaining_s"];
  return remaining.is_null() ? "ETA -" : "ETA " + ShortDuration(absl::Seconds(remaining.get<double>()));
}

const std::vector<Column>& BatchColumns() {
  static const std::vector<Column> columns = {
      {"BATCH", 0, [](const Json& row) { return row[row["label"] == "" ? "id" : "label"].get<std::string>(); }},
      {"", 11, Bar, [](const Json&) { return Style::kGood; }},
      {"", 5, [](const Json& row) { return fmt::format("{:.0f}%", std::floor(100 * EndedShare(row))); }},
      {"ENDED", 15, [](const Json& row) { return Grouped(EndedCount(row)) + "/" + Grouped(row["job_count"]); }},
      Failures("failed_count"),
      {"JOBS/S", 8, Rate("jobs_per_second")},
      {"", 14, BatchEnding}};
  return columns;
}

const std::vector<Column>& OrchestratorColumns() {
  static const std::vector<Column> columns = {
      {"ORCHESTRATOR", 0, Text("id")},
      {"RUNNING", 10, [](const Json& row) { return row["running_count"].dump() + "/" + row["running_limit"].dump(); }},
      {"DONE", 11, Count("succeeded_count")},
      Failures("failed_count"),
      {"RETRIED", 8, Count("retried_count")},
      {"JOBS/S", 7, Rate("jobs_per_second")},
      {"SEEN", 7,
       [](const Json& row) {
         return row["seen_s"] < 1 ? "now" : ShortDuration(absl::Seconds(row["seen_s"].get<double>()));
       },
       [](const Json& row) { return row["seen_s"] > 10 ? Style::kWarning : Style::kPlain; }}};
  return columns;
}

const std::vector<Column>& WorkerColumns() {
  static const std::vector<Column> columns = {
      {"WORKER", -12, Text("stage")},
      {"ADDRESS", 0, Text("address")},
      {"STATE", -7,
       [](const Json& row) { return row["state"] == "unspecified" ? "idle" : row["state"].get<std::string>(); },
       StyleOfState},
      {"BUSY", 6, Count("in_flight_count")},
      {"CALLS", 11, Count("call_count")},
      Failures("failure_count"),
      {"LATENCY", 9, Latency},
      {"CALLS/S", 9, Rate("calls_per_second")}};
  return columns;
}

// A heading and its rows.
struct Section {
  std::string heading;
  std::vector<std::string> rows;
};

class TopPage {
 public:
  explicit TopPage(const TopLayout& layout) : layout_(layout) {}

  std::vector<std::string> Lines(const ClusterState& state, const std::string& address,
                                 const std::string& trouble) const {
    const Json& json = state.json();
    const std::string time = absl::FormatTime("%Y-%m-%d %H:%M:%S", state.time(), absl::LocalTimeZone());
    std::vector<std::string> lines = {Line()
                                          .Left("flair top  " + address, std::max(8, layout_.width - 20), Style::kBold)
                                          .Right(time, 20, Style::kDim)
                                          .text(),
                                      Totals(json["totals"])};
    for (const std::string& text : {trouble, json.value("away", std::string())}) {
      if (!text.empty()) lines.push_back(Line().Add(text, Style::kBad).text());
    }
    std::vector<Section> sections;
    if (!json["batches"].empty()) sections.push_back(Table(BatchColumns(), json["batches"]));
    sections.push_back(json["orchestrators"].empty() ? NoOrchestrators(json["batches"].empty())
                                                     : Table(OrchestratorColumns(), json["orchestrators"]));
    if (!json["workers"].empty()) sections.push_back(Table(WorkerColumns(), json["workers"]));
    Fit(sections, static_cast<int>(lines.size()));
    for (const Section& section : sections) {
      lines.insert(lines.end(), {"", section.heading});
      lines.insert(lines.end(), section.rows.begin(), section.rows.end());
    }
    return lines;
  }

 private:
  StyledLine Line() const { return StyledLine(layout_.width, layout_.color); }

  std::string Totals(const Json& totals) const {
    const int64_t limit = totals["running_limit"];
    StyledLine line = Line();
    line.Add(Grouped(totals["queued_count"]), Style::kBold).Add(" waiting  ");
    line.Add(Grouped(totals["running_count"]) + (limit == 0 ? "" : fmt::format("/{}", limit)), Style::kBold);
    line.Add(" running  ").Add(RateText(totals["jobs_per_second"]), Style::kBold).Add(" jobs/s  ");
    line.Add(Grouped(totals["succeeded_count"])).Add(" done  ");
    line.Add(Grouped(totals["failed_count"]) + " failed", totals["failed_count"] == 0 ? Style::kPlain : Style::kBad);
    return line.Add(fmt::format("  {} retried", Grouped(totals["retried_count"]))).text();
  }

  Section Table(const std::vector<Column>& columns, const Json& rows) const {
    int rest = layout_.width;
    for (const Column& column : columns) rest -= std::abs(column.width);
    const auto put = [&](StyledLine& line, const Column& column, const std::string& text, Style style) {
      if (column.width > 0) return void(line.Right(text, column.width, style));
      const int width = column.width == 0 ? std::max(8, rest) : -column.width;
      line.Left(column.width == 0 ? Shortened(PrintableLine(text), static_cast<size_t>(width - 1)) : text, width,
                style);
    };
    Section section;
    size_t titled = columns.size();
    while (*columns[titled - 1].title == '\0') --titled;
    StyledLine heading = Line();
    for (size_t i = 0; i < titled; ++i) put(heading, columns[i], columns[i].title, Style::kDim);
    section.heading = heading.text();
    for (const Json& row : rows) {
      StyledLine line = Line();
      for (const Column& column : columns) put(line, column, column.cell(row), column.style(row));
      section.rows.push_back(line.text());
    }
    return section;
  }

  Section NoOrchestrators(bool is_idle) const {
    const std::string hint = "The store of this machine alone. A cluster: flair top --orchestrator HOST:PORT";
    if (!is_idle) return {Line().Add(hint).text(), {}};
    return {Line().Add("No batch is open.").text(), {Line().Add(hint, Style::kDim).text()}};
  }

  // Takes rows from the longest section until all fits, and says how many were taken.
  void Fit(std::vector<Section>& sections, int used) const {
    if (layout_.height == 0) return;
    const int room = std::max(0, layout_.height - used - 2 * static_cast<int>(sections.size()));
    std::vector<int> shown;
    int total = 0;
    for (const Section& section : sections) total += shown.emplace_back(static_cast<int>(section.rows.size()));
    while (total > room && *std::ranges::max_element(shown) > 0) {
      --*std::ranges::max_element(shown);
      --total;
    }
    for (size_t i = 0; i < sections.size(); ++i) {
      std::vector<std::string>& rows = sections[i].rows;
      const int hidden = static_cast<int>(rows.size()) - shown[i];
      if (hidden == 0) continue;
      rows.resize(static_cast<size_t>(shown[i]));
      if (!rows.empty()) rows.back() = Line().Add(fmt::format("… and {} more", hidden + 1), Style::kDim).text();
    }
  }

  const TopLayout layout_;
};

}  // namespace

std::string ShortDuration(absl::Duration duration) {
  const int64_t seconds = std::max(int64_t{0}, absl::ToInt64Seconds(duration));
  if (seconds < 60) return fmt::format("{} s", seconds);
  if (seconds < 3600) return fmt::format("{}m{:02}s", seconds / 60, seconds % 60);
  if (seconds < 86400) return fmt::format("{}h{:02}m", seconds / 3600, seconds / 60 % 60);
  return fmt::format("{}d{:02}h", seconds / 86400, seconds / 3600 % 24);
}

std::string Grouped(int64_t number) {
  std::string text = fmt::format("{}", number);
  const int start = number < 0 ? 1 : 0;
  for (int i = static_cast<int>(text.size()) - 3; i > start; i -= 3) text.insert(static_cast<size_t>(i), ",");
  return text;
}

std::vector<std::string> TopText(const ClusterState& state, const std::string& address, const std::string& trouble,
                                 const TopLayout& layout) {
  return TopPage(layout).Lines(state, address, trouble);
}

std::string TopJson(const ClusterState& state) { return JsonText(state.json()); }

}  // namespace flair::cli
