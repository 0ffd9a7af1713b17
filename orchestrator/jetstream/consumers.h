// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// One durable consumer of the queue stream, which delivers jobs in the order in which they came: those without a batch,
// those of one batch, or one job that was asked for by its id.
struct Consumer {
  // "single", "batch-ID", "named-ID".
  std::string name;
  // What it delivers, with wildcards.
  std::string filter;
  // Of a batch's.
  std::string batch_id;
};

// A job that a consumer delivered to this process. It is delivered again if no progress is reported for a lease.
struct Delivery {
  std::string job_id;
  // The subject of acknowledgements.
  std::string acknowledge;
  // Of its message in the stream; 0 when unknown.
  uint64_t sequence = 0;
  int64_t delivery_count = 0;
};

// The consumers of the queue and the next job of each. Learns of consumers by Want and See, and polls only those that
// may have jobs. Thread-safe.
class Consumers {
 public:
  explicit Consumers(QueueParts& parts) : parts_(parts) {}

  // The consumer of a subject of the queue stream.
  Consumer ConsumerOf(const std::string& subject) const {
    // NAME.queue.OWNER.KIND.ID
    const std::string_view owner = TokenAt(subject, 2);
    const std::string_view kind = TokenAt(subject, 3);
    const std::string id(TokenAt(subject, 4));
    if (kind == "batch") return {"batch-" + id, parts_.names.Batch(owner, id), id};
    if (kind == "named") return {"named-" + id, parts_.names.Named(owner, id), ""};
    return {kSingle, parts_.names.Single("*"), ""};
  }

  // There may be something under this subject.
  void Want(const std::string& subject) {
    const Consumer consumer = ConsumerOf(subject);
    std::lock_guard lock(mutex_);
    State& state = consumers_[consumer.name];
    state.consumer = consumer;
    ++state.wanted;
  }

  // Forgets that the batch's consumer was polled.
  void WantBatch(const std::string& batch_id) {
    std::lock_guard lock(mutex_);
    const auto found = consumers_.find("batch-" + batch_id);
    if (found != consumers_.end()) ++found->second.wanted;
  }

  // Messages by subject, as the stream counts them: waiting and running jobs.
  absl::StatusOr<std::map<std::string, int64_t>> Look(const std::string& filter) {
    return parts_.streams.Subjects(parts_.names.queue_stream(), filter);
  }

  // Wants all consumers of those, and returns the consumers without messages left.
  std::vector<Consumer> See(const std::map<std::string, int64_t>& messages_by_subject) {
    std::set<std::string> there = {kSingle};
    for (const auto& [subject, count] : messages_by_subject) {
      there.insert(ConsumerOf(subject).name);
      Want(subject);
    }
    std::vector<Consumer> gone;
    std::lock_guard lock(mutex_);
    for (const auto& [name, state] : consumers_) {
      if (!there.contains(name)) gone.push_back(state.consumer);
    }
    for (const Consumer& consumer : gone) consumers_.erase(consumer.name);
    return gone;
  }

  // Consumers that may have something, in the order in which to ask: jobs without a batch, then the batches in turn.
  std::vector<Consumer> Candidates(const TakeFilter& filter) {
    std::vector<Consumer> first;
    std::vector<Consumer> later;
    std::vector<Consumer> earlier;
    std::lock_guard lock(mutex_);
    for (const auto& [name, state] : consumers_) {
      if (state.wanted == state.asked) continue;
      const Consumer& consumer = state.consumer;
      if (!filter.any && !filter.batch_ids.contains(consumer.batch_id) &&
          !(name.starts_with("named-") && filter.job_ids.contains(name.substr(6)))) {
        continue;
      }
      if (consumer.batch_id.empty()) {
        first.push_back(consumer);
      } else {
        (name > last_turn_ ? later : earlier).push_back(consumer);
      }
    }
    first.insert(first.end(), later.begin(), later.end());
    first.insert(first.end(), earlier.begin(), earlier.end());
    return first;
  }

  // The next of a consumer; nothing when it has none now.
  absl::StatusOr<std::optional<Delivery>> Next(const Consumer& consumer) {
    int64_t wanted = 0;
    bool has_consumer = false;
    {
      std::lock_guard lock(mutex_);
      const auto found = consumers_.find(consumer.name);
      if (found == consumers_.end()) return std::nullopt;
      wanted = found->second.wanted;
      has_consumer = found->second.has_consumer;
    }
    if (!has_consumer) {
      RETURN_IF_ERROR(
          parts_.streams.MakeConsumer(parts_.names.queue_stream(), consumer.name, consumer.filter, parts_.lease));
    }
    absl::StatusOr<std::optional<Delivery>> delivery = Ask(consumer);
    std::lock_guard lock(mutex_);
    const auto found = consumers_.find(consumer.name);
    if (found == consumers_.end()) return delivery;
    // A consumer that is gone, because its batch had ended before, does not answer: the next poll creates it again.
    found->second.has_consumer = delivery.ok();
    if (delivery.ok() && !delivery->has_value()) found->second.asked = wanted;
    return delivery;
  }

