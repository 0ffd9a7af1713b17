// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/top_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"
#include "cli/top/terminal.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

namespace {

// A heading and its rows.
struct Section {
  std::string heading;
  std::vector<std::string> rows;
};

std::string RateText(const std::optional<double>& per_second) {
  if (!per_second.has_value()) return "-";
  return *per_second < 10 ? fmt::format("{:.1f}", *per_second) : fmt::format("{:.0f}", *per_second);
}

std::string LatencyText(double seconds) {
  if (seconds <= 0) return "-";
  if (seconds < 0.9995) return fmt::format("{:.0f} ms", std::max(1.0, 1e3 * seconds));
  return seconds < 100 ? fmt::format("{:.1f} s", seconds) : ShortDuration(absl::Seconds(seconds));
}

std::string StateText(v1::WorkerState state) {
  if (state == v1::WORKER_STATE_UNSPECIFIED) return "idle";
  return absl::AsciiStrToLower(v1::WorkerState_Name(state).substr(std::string("WORKER_STATE_").size()));
}

Style StyleOf(v1::WorkerState state) {
  if (state == v1::WORKER_STATE_READY) return Style::kGood;
  if (state == v1::WORKER_STATE_GONE) return Style::kWarning;
  return state == v1::WORKER_STATE_BROKEN ? Style::kBad : Style::kDim;
}

Style BadUnlessZero(int64_t count) { return count == 0 ? Style::kPlain : Style::kBad; }

std::string Bar(double share, int width) {
  const int full = static_cast<int>(std::floor(std::clamp(share, 0.0, 1.0) * width));
  std::string bar;
  for (int i = 0; i < width; ++i) bar += i < full ? "█" : "░";
  return bar;
}

std::string BatchName(const v1::Batch& batch) { return batch.label().empty() ? batch.id() : batch.label(); }

std::string BatchEnding(const BatchRow& row) {
  if (row.batch.state() == v1::BATCH_STATE_PAUSED) return "paused";
  if (row.batch.state() == v1::BATCH_STATE_CANCELLED) return "cancelled";
  if (row.batch.open()) return "more follow";
  return row.remaining.has_value() ? "ETA " + ShortDuration(*row.remaining) : "ETA -";
}

std::string RunningText(const ClusterTotals& totals) {
  if (totals.running_limit == 0) return Grouped(totals.running_count);
  return fmt::format("{}/{}", totals.running_count, totals.running_limit);
}

class TopPage {
 public:
  TopPage(const ClusterState& state, const TopLayout& layout) : state_(state), layout_(layout) {}

  std::vector<std::string> Lines(const std::string& address, const std::string& trouble) const {
    std::vector<std::string> lines = {Title(address), Totals()};
    if (!trouble.empty()) lines.push_back(Line().Add(trouble, Style::kBad).text());
    std::vector<Section> sections;
    if (!state_.batches().empty()) sections.push_back(Batches());
    sections.push_back(state_.orchestrators().empty() ? NoOrchestrators() : Orchestrators());
    if (!state_.workers().empty()) sections.push_back(Workers());
    Fit(sections, static_cast<int>(lines.size()));
    for (const Section& section : sections) {
      lines.emplace_back();
      lines.push_back(section.heading);
      lines.insert(lines.end(), section.rows.begin(), section.rows.end());
    }
    return lines;
  }

 private:
  StyledLine Line() const { return StyledLine(layout_.width, layout_.color); }
  // What of the width a first column may take that shares its line with so much more.
  int FirstColumn(int others) const { return std::max(8, layout_.width - others); }

  std::string Title(const std::string& address) const {
    const std::string time = absl::FormatTime("%Y-%m-%d %H:%M:%S", state_.time(), absl::LocalTimeZone());
    return Line().Left("flair top  " + address, FirstColumn(20), Style::kBold).Right(time, 20, Style::kDim).text();
  }

  std::string Totals() const {
    const ClusterTotals& totals = state_.totals();
    StyledLine line = Line();
    line.Add(Grouped(totals.queued_count), Style::kBold).Add(" waiting  ");
    line.Add(RunningText(totals), Style::kBold).Add(" running  ");
    line.Add(RateText(totals.jobs_per_second), Style::kBold).Add(" jobs/s  ");
    line.Add(Grouped(totals.succeeded_count)).Add(" done  ");
    line.Add(fmt::format("{} failed", Grouped(totals.failed_count)), BadUnlessZero(totals.failed_count));
    return line.Add(fmt::format("  {} retried", Grouped(totals.retried_count))).text();
  }

