// SPDX-License-Identifier: GPL-3.0-or-later
// What the queue does by itself: it starts, hears news, looks now and then, and says so to who listens.
#include <fmt/format.h>

#include <random>

#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr absl::Duration kLook = absl::Seconds(1);
// Watchers are told for nothing every so many looks, since news may be lost.
constexpr int kLooksPerTelling = 2;
// Batches of earlier processes that are looked at once.
constexpr int kEarlierBatches = 200;
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
      users_(*parts_) {}

absl::Status JetStreamWorkQueue::Start() {
  ASSIGN_OR_RETURN(news_, parts_->connection->Subscribe(parts_->names.news_subject()));
  ASSIGN_OR_RETURN(keeper_, LeaseKeeper::Start(*parts_));
  // Those that wait are known before the first Take.
  ASSIGN_OR_RETURN(const auto messages, consumers_.Look(">"));
  consumers_.See(messages);
  news_thread_ = std::thread([this] { HearNews(); });
  look_thread_ = std::thread([this] { LookNowAndThen(); });
  return absl::OkStatus();
}

JetStreamWorkQueue::~JetStreamWorkQueue() {
  {
    std::lock_guard lock(stop_mutex_);
    stopping_ = true;
    stop_.notify_all();
  }
  if (news_ != nullptr) news_->Close();
  if (news_thread_.joinable()) news_thread_.join();
  if (look_thread_.joinable()) look_thread_.join();
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

// There is a job in a consumer: this process need not wait for the news of it.
void JetStreamWorkQueue::Queued(const std::string& consumer) {
  consumers_.Want(consumer);
  parts_->NotifyWork(consumer);
}

void JetStreamWorkQueue::ScheduleRepair(const std::string& batch_id) {
  std::lock_guard lock(stop_mutex_);
  to_repair_.insert(batch_id);
}

void JetStreamWorkQueue::HearNews() {
  while (true) {
    const absl::StatusOr<NatsMessage> message = news_->Next(absl::Minutes(1));
    if (absl::IsDeadlineExceeded(message.status())) continue;
    if (!message.ok()) return;
    const News news = ReadNews(message->content);
    switch (news.kind) {
      case NewsKind::kWork:
        consumers_.Want(news.subject);
        NotifyListenerOfWork();
        break;
      case NewsKind::kHold:
        keeper_->Look(news.subject);
        NotifyListenerOfJob(news.subject);
        break;
      case NewsKind::kJob:
        NotifyListenerOfJob(news.subject);
        if (!news.batch_id.empty()) NotifyListenerOfBatch(news.batch_id);
        break;
      case NewsKind::kBatch:
        consumers_.WantBatch(news.subject);
        ScheduleRepair(news.subject);
        NotifyListenerOfWork();
        NotifyListenerOfBatch(news.subject);
        break;
      case NewsKind::kUnknown:
        break;
    }
  }
}

void JetStreamWorkQueue::LookNowAndThen() {
  ListFilter earlier;
  earlier.limit = kEarlierBatches;
  const absl::StatusOr<std::vector<v1::Batch>> batches = ListBatches(earlier);
  if (batches.ok()) {
    for (const v1::Batch& batch : *batches) ScheduleRepair(batch.id());
  }
  int64_t reconnects = parts_->connection->reconnect_count();
  for (int look = 1;; ++look) {
    {
      std::unique_lock lock(stop_mutex_);
      if (stop_.wait_for(lock, absl::ToChronoMilliseconds(kLook), [this] { return stopping_; })) return;
    }
    const int64_t reconnects_now = parts_->connection->reconnect_count();
    if (reconnects_now != reconnects) keeper_->LookAtAll();
    if (reconnects_now != reconnects || look % kLooksPerTelling == 0) {
      NotifyListenerOfJob("");
      NotifyListenerOfBatch("");
    }
    reconnects = reconnects_now;
    if (parts_->connection->connected()) LookOnce();
  }
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
    std::lock_guard lock(stop_mutex_);
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
  const auto messages =
      parts_->reader.Read(parts_->statuses.stream(), {.filter = parts_->statuses.SubjectOf(">"), .limit = 10000});
  if (!messages.ok()) return messages.status();
  std::vector<v1::OrchestratorStatus> statuses;
  for (const StreamReader::Message& message : *messages) {
    if (!statuses.emplace_back().ParseFromString(message.content)) statuses.pop_back();
  }
  return statuses;
}

}  // namespace flair::orchestrator
