// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_progress.h"

#include <algorithm>
#include <vector>

#include "absl/strings/ascii.h"
#include "cli/batch/result_row.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kRecent = absl::Minutes(1);

}  // namespace

void RecentRate::See(absl::Time time, int64_t count) {
  points_.push_back({time, count});
  // One point older than a minute stays, to measure from.
  while (points_.size() > 2 && points_[1].time <= time - kRecent) points_.pop_front();
}

double RecentRate::PerSecond() const {
  if (points_.size() < 2) return 0;
  const double seconds = absl::ToDoubleSeconds(points_.back().time - points_.front().time);
  return seconds <= 0 ? 0 : static_cast<double>(points_.back().count - points_.front().count) / seconds;
}

std::string TimeLeftText(absl::Duration left) {
  const int64_t seconds = std::max<int64_t>(0, absl::ToInt64Seconds(left));
  if (seconds >= 2 * 86400) return fmt::format("{} days", seconds / 86400);
  if (seconds >= 3600) return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string FailuresText(const v1::Batch& batch) {
  std::string text;
  for (const v1::FailureCount& failure : batch.failures()) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", failure.job_count(), FailureKindWord(failure.kind()));
  }
  return text;
}

std::string BatchStateWord(v1::BatchState state) {
  if (!v1::BatchState_IsValid(state) || state == v1::BATCH_STATE_UNSPECIFIED) return "active";
  return absl::AsciiStrToLower(v1::BatchState_Name(state).substr(std::string("BATCH_STATE_").size()));
}

int64_t EndedCount(const v1::Batch& batch) {
  return int64_t{batch.succeeded_count()} + batch.failed_count() + batch.cancelled_count();
}

std::string StandingText(const BatchStanding& standing, size_t width) {
  const v1::Batch& batch = standing.batch;
  const int64_t ended = EndedCount(batch);
  // From what matters most to what matters least, so that a narrow terminal cuts the least.
  std::vector<std::string> parts = {fmt::format("{}/{}{}", ended, batch.job_count(), standing.submitting ? "+" : "")};
  if (batch.state() != v1::BATCH_STATE_ACTIVE && batch.state() != v1::BATCH_STATE_UNSPECIFIED) {
    parts.push_back(BatchStateWord(batch.state()));
  }
  if (batch.job_count() > 0 && !standing.submitting)
    parts.push_back(fmt::format("{} %", 100 * ended / batch.job_count()));
  if (standing.per_second > 0) {
    parts.push_back(fmt::format("{:.{}f}/s", standing.per_second, standing.per_second < 10 ? 2 : 0));
    const double left_s = static_cast<double>(batch.open_count()) / standing.per_second;
    if (batch.open_count() > 0 && !standing.submitting) parts.push_back(TimeLeftText(absl::Seconds(left_s)) + " left");
  }
  if (batch.running_count() > 0) parts.push_back(fmt::format("{} running", batch.running_count()));
  if (batch.failed_count() > 0) parts.push_back("failed: " + FailuresText(batch));
  if (batch.cancelled_count() > 0) parts.push_back(fmt::format("{} cancelled", batch.cancelled_count()));
  if (standing.rejected_count > 0) parts.push_back(Counted(standing.rejected_count, "line") + " rejected");
  if (standing.submitting) parts.push_back("submitting");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "  ") + part;
  if (width > 0 && text.size() > width) text.resize(width);
  return text;
}

}  // namespace flair::cli
