// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/lease_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Progress that could not be sent, or was not confirmed, is sent again so soon.
constexpr absl::Duration kAgain = absl::Milliseconds(500);
// Answers say by their subject what was asked: "progress_KEY_TIME", "record_KEY_0".
const char kProgress[] = "progress";
const char kRecord[] = "record";
const char kWake[] = "wake";

}  // namespace

absl::StatusOr<std::unique_ptr<LeaseKeeper>> LeaseKeeper::Start(QueueParts& parts) {
  ASSIGN_OR_RETURN(std::unique_ptr<NatsInbox> inbox, parts.connection->OpenInbox());
  return std::unique_ptr<LeaseKeeper>(new LeaseKeeper(parts, std::move(inbox)));
}

LeaseKeeper::LeaseKeeper(QueueParts& parts, std::unique_ptr<NatsInbox> inbox)
    : parts_(parts), inbox_(std::move(inbox)), thread_([this] { Run(); }) {}

LeaseKeeper::~LeaseKeeper() {
  inbox_->Close();
  thread_.join();
}

void LeaseKeeper::Add(std::shared_ptr<Hold> hold) {
  const absl::Duration now = parts_.clock.Elapsed();
  std::lock_guard lock(mutex_);
  kept_[next_key_++] = {std::move(hold), now, now + parts_.lease / 3};
}

void LeaseKeeper::Remove(const Hold& hold) {
  std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const auto& entry) { return entry.second.hold.get() == &hold; });
}

void LeaseKeeper::Look(const std::string& job_id) {
  bool wake = false;
  {
    std::lock_guard lock(mutex_);
    for (auto& [key, kept] : kept_) {
      if (kept.hold->job_id != job_id) continue;
      kept.due = absl::ZeroDuration();
      wake = true;
    }
  }
  if (wake) (void)parts_.connection->Publish({inbox_->subject() + "." + kWake, "", {}});
}

void LeaseKeeper::LookAtAll() {
  {
    std::lock_guard lock(mutex_);
    for (auto& [key, kept] : kept_) kept.due = absl::ZeroDuration();
  }
  (void)parts_.connection->Publish({inbox_->subject() + "." + kWake, "", {}});
}

void LeaseKeeper::Run() {
  while (true) {
    const absl::Duration wait = SendDue();
    const absl::StatusOr<NatsMessage> message = inbox_->Next(wait);
    if (message.ok()) Receive(*message);
    if (!message.ok() && !absl::IsDeadlineExceeded(message.status())) return;
  }
}

// Sends what is due, gives up what was not confirmed for too long, and returns how long to wait for answers.
absl::Duration LeaseKeeper::SendDue() {
  // A hold that comes while this thread waits is first due after a third of the lease.
  absl::Duration wait = parts_.lease / 6;
  const absl::Duration now = parts_.clock.Elapsed();
  std::vector<std::shared_ptr<Hold>> lost;
  {
    std::lock_guard lock(mutex_);
    // The servers may deliver the jobs of those.
    std::erase_if(kept_, [](const auto& entry) { return entry.second.hold->lost.load(); });
    for (auto& [key, kept] : kept_) {
      if (now - kept.confirmed > parts_.lease) {
        lost.push_back(kept.hold);
        continue;
      }
      if (now >= kept.due) {
        const bool sent = Send(key, kept, now).ok();
        // Sooner than a third of the lease until it is confirmed; Receive puts it off.
        kept.due = now + (sent ? std::min(parts_.lease / 3, 4 * kAgain) : std::min(parts_.lease / 3, kAgain));
      }
      wait = std::min(wait, kept.due - now);
    }
  }
  for (const std::shared_ptr<Hold>& hold : lost) hold->Lose();
  return std::max(wait, absl::Milliseconds(1));
}

absl::Status LeaseKeeper::Send(int64_t key, const Kept& kept, absl::Duration now) {
  RETURN_IF_ERROR(parts_.connection->Publish(
      {kept.hold->acknowledge, "+WPI", {}},
      fmt::format("{}.{}_{}_{}", inbox_->subject(), kProgress, key, absl::ToInt64Milliseconds(now))));
  return parts_.connection->Publish(parts_.jobs.GetRequest(kept.hold->job_id),
                                    fmt::format("{}.{}_{}_0", inbox_->subject(), kRecord, key));
}

void LeaseKeeper::Receive(const NatsMessage& message) {
  const std::string what = message.subject.substr(message.subject.rfind('.') + 1);
  const std::vector<std::string> parts = absl::StrSplit(what, '_');
  int64_t key = 0;
  int64_t sent_ms = 0;
  if (parts.size() != 3 || message.status != 0) return;
  if (!absl::SimpleAtoi(parts[1], &key) || !absl::SimpleAtoi(parts[2], &sent_ms)) return;
  std::shared_ptr<Hold> hold;
  {
    std::lock_guard lock(mutex_);
    const auto found = kept_.find(key);
    if (found == kept_.end()) return;
    hold = found->second.hold;
    if (parts[0] == kProgress) {
      Kept& kept = found->second;
      kept.confirmed = std::max(kept.confirmed, absl::Milliseconds(sent_ms));
      kept.due = std::max(kept.due, kept.confirmed + parts_.lease / 3);
    }
  }
  if (parts[0] == kRecord) ReceiveRecord(*hold, message);
}

void LeaseKeeper::ReceiveRecord(Hold& hold, const NatsMessage& message) {
  const absl::StatusOr<RevisedJob> record = parts_.ParseJob(hold.job_id, parts_.jobs.ParseEntry(message));
  if (!record.ok() || hold.closing) return;
  if (record->value.holder() != hold.holder) {
    hold.Lose();
  } else if (record->value.cancel_requested() && !hold.cancel_requested) {
    hold.cancel_requested = true;
    hold.cancellation.Cancel();
  }
}

}  // namespace flair::orchestrator
