// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_monitor.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "absl/time/clock.h"
#include "cli/output/printable.h"
#include "cli/progress/progress.h"

namespace flair::cli {
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

BatchMonitor::BatchMonitor(BatchSession& session, std::string batch_id, Options options)
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
  rate_.See(now, EndedCount(batch));
  if (options_.quiet) return;
  BatchStanding standing{.batch = batch, .per_second = rate_.PerSecond()};
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
  if (options_.remedy.empty() || batch.open_count() == 0 || batch.running_count() > 0) return;
  if (batch.state() == v1::BATCH_STATE_PAUSED || now < next_check_) return;
  next_check_ = now + kChecks;
  const absl::StatusOr<v1::GetClusterResponse> cluster = session_.GetCluster();
  if (!cluster.ok()) return;
  const bool served = std::ranges::any_of(cluster->orchestrators(),
                                          [](const v1::OrchestratorStatus& one) { return one.running_limit() > 0; });
  if (!served) Say("nobody takes jobs from the queue: " + options_.remedy);
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
