// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/consumers.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

constexpr absl::Duration kDeliveryLimit = absl::Seconds(2);
// One message, at most 0.1 s later. Without an end, the server keeps a question that it has nothing for although it
// counts something, and hands the next message to who asked it, who has long gone. "no_wait" alone has no end.
constexpr char kQuestion[] = R"({"batch":1,"expires":100000000})";
const char kSingle[] = "single";

}  // namespace

Consumer Consumers::ConsumerOf(const std::string& subject) const {
  // NAME.queue.OWNER.KIND.ID
  const std::string_view owner = TokenAt(subject, 2);
  const std::string_view kind = TokenAt(subject, 3);
  const std::string id(TokenAt(subject, 4));
  if (kind == "batch") return {"batch-" + id, parts_.names.Batch(owner, id), id};
  if (kind == "named") return {"named-" + id, parts_.names.Named(owner, id), ""};
  return {kSingle, parts_.names.Single("*"), ""};
}

void Consumers::Want(const std::string& subject) {
  const Consumer consumer = ConsumerOf(subject);
  std::lock_guard lock(mutex_);
  State& state = consumers_[consumer.name];
  state.consumer = consumer;
  ++state.wanted;
}

void Consumers::WantBatch(const std::string& batch_id) {
  std::lock_guard lock(mutex_);
  const auto found = consumers_.find("batch-" + batch_id);
  if (found != consumers_.end()) ++found->second.wanted;
}

absl::StatusOr<std::map<std::string, int64_t>> Consumers::Look(const std::string& filter) {
  return parts_.reader.Subjects(parts_.names.queue_stream(), filter);
}

std::vector<Consumer> Consumers::See(const std::map<std::string, int64_t>& messages_by_subject) {
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

std::vector<Consumer> Consumers::Candidates(const TakeFilter& filter) {
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

void Consumers::HadTurn(const Consumer& consumer) {
  if (consumer.batch_id.empty()) return;
  std::lock_guard lock(mutex_);
  last_turn_ = consumer.name;
}

absl::StatusOr<std::optional<Delivery>> Consumers::Next(const Consumer& consumer) {
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
    RETURN_IF_ERROR(MakeConsumer(consumer));
  }
  absl::StatusOr<std::optional<Delivery>> delivery = Ask(consumer);
  std::lock_guard lock(mutex_);
  const auto found = consumers_.find(consumer.name);
  if (found == consumers_.end()) return delivery;
  // Nobody answers for a consumer that is gone, since the batch had ended once: the next question makes it again.
  found->second.has_consumer = delivery.ok();
  if (delivery.ok() && !delivery->has_value()) found->second.asked = wanted;
  return delivery;
}

absl::StatusOr<std::optional<Delivery>> Consumers::Ask(const Consumer& consumer) {
  // An inbox for this question alone: what is delivered keeps the subject under which it was queued, so that nothing in
  // it says which of several questions it answers.
  ASSIGN_OR_RETURN(auto inbox, parts_.connection->OpenInbox());
  RETURN_IF_ERROR(parts_.connection->Publish(
      {"$JS.API.CONSUMER.MSG.NEXT." + parts_.names.queue_stream() + "." + consumer.name, kQuestion, {}},
      inbox->subject() + ".1"));
  const absl::StatusOr<NatsMessage> message = inbox->Next(kDeliveryLimit);
  if (!message.ok()) return parts_.connection->Unreachable("no answer in time");
  if (message->status == 503) return parts_.connection->Unreachable("the consumer is gone, or has no leader just now");
  // No message now; or the consumer goes or moves just now, which the next look sees.
  if (message->status != 0 || message->reply.empty()) return std::nullopt;
  const DeliveryPosition delivery = ParseDelivery(message->reply);
  return Delivery{message->content, message->reply, delivery.sequence, delivery.delivery_count};
}

absl::Status Consumers::MakeConsumer(const Consumer& consumer) {
  const std::string stream = parts_.names.queue_stream();
  const json config = {{"durable_name", consumer.name},
                       {"filter_subject", consumer.filter},
                       {"ack_policy", "explicit"},
                       {"ack_wait", absl::ToInt64Nanoseconds(parts_.lease)},
                       {"max_deliver", -1},
                       {"max_ack_pending", -1},
                       {"deliver_policy", "all"},
                       {"replay_policy", "instant"}};
  return parts_.api
      .Call("CONSUMER.DURABLE.CREATE." + stream + "." + consumer.name,
            json{{"stream_name", stream}, {"config", config}})
      .status();
}

absl::Status Consumers::Remove(const Consumer& consumer, uint64_t ended_sequence) {
  const std::string stream = parts_.names.queue_stream();
  const json ended = {{"filter", consumer.filter}, {"seq", ended_sequence + 1}};
  RETURN_IF_ERROR(parts_.api.Call("STREAM.PURGE." + stream, ended).status());
  const absl::Status status = parts_.api.Call("CONSUMER.DELETE." + stream + "." + consumer.name, nullptr).status();
  return absl::IsNotFound(status) ? absl::OkStatus() : status;
}

absl::StatusOr<Consumers::Depth> Consumers::DepthOf(const std::map<std::string, int64_t>& messages_by_subject) {
  // By consumer, since the owners of jobs without a batch share one.
  std::map<std::string, int64_t> messages;
  for (const auto& [subject, count] : messages_by_subject) {
    const Consumer consumer = ConsumerOf(subject);
    if (!consumer.name.starts_with("named-")) messages[consumer.name] += count;
  }
  std::vector<std::pair<std::string, json>> calls;
  for (const auto& [consumer, count] : messages) {
    calls.emplace_back("CONSUMER.INFO." + parts_.names.queue_stream() + "." + consumer, nullptr);
  }
  Depth depth;
  auto consumer = messages.begin();
  for (const absl::StatusOr<json>& info : parts_.api.CallAll(calls)) {
    const int64_t all = (consumer++)->second;
    if (absl::IsNotFound(info.status())) {
      // Nobody has ever asked.
      depth.waiting += all;
      continue;
    }
    if (!info.ok()) return info.status();
    depth.waiting += info->value("num_pending", int64_t{0});
    depth.delivered += info->value("num_ack_pending", int64_t{0});
  }
  return depth;
}

}  // namespace flair::orchestrator
