// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_run.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "cli/batch/collector.h"
#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// Where the handler writes; signals know of no object.
std::atomic<int> signal_pipe = -1;
std::atomic<int> signal_count = 0;

constexpr char kSignal = 's';
constexpr char kEnd = 'e';

void OnSignal(int) {
  if (signal_count.fetch_add(1) > 0) ::_exit(kExitStopped);
  const ssize_t ignored = ::write(signal_pipe, &kSignal, 1);
  (void)ignored;
}

void SetHandler(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

// Rows that may wait for the files of others.
constexpr size_t kHeldRows = 2048;

absl::Status Collect(Session& session, BatchFolder& folder, const std::string& batch_id) {
  ASSIGN_OR_RETURN(const BatchPlace place, folder.Place());
  ASSIGN_OR_RETURN(KeptFiles kept, KeptFiles::Parse(place.kept));
  const auto shard_size = static_cast<size_t>(place.shard_size);
  std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder.path());
  if (shard_size > 0) {
    ASSIGN_OR_RETURN(writer, MakeTarShards(folder.path(), place.shard_size));
  }
  // Shards are for those who train on them: no failures there.
  const Collector::Options options{
      .kept = std::move(kept), .keep_failed = shard_size == 0, .held_limit = kHeldRows + shard_size, .end_after = {}};
  return Collector(session, folder.results(), *writer, options).Run(batch_id);
}

// The submission in a thread of its own; when it fails, everything stops.
class SubmittingThread {
 public:
  SubmittingThread(Submission* submission, const v1::Batch& batch, Interruption& interruption) {
    if (submission == nullptr) return;
    running_ = true;
    thread_ = std::thread([this, submission, &batch, &interruption] {
      status_ = submission->Run(batch);
      running_ = false;
      if (!status_.ok()) interruption.stop().Cancel();
    });
  }
  ~SubmittingThread() { (void)End(); }
  bool running() const { return running_; }
  absl::Status End() {
    if (thread_.joinable()) thread_.join();
    return status_;
  }

 private:
  std::atomic<bool> running_ = false;
  absl::Status status_;
  std::thread thread_;
};

absl::Status GoesOn(const BatchFolder& folder, const v1::Batch& batch, bool with_file) {
  const std::string how =
      with_file ? "give the same command again" : fmt::format("flair batch watch {}", folder.path().string());
  return EndWith(kExitStopped, "stopped; batch {} continues where it was: {}", batch.id(), how);
}

absl::Status Summarize(Session& session, const v1::Batch& batch, BatchFolder& folder, const BatchRunOptions& options) {
  ASSIGN_OR_RETURN(const BatchReport report, MakeBatchReport(folder.results()));
  if (options.json) {
    fmt::print("{}\n", JsonText(report));
  } else if (!options.quiet) {
    fmt::print(stderr, "{}", BatchOutcomeText(report));
  }
  const absl::StatusOr<v1::Batch> now = session.GetBatch(batch.id());
  if (now.ok() && now->state() == v1::BATCH_STATE_CANCELLED) {
    return EndWith(kExitCancelled, "batch {} was cancelled", batch.id());
  }
  return EndOf(report, folder.path().string());
}

std::string NameOfBatch(const v1::Batch& batch) {
  return batch.label().empty() ? batch.id() : fmt::format("{} ({})", batch.id(), Printable(batch.label()));
}

absl::Status Confirm(const v1::Batch& batch) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) {
    return InvalidArgument(
        "--yes: missing; this deletes {} of batch {} for good, and there is no terminal to confirm it",
        Counted(batch.job_count(), "job"), batch.id());
  }
  fmt::print(stderr, "Delete batch {} with {} and the artifacts that no other job has? This cannot be undone. [y/N] ",
             NameOfBatch(batch), Counted(batch.job_count(), "job"));
  std::string answer;
  std::getline(std::cin, answer);
  if (answer == "y" || answer == "Y" || answer == "yes") return absl::OkStatus();
  return EndWith(kExitStopped, "nothing was deleted");
}

constexpr absl::Duration kRefresh = absl::Seconds(1);
constexpr absl::Duration kFirstLine = absl::Seconds(5);
constexpr absl::Duration kLines = absl::Minutes(1);
constexpr absl::Duration kChecks = absl::Seconds(10);

size_t TerminalWidth() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col - 1u : 79u;
}

// Why the batch cannot be deleted yet, and what to do; OK when it can.
absl::Status CheckHasEnded(const v1::Batch& batch) {
  if (!batch.open() && batch.open_count() == 0) return absl::OkStatus();
  const std::string why = batch.open_count() > 0 ? Counted(batch.open_count(), "of its jobs is waiting or running",
                                                           "of its jobs are waiting or running")
                                                 : "lines may still be added to it";
  return EndWith(kExitBadInput, "batch {} has not ended: {}; end it first: flair batch cancel {}", batch.id(), why,
                 batch.id());
}

}  // namespace

