// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/results_file.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

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
  return state == v1::BATCH_STATE_UNSPECIFIED ? "active" : EnumInWords(state);
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

namespace {

constexpr absl::Duration kRefresh = absl::Seconds(1);
constexpr absl::Duration kFirstLine = absl::Seconds(5);
constexpr absl::Duration kLines = absl::Minutes(1);
constexpr absl::Duration kChecks = absl::Seconds(10);

size_t TerminalWidth() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col - 1u : 79u;
}

}  // namespace

BatchMonitor::BatchMonitor(Session& session, std::string batch_id, Options options)
    : session_(session),
      batch_id_(std::move(batch_id)),
      options_(std::move(options)),
      on_terminal_(ChooseProgressForm(false, false) == ProgressForm::kTerminal),
      next_line_(absl::Now() + kFirstLine),
      next_check_(absl::Now() + absl::Seconds(3)),
      thread_([this] { Run(); }) {}

BatchMonitor::~BatchMonitor() {
  end_.Cancel();
  thread_.join();
  if (line_shown_) std::fprintf(stderr, "\r\x1b[K");
}

// std::fprintf, which does not throw in a thread when nobody reads.
void BatchMonitor::Print(const std::string& line) {
  std::fprintf(stderr, "%s%s\n", line_shown_ ? "\r\x1b[K" : "", line.c_str());
  line_shown_ = false;
}

void BatchMonitor::Say(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (options_.quiet || text == last_said_) return;
  last_said_ = text;
  Print(Printable(text));
}

void BatchMonitor::Show(const v1::Batch& batch, absl::Time now) {
  const std::lock_guard lock(mutex_);
  rate_.Add("", now, EndedCount(batch));
  if (options_.quiet) return;
  BatchStanding standing{.batch = batch, .per_second = rate_.PerSecond("").value_or(0)};
  options_.complete(standing);
  if (on_terminal_) {
    std::fprintf(stderr, "\r\x1b[K\x1b[2m%s\x1b[0m", StandingText(standing, TerminalWidth()).c_str());
    std::fflush(stderr);
    line_shown_ = true;
  } else if (now >= next_line_) {
    Print(StandingText(standing));
    next_line_ = now + kLines;
  }
}

void BatchMonitor::WarnIfUnserved(const v1::Batch& batch, absl::Time now) {
  if (options_.remedy.empty() || batch.open_count() == 0) return;
  if (batch.state() == v1::BATCH_STATE_PAUSED || now < next_check_) return;
  next_check_ = now + kChecks;
  const absl::StatusOr<v1::GetClusterResponse> cluster = session_.GetCluster();
  if (!cluster.ok()) return;
  const bool served = std::ranges::any_of(cluster->orchestrators(),
                                          [](const v1::OrchestratorStatus& one) { return one.running_limit() > 0; });
  if (!served && batch.running_count() == 0) Say("no orchestrator takes jobs from the queue: " + options_.remedy);
  if (const std::string away = StagesAway(*cluster); !away.empty()) Say("jobs wait: " + away);
}

void BatchMonitor::Run() {
  while (!WaitUnlessStopped(end_, kRefresh)) {
    if (session_.stopped()) return;
    const absl::StatusOr<v1::Batch> batch = session_.GetBatch(batch_id_);
    if (!batch.ok()) continue;  // whoever collects says why
    const absl::Time now = absl::Now();
    Show(*batch, now);
    WarnIfUnserved(*batch, now);
  }
}

}  // namespace flair::cli
