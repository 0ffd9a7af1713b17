// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_deletion.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "absl/time/clock.h"
#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "cli/output/printable.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// Where no terminal is, how far it came is said so seldom.
constexpr absl::Duration kBetweenLines = absl::Minutes(1);

std::string NameOfBatch(const v1::Batch& batch) {
  return batch.label().empty() ? batch.id() : fmt::format("{} ({})", batch.id(), Printable(batch.label()));
}

absl::Status Confirm(const v1::Batch& batch) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) {
    return absl::InvalidArgumentError(
        fmt::format("--yes: missing; {} of batch {} would be gone for good, and nobody is there to be asked",
                    Counted(batch.job_count(), "job"), batch.id()));
  }
  fmt::print(stderr, "Delete batch {} with {} and what only they have? Nothing brings them back. [y/N] ",
             NameOfBatch(batch), Counted(batch.job_count(), "job"));
  std::string answer;
  std::getline(std::cin, answer);
  if (answer == "y" || answer == "Y" || answer == "yes") return absl::OkStatus();
  return EndWith(kExitStopped, "nothing was deleted");
}

// Says how far it came, on one line of a terminal.
class DeletionProgress {
 public:
  explicit DeletionProgress(int64_t job_count) : job_count_(job_count) {}
  ~DeletionProgress() {
    if (shown_ && on_terminal_) fmt::print(stderr, "\r\033[K");
  }
  void Show(const v1::DeleteBatchResponse& all) {
    if (!on_terminal_ && absl::Now() - told_ < kBetweenLines) return;
    told_ = absl::Now();
    shown_ = true;
    fmt::print(stderr, "{}deleted {} of {}, {}{}", on_terminal_ ? "\r" : "",
               std::min(job_count_, all.deleted_job_count()), Counted(job_count_, "job"),
               Counted(all.deleted_artifact_count(), "artifact"), on_terminal_ ? "\033[K" : "\n");
    std::fflush(stderr);
  }

 private:
  const int64_t job_count_;
  const bool on_terminal_ = ::isatty(STDERR_FILENO) != 0;
  absl::Time told_ = absl::Now();
  bool shown_ = false;
};

}  // namespace

absl::Status CheckHasEnded(const v1::Batch& batch) {
  if (!batch.open() && batch.open_count() == 0) return absl::OkStatus();
  const std::string why = batch.open_count() > 0
                              ? Counted(batch.open_count(), "job of it waits or runs", "jobs of it wait or run")
                              : "lines may still be added to it";
  return EndWith(kExitBadInput, fmt::format("batch {} has not ended: {}; end it first: flair batch cancel {}",
                                            batch.id(), why, batch.id()));
}

absl::Status DeleteWholeBatch(const v1::Batch& batch, BatchSession& batches, const DeletionOptions& options) {
  if (absl::Status status = CheckHasEnded(batch); !status.ok()) return status;
  if (absl::Status status = options.yes ? absl::OkStatus() : Confirm(batch); !status.ok()) return status;
  v1::DeleteBatchResponse all;
  {
    DeletionProgress progress(batch.job_count());
    while (!all.done()) {
      const absl::StatusOr<v1::DeleteBatchResponse> some = batches.DeleteBatch(batch.id());
      // Somebody else was faster with the rest of it.
      if (absl::IsNotFound(some.status()) && all.deleted_job_count() > 0) break;
      if (batches.stopped()) {
        return EndWith(kExitStopped, fmt::format("stopped; to go on: flair batch delete {}", batch.id()));
      }
      if (absl::IsFailedPrecondition(some.status())) {
        return EndWith(kExitBadInput, std::string(some.status().message()));
      }
      if (!some.ok()) return some.status();
      all.set_deleted_job_count(all.deleted_job_count() + some->deleted_job_count());
      all.set_deleted_artifact_count(all.deleted_artifact_count() + some->deleted_artifact_count());
      all.set_done(some->done());
      if (!all.done()) progress.Show(all);
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

}  // namespace flair::cli
