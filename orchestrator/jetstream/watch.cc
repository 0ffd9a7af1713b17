// SPDX-License-Identifier: GPL-3.0-or-later
// What the queue does by itself: it starts, reads notices, looks periodically, and says so to who listens.
#include <fmt/format.h>

#include <random>

#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr absl::Duration kLook = absl::Seconds(1);
// Watchers are told for nothing every so many looks, since notices may be lost.
constexpr int kLooksPerTelling = 2;
// Batches of earlier processes that are looked at once.
constexpr int kEarlierBatches = 200;
constexpr int kMostOrchestrators = 10000;
// Batches that are cared for in one look.
constexpr int kRepairedAtOnce = 20;

std::string RandomName() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

}  // namespace

absl::StatusOr<std::unique_ptr<WorkQueue>> JetStreamWorkQueue::Open(std::unique_ptr<QueueParts> parts) {
  std::unique_ptr<JetStreamWorkQueue> queue(new JetStreamWorkQueue(std::move(parts)));
  RETURN_IF_ERROR(queue->Start());
  return queue;
}

JetStreamWorkQueue::JetStreamWorkQueue(std::unique_ptr<QueueParts> parts)
    : parts_(std::move(parts)),
      process_(RandomName()),
      ends_(*parts_),
      consumers_(*parts_),
      repair_(*parts_, ends_, consumers_),
      users_(*parts_),
      keeper_(*parts_) {}

absl::Status JetStreamWorkQueue::Start() {
  ASSIGN_OR_RETURN(notices_, parts_->connection->Subscribe(parts_->names.news_subject()));
  // Those that wait are known before the first Take.
  ASSIGN_OR_RETURN(const auto messages, consumers_.Look(">"));
  consumers_.See(messages);
  notice_thread_ = std::thread([this] { ReadNotices(); });
  looker_.emplace([this] { return Look(); });
  return absl::OkStatus();
}

JetStreamWorkQueue::~JetStreamWorkQueue() {
  if (notices_ != nullptr) notices_->Close();
  if (notice_thread_.joinable()) notice_thread_.join();
  looker_.reset();
}

void JetStreamWorkQueue::Listen(Listener listener) {
  std::lock_guard lock(listener_mutex_);
  listener_ = std::move(listener);
}

void JetStreamWorkQueue::NotifyListenerOfWork() {
  std::lock_guard lock(listener_mutex_);
  listener_.work();
}

void JetStreamWorkQueue::NotifyListenerOfJob(const std::string& job_id) {
  std::lock_guard lock(listener_mutex_);
  listener_.changed(job_id);
}

void JetStreamWorkQueue::NotifyListenerOfBatch(const std::string& batch_id) {
  std::lock_guard lock(listener_mutex_);
  listener_.batch_changed(batch_id);
}

// There is a job in a consumer: this process need not wait for the notice of it.
void JetStreamWorkQueue::Queued(const std::string& consumer) {
  consumers_.Want(consumer);
  parts_->Notify(Notice::Kind::kWork, consumer);
}

void JetStreamWorkQueue::ScheduleRepair(const std::string& batch_id) {
  std::lock_guard lock(repair_mutex_);
  to_repair_.insert(batch_id);
}

void JetStreamWorkQueue::ReadNotices() {
  while (true) {
    const absl::StatusOr<NatsMessage> message = notices_->Next(absl::Minutes(1));
    if (absl::IsDeadlineExceeded(message.status())) continue;
    if (!message.ok()) return;
    const Notice notice = ReadNotice(message->content);
    switch (notice.kind) {
      case Notice::Kind::kWork:
        consumers_.Want(notice.subject);
        NotifyListenerOfWork();
        break;
      case Notice::Kind::kHold:
        keeper_.Look(notice.subject);
        NotifyListenerOfJob(notice.subject);
        break;
      case Notice::Kind::kJob:
        NotifyListenerOfJob(notice.subject);
        if (!notice.batch_id.empty()) NotifyListenerOfBatch(notice.batch_id);
        break;
      case Notice::Kind::kBatch:
        consumers_.WantBatch(notice.subject);
        ScheduleRepair(notice.subject);
        NotifyListenerOfWork();
        NotifyListenerOfBatch(notice.subject);
        break;
    }
  }
}

absl::Duration JetStreamWorkQueue::Look() {
  const int64_t reconnects = parts_->connection->reconnect_count();
  if (looks_ == 0) {
    ListFilter earlier;
    earlier.limit = kEarlierBatches;
    const absl::StatusOr<std::vector<v1::Batch>> batches = ListBatches(earlier);
    if (batches.ok()) {
      for (const v1::Batch& batch : *batches) ScheduleRepair(batch.id());
    }
  } else {
    const bool reconnected = reconnects != reconnects_;
    if (reconnected) keeper_.Look("");
    if (reconnected || looks_ % kLooksPerTelling == 0) {
      NotifyListenerOfJob("");
      NotifyListenerOfBatch("");
    }
    if (parts_->connection->connected()) LookOnce();
  }
  reconnects_ = reconnects;
  ++looks_;
  return kLook;
}

// Asks for what waits, and sees to batches of which nothing does.
void JetStreamWorkQueue::LookOnce() {
  const auto messages = consumers_.Look(">");
  if (!messages.ok()) return;
  for (const Consumer& consumer : consumers_.See(*messages)) {
    if (consumer.batch_id.empty()) {
      (void)consumers_.Remove(consumer, 0);
    } else {
      ScheduleRepair(consumer.batch_id);
    }
  }
  if (!messages->empty()) NotifyListenerOfWork();
  std::vector<std::string> batches;
  {
    std::lock_guard lock(repair_mutex_);
    while (!to_repair_.empty() && batches.size() < kRepairedAtOnce) {
      batches.push_back(to_repair_.extract(to_repair_.begin()).value());
    }
  }
  std::set<std::string> with_messages;
  for (const auto& [subject, count] : *messages) with_messages.insert(consumers_.ConsumerOf(subject).batch_id);
  for (const std::string& batch_id : batches) {
    const absl::StatusOr<bool> again = repair_.Close(batch_id, with_messages.contains(batch_id));
    if (!again.ok() || *again) ScheduleRepair(batch_id);
  }
}

absl::Status JetStreamWorkQueue::ReportStatus(const v1::OrchestratorStatus& status) {
  return parts_->statuses.Put(OwnerToken(status.id()), status.SerializeAsString()).status();
}

absl::StatusOr<std::vector<v1::OrchestratorStatus>> JetStreamWorkQueue::Orchestrators() {
  ASSIGN_OR_RETURN(
      const std::vector<StoredMessage> messages,
      parts_->streams.Read(parts_->statuses.stream(), parts_->statuses.SubjectOf(">"), 1, kMostOrchestrators));
  std::vector<v1::OrchestratorStatus> statuses;
  for (const StoredMessage& message : messages) {
    if (!statuses.emplace_back().ParseFromString(message.content)) statuses.pop_back();
  }
  return statuses;
}

}  // namespace flair::orchestrator