  Section Batches() const {
    const int name_width = FirstColumn(60);
    Section section;
    section.heading = Line()
                          .Left("BATCH", name_width, Style::kDim)
                          .Right("ENDED", 30, Style::kDim)
                          .Right("FAILED", 8, Style::kDim)
                          .Right("JOBS/S", 8, Style::kDim)
                          .text();
    for (const BatchRow& row : state_.batches()) {
      const double share = row.batch.job_count() == 0
                               ? 0
                               : static_cast<double>(row.ended_count()) / static_cast<double>(row.batch.job_count());
      const std::string counts = fmt::format("{}/{}", Grouped(row.ended_count()), Grouped(row.batch.job_count()));
      section.rows.push_back(Line()
                                 .Left(BatchName(row.batch), name_width - 1)
                                 .Add(" " + Bar(share, 10), Style::kGood)
                                 .Right(fmt::format("{:.0f}%", std::floor(100 * share)), 5)
                                 .Right(counts, 15)
                                 .Right(Grouped(row.batch.failed_count()), 8, BadUnlessZero(row.batch.failed_count()))
                                 .Right(RateText(row.jobs_per_second), 8)
                                 .Right(BatchEnding(row), 14)
                                 .text());
    }
    return section;
  }

  Section NoOrchestrators() const {
    const std::string hint = "The store of this machine alone. A cluster: flair top --orchestrator HOST:PORT";
    Section section;
    section.heading = Line().Add(state_.batches().empty() ? "No batch is open." : hint).text();
    if (state_.batches().empty()) section.rows.push_back(Line().Add(hint, Style::kDim).text());
    return section;
  }

  Section Orchestrators() const {
    const int name_width = FirstColumn(51);
    Section section;
    StyledLine heading = Line();
    heading.Left("ORCHESTRATOR", name_width, Style::kDim);
    for (const auto& [title, width] :
         {std::pair("RUNNING", 10), {"DONE", 11}, {"FAILED", 8}, {"RETRIED", 8}, {"JOBS/S", 7}, {"SEEN", 7}}) {
      heading.Right(title, width, Style::kDim);
    }
    section.heading = heading.text();
    for (const OrchestratorRow& row : state_.orchestrators()) {
      section.rows.push_back(
          Line()
              .Left(row.status.id(), name_width)
              .Right(fmt::format("{}/{}", row.status.running_count(), row.status.running_limit()), 10)
              .Right(Grouped(row.status.succeeded_count()), 11)
              .Right(Grouped(row.status.failed_count()), 8, BadUnlessZero(row.status.failed_count()))
              .Right(Grouped(row.status.retried_count()), 8)
              .Right(RateText(row.jobs_per_second), 7)
              .Right(row.age < absl::Seconds(1) ? "now" : ShortDuration(row.age), 7,
                     row.age > absl::Seconds(10) ? Style::kWarning : Style::kPlain)
              .text());
    }
    return section;
  }

  Section Workers() const {
    const int address_width = FirstColumn(62);
    Section section;
    StyledLine heading = Line();
    heading.Left("WORKER", 12, Style::kDim).Left("ADDRESS", address_width, Style::kDim).Left("STATE", 7, Style::kDim);
    for (const auto& [title, width] :
         {std::pair("BUSY", 5), {"CALLS", 11}, {"FAILED", 8}, {"LATENCY", 9}, {"CALLS/S", 9}}) {
      heading.Right(title, width, Style::kDim);
    }
    section.heading = heading.text();
    for (const WorkerRow& row : state_.workers()) {
      section.rows.push_back(Line()
                                 .Left(row.stage, 12)
                                 .Left(row.address, address_width - 1)
                                 .Add(" ")
                                 .Left(StateText(row.state), 7, StyleOf(row.state))
                                 .Right(fmt::format("{}", row.in_flight_count), 5)
                                 .Right(Grouped(row.call_count), 11)
                                 .Right(Grouped(row.failure_count), 8, BadUnlessZero(row.failure_count))
                                 .Right(LatencyText(row.call_seconds), 9)
                                 .Right(RateText(row.calls_per_second), 9)
                                 .text());
    }
    return section;
  }