Interruption::Interruption() {
  if (::pipe2(pipe_, O_CLOEXEC) != 0) return;  // then signals end the process as they always do
  signal_pipe = pipe_[1];
  signal_count = 0;
  thread_ = std::thread([this] {
    char read = kEnd;
    while (::read(pipe_[0], &read, 1) < 0) {
    }
    if (read != kSignal) return;
    by_signal_ = true;
    stop_.Cancel();
  });
  SetHandler(OnSignal);
}

Interruption::~Interruption() {
  if (!thread_.joinable()) return;
  SetHandler(SIG_DFL);
  const ssize_t ignored = ::write(pipe_[1], &kEnd, 1);
  (void)ignored;
  thread_.join();
  ::close(pipe_[0]);
  ::close(pipe_[1]);
}

absl::Status EndOf(const BatchReport& report, const std::string& name) {
  const auto count = [&report](const char* field) { return CountIn(report, field); };
  if (count("failed_count") > 0) {
    return EndWith(kExitSomeFailed, "{} of {} failed; more: flair batch report {}; again: flair batch retry {}",
                   count("failed_count"), Counted(count("job_count"), "job"), name, name);
  }
  if (count("not_fetched_count") > 0) {
    return EndWith(kExitSomeFailed, "the results of {} could not be fetched; again: flair batch watch {}",
                   Counted(count("not_fetched_count"), "job"), name);
  }
  if (count("rejected_count") > 0) {
    return EndWith(kExitSomeFailed, "{} rejected; {}/rejected.jsonl says why",
                   Counted(count("rejected_count"), "line was", "lines were"), name);
  }
  if (count("cancelled_count") > 0) {
    return EndWith(kExitSomeFailed, Counted(count("cancelled_count"), "job was cancelled", "jobs were cancelled"));
  }
  return absl::OkStatus();
}

absl::Status RunBatch(const v1::Batch& batch, Session& session, BatchFolder& folder, Submission* submission,
                      Interruption& interruption, const BatchRunOptions& options) {
  absl::Status collected;
  absl::Status submitted;
  {
    SubmittingThread submitting(submission, batch, interruption);
    const BatchMonitor monitor(
        session, batch.id(),
        {.quiet = options.quiet || options.json, .remedy = options.remedy, .complete = [&](BatchStanding& standing) {
           standing.submitting = submitting.running();
           if (submission != nullptr) standing.rejected_count = submission->rejected_count();
         }});
    if (!options.submit_only) {
      collected = Collect(session, folder, batch.id());
      if (!collected.ok()) interruption.stop().Cancel();
    }
    submitted = submitting.End();
  }
  if (interruption.by_signal()) return GoesOn(folder, batch, submission != nullptr);
  // What went wrong first stopped the other one.
  if (!submitted.ok() && !absl::IsCancelled(submitted)) return submitted;
  if (!collected.ok()) return collected;
  if (options.submit_only) return absl::OkStatus();
  return Summarize(session, batch, folder, options);
}

absl::Status DeleteWholeBatch(const v1::Batch& batch, Session& batches, const DeletionOptions& options) {
  RETURN_IF_ERROR(CheckHasEnded(batch));
  RETURN_IF_ERROR(options.yes ? absl::OkStatus() : Confirm(batch));
  v1::DeleteBatchResponse all;
  {
    SlowNote note("deleting");
    while (!all.done()) {
      const absl::StatusOr<v1::DeleteBatchResponse> some = batches.DeleteBatch(batch.id());
      // Somebody else was faster with the rest of it.
      if (absl::IsNotFound(some.status()) && all.deleted_job_count() > 0) break;
      if (batches.stopped()) return EndWith(kExitStopped, "stopped; to continue: flair batch delete {}", batch.id());
      if (absl::IsFailedPrecondition(some.status())) {
        return EndWith(kExitBadInput, std::string(some.status().message()));
      }
      if (!some.ok()) return some.status();
      all.set_deleted_job_count(all.deleted_job_count() + some->deleted_job_count());
      all.set_deleted_artifact_count(all.deleted_artifact_count() + some->deleted_artifact_count());
      all.set_done(some->done());
      note.Set(fmt::format("deleted {} of {}, {}", std::min<int64_t>(batch.job_count(), all.deleted_job_count()),
                           Counted(batch.job_count(), "job"), Counted(all.deleted_artifact_count(), "artifact")));
    }
  }
  all.set_done(true);
  if (options.json) {
    fmt::print("{}\n", ToJsonLine(all));
  } else {
    fmt::print("deleted batch {}: {}, and {} that no other job had\n", NameOfBatch(batch),
               Counted(all.deleted_job_count(), "job"), Counted(all.deleted_artifact_count(), "artifact"));
  }
  return absl::OkStatus();
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