  // The batch had its turn.
  void HadTurn(const Consumer& consumer) {
    if (consumer.batch_id.empty()) return;
    std::lock_guard lock(mutex_);
    last_turn_ = consumer.name;
  }

  // Removes the consumer and its messages up to that sequence, whose jobs have ended. A job that is being retried has a
  // later message, and polling for it creates the consumer again.
  absl::Status Remove(const Consumer& consumer, uint64_t ended_sequence) {
    const std::string stream = parts_.names.queue_stream();
    RETURN_IF_ERROR(parts_.streams.Purge(stream, consumer.filter, ended_sequence + 1));
    return parts_.streams.RemoveConsumer(stream, consumer.name);
  }

  // Of the consumers of those together.
  absl::StatusOr<Streams::Depth> DepthOf(const std::map<std::string, int64_t>& messages_by_subject) {
    // By consumer, since the owners of jobs without a batch share one.
    std::map<std::string, int64_t> messages;
    for (const auto& [subject, count] : messages_by_subject) {
      const Consumer consumer = ConsumerOf(subject);
      if (!consumer.name.starts_with("named-")) messages[consumer.name] += count;
    }
    std::vector<std::string> names;
    for (const auto& [name, count] : messages) names.push_back(name);
    const auto depths = parts_.streams.DepthOfEach(parts_.names.queue_stream(), names);
    Streams::Depth all;
    for (size_t i = 0; i < names.size(); ++i) {
      // A missing consumer was never polled.
      const bool missing = absl::IsNotFound(depths[i].status());
      if (!missing && !depths[i].ok()) return depths[i].status();
      all.waiting += missing ? messages[names[i]] : depths[i]->waiting;
      all.delivered += missing ? 0 : depths[i]->delivered;
    }
    return all;
  }

 private:
  static constexpr absl::Duration kDeliveryLimit = absl::Seconds(2);
  // One message, within 0.1 s. Without an expiry the server keeps a pull request that it cannot answer, and delivers
  // the next message to a requester that is long gone. "no_wait" alone has no expiry.
  static constexpr char kQuestion[] = R"({"batch":1,"expires":100000000})";
  static constexpr char kSingle[] = "single";

  // The sequence and delivery count that a delivered message's reply subject holds:
  // $JS.ACK.[DOMAIN.ACCOUNT.]STREAM.CONSUMER.DELIVERIES.SEQUENCE.ORDER.TIME.PENDING[.MORE]
  static void ReadPosition(std::string_view reply_subject, Delivery& delivery) {
    const std::vector<absl::string_view> tokens =
        absl::StrSplit(absl::string_view(reply_subject.data(), reply_subject.size()), '.');
    if (tokens.size() < 9 || tokens[0] != "$JS" || tokens[1] != "ACK") return;
    const size_t first = tokens.size() == 9 ? 4 : 6;
    int64_t delivery_count = 0;
    uint64_t sequence = 0;
    if (!absl::SimpleAtoi(tokens[first], &delivery_count) || !absl::SimpleAtoi(tokens[first + 1], &sequence)) return;
    delivery.delivery_count = delivery_count;
    delivery.sequence = sequence;
  }

  struct State {
    Consumer consumer;
    // Counts reasons to poll; polled when it differs from its value at the last poll without a message.
    int64_t wanted = 1;
    int64_t asked = 0;
    // This process has ensured that the consumer exists.
    bool has_consumer = false;
  };

  absl::StatusOr<std::optional<Delivery>> Ask(const Consumer& consumer) {
    // An inbox for this request alone: delivered messages keep the subject under which they were queued, so they do not
    // say which request they answer.
    ASSIGN_OR_RETURN(auto inbox, parts_.connection->OpenInbox());
    RETURN_IF_ERROR(parts_.connection->Publish(
        {"$JS.API.CONSUMER.MSG.NEXT." + parts_.names.queue_stream() + "." + consumer.name, kQuestion, {}},
        inbox->subject() + ".1"));
    const absl::StatusOr<NatsMessage> message = inbox->Next(kDeliveryLimit);
    if (!message.ok()) return parts_.connection->Unreachable("no answer in time");
    if (message->status == 503)
      return parts_.connection->Unreachable("the consumer is gone, or has no leader at the moment");
    // No message now, or the consumer is being removed or moved, which the next poll notices.
    if (message->status != 0 || message->reply.empty()) return std::nullopt;
    Delivery delivery{message->content, message->reply};
    ReadPosition(message->reply, delivery);
    return delivery;
  }

  QueueParts& parts_;
  std::mutex mutex_;
  // By consumer.
  std::map<std::string, State> consumers_;
  std::string last_turn_;
};

}  // namespace flair::orchestrator