  // Takes rows from the longest section until all fits, and says how many were taken.
  void Fit(std::vector<Section>& sections, int used) const {
    if (layout_.height == 0) return;
    const int room = std::max(0, layout_.height - used - 2 * static_cast<int>(sections.size()));
    std::vector<int> shown;
    int total = 0;
    for (const Section& section : sections) total += shown.emplace_back(static_cast<int>(section.rows.size()));
    while (total > room && *std::max_element(shown.begin(), shown.end()) > 0) {
      --*std::max_element(shown.begin(), shown.end());
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

  const ClusterState& state_;
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
  return TopPage(state, layout).Lines(address, trouble);
}

namespace {

using Json = nlohmann::ordered_json;

Json OrNull(const std::optional<double>& value) { return value.has_value() ? Json(*value) : Json(nullptr); }

std::string Lower(const std::string& name, const char* prefix) {
  return absl::AsciiStrToLower(absl::StripPrefix(name, prefix));
}

Json TotalsJson(const ClusterTotals& totals) {
  return {{"queued_count", totals.queued_count},
          {"running_count", totals.running_count},
          {"running_limit", totals.running_limit},
          {"succeeded_count", totals.succeeded_count},
          {"failed_count", totals.failed_count},
          {"retried_count", totals.retried_count},
          {"jobs_per_second", OrNull(totals.jobs_per_second)}};
}

Json BatchJson(const BatchRow& row) {
  const v1::Batch& batch = row.batch;
  Json remaining = nullptr;
  if (row.remaining.has_value()) remaining = absl::ToDoubleSeconds(*row.remaining);
  Json failures = Json::object();
  for (const v1::FailureCount& failure : batch.failures()) {
    failures[Lower(v1::FailureKind_Name(failure.kind()), "FAILURE_KIND_")] = failure.job_count();
  }
  return {{"id", batch.id()},
          {"label", batch.label()},
          {"state", Lower(v1::BatchState_Name(batch.state()), "BATCH_STATE_")},
          {"open", batch.open()},
          {"job_count", batch.job_count()},
          {"open_count", batch.open_count()},
          {"running_count", batch.running_count()},
          {"succeeded_count", batch.succeeded_count()},
          {"failed_count", batch.failed_count()},
          {"cancelled_count", batch.cancelled_count()},
          {"failures", failures},
          {"jobs_per_second", OrNull(row.jobs_per_second)},
          {"remaining_s", remaining}};
}

Json OrchestratorJson(const OrchestratorRow& row) {
  const v1::OrchestratorStatus& status = row.status;
  return {{"id", status.id()},
          {"host", status.host()},
          {"build", status.build()},
          {"running_count", status.running_count()},
          {"running_limit", status.running_limit()},
          {"succeeded_count", status.succeeded_count()},
          {"failed_count", status.failed_count()},
          {"retried_count", status.retried_count()},
          {"jobs_per_second", OrNull(row.jobs_per_second)},
          {"seen_s", absl::ToDoubleSeconds(row.age)}};
}

Json WorkerJson(const WorkerRow& row) {
  return {{"stage", row.stage},
          {"address", row.address},
          {"state", Lower(v1::WorkerState_Name(row.state), "WORKER_STATE_")},
          {"in_flight_count", row.in_flight_count},
          {"call_count", row.call_count},
          {"failure_count", row.failure_count},
          {"call_duration_s", row.call_seconds},
          {"calls_per_second", OrNull(row.calls_per_second)}};
}

template <typename Rows, typename ToJson>
Json Array(const Rows& rows, const ToJson& to_json) {
  Json array = Json::array();
  for (const auto& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

std::string TopJson(const ClusterState& state) {
  const Json json = {{"time", absl::FormatTime(absl::RFC3339_full, state.time(), absl::UTCTimeZone())},
                     {"totals", TotalsJson(state.totals())},
                     {"batches", Array(state.batches(), BatchJson)},
                     {"orchestrators", Array(state.orchestrators(), OrchestratorJson)},
                     {"workers", Array(state.workers(), WorkerJson)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace flair::cli
