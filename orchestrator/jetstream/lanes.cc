// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/lanes.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

constexpr absl::Duration kOneAnswer = absl::Seconds(2);
// One message, at most 0.1 s later. Without an end, the server keeps a question that it has nothing for although it
// counts something, and hands the next message to who asked it, who has long gone. "no_wait" alone has no end.
constexpr char kQuestion[] = R"({"batch":1,"expires":100000000})";
const char kSingle[] = "single";

}  // namespace

Lane Lanes::LaneOf(const std::string& subject) const {
  // NAME.queue.OWNER.KIND.ID
  const std::string_view owner = TokenAt(subject, 2);
  const std::string_view kind = TokenAt(subject, 3);
  const std::string id(TokenAt(subject, 4));
  if (kind == "batch") return {"batch-" + id, parts_.names.Batch(owner, id), id};
  if (kind == "named") return {"named-" + id, parts_.names.Named(owner, id), ""};
  return {kSingle, parts_.names.Single("*"), ""};
}

void Lanes::Want(const std::string& subject) {
  const Lane lane = LaneOf(subject);
  std::lock_guard lock(mutex_);
  State& state = lanes_[lane.consumer];
  state.lane = lane;
  ++state.wanted;
}

void Lanes::WantAll() {
  std::lock_guard lock(mutex_);
  for (auto& [consumer, state] : lanes_) ++state.wanted;
}

void Lanes::WantBatch(const std::string& batch_id) {
  std::lock_guard lock(mutex_);
  const auto found = lanes_.find("batch-" + batch_id);
  if (found != lanes_.end()) ++found->second.wanted;
}

absl::StatusOr<std::map<std::string, int64_t>> Lanes::Look(const std::string& filter) {
  return parts_.reader.Subjects(parts_.names.queue_stream(), filter);
}

std::vector<Lane> Lanes::See(const std::map<std::string, int64_t>& messages_by_subject) {
  std::set<std::string> there = {kSingle};
  for (const auto& [subject, count] : messages_by_subject) {
    there.insert(LaneOf(subject).consumer);
    Want(subject);
  }
  std::vector<Lane> gone;
  std::lock_guard lock(mutex_);
  for (const auto& [consumer, state] : lanes_) {
    if (!there.contains(consumer)) gone.push_back(state.lane);
  }
  for (const Lane& lane : gone) lanes_.erase(lane.consumer);
  return gone;
}

std::vector<Lane> Lanes::Candidates(const TakeFilter& filter) {
  std::vector<Lane> first;
  std::vector<Lane> later;
  std::vector<Lane> earlier;
  std::lock_guard lock(mutex_);
  for (const auto& [consumer, state] : lanes_) {
    if (state.wanted == state.asked) continue;
    const Lane& lane = state.lane;
    if (!filter.any && !filter.batch_ids.contains(lane.batch_id) &&
        !(consumer.starts_with("named-") && filter.job_ids.contains(consumer.substr(6)))) {
      continue;
    }
    if (lane.batch_id.empty()) {
      first.push_back(lane);
    } else {
      (consumer > last_turn_ ? later : earlier).push_back(lane);
    }
  }
  first.insert(first.end(), later.begin(), later.end());
  first.insert(first.end(), earlier.begin(), earlier.end());
  return first;
}

void Lanes::HadTurn(const Lane& lane) {
  if (lane.batch_id.empty()) return;
  std::lock_guard lock(mutex_);
  last_turn_ = lane.consumer;
}

absl::StatusOr<std::optional<Handed>> Lanes::Next(const Lane& lane) {
  int64_t wanted = 0;
  bool has_consumer = false;
  {
    std::lock_guard lock(mutex_);
    const auto found = lanes_.find(lane.consumer);
    if (found == lanes_.end()) return std::nullopt;
    wanted = found->second.wanted;
    has_consumer = found->second.has_consumer;
  }
  if (!has_consumer) {
    RETURN_IF_ERROR(MakeConsumer(lane));
  }
  absl::StatusOr<std::optional<Handed>> handed = Ask(lane);
  std::lock_guard lock(mutex_);
  const auto found = lanes_.find(lane.consumer);
  if (found == lanes_.end()) return handed;
  // Nobody answers for a consumer that is gone, since the batch had ended once: the next question makes it again.
  found->second.has_consumer = handed.ok();
  if (handed.ok() && !handed->has_value()) found->second.asked = wanted;
  return handed;
}

absl::StatusOr<std::optional<Handed>> Lanes::Ask(const Lane& lane) {
  // An inbox for this question alone: what is handed out keeps the subject under which it was queued, so that nothing
  // in it says which of several questions it answers.
  ASSIGN_OR_RETURN(auto inbox, parts_.connection->OpenInbox());
  RETURN_IF_ERROR(parts_.connection->Publish(
      {"$JS.API.CONSUMER.MSG.NEXT." + parts_.names.queue_stream() + "." + lane.consumer, kQuestion, {}},
      (inbox)->subject() + ".1"));
  const absl::StatusOr<NatsMessage> message = (inbox)->Next(kOneAnswer);
  if (!message.ok()) return parts_.connection->Unreachable("no answer in time");
  if (message->status == 503) return parts_.connection->Unreachable("the consumer is gone, or has no leader just now");
  // No message now; or the consumer goes or moves just now, which the next look sees.
  if (message->status != 0 || message->reply.empty()) return std::nullopt;
  const Delivery delivery = ParseDelivery(message->reply);
  return Handed{message->content, message->reply, delivery.sequence, delivery.delivery_count};
}

absl::Status Lanes::MakeConsumer(const Lane& lane) {
  const std::string stream = parts_.names.queue_stream();
  const json config = {{"durable_name", lane.consumer},
                       {"filter_subject", lane.filter},
                       {"ack_policy", "explicit"},
                       {"ack_wait", absl::ToInt64Nanoseconds(parts_.lease)},
                       {"max_deliver", -1},
                       {"max_ack_pending", -1},
                       {"deliver_policy", "all"},
                       {"replay_policy", "instant"}};
  return parts_.api
      .Call("CONSUMER.DURABLE.CREATE." + stream + "." + lane.consumer,
            json{{"stream_name", stream}, {"config", config}})
      .status();
}

absl::Status Lanes::Remove(const Lane& lane, uint64_t ended_sequence) {
  const std::string stream = parts_.names.queue_stream();
  const json ended = {{"filter", lane.filter}, {"seq", ended_sequence + 1}};
  absl::Status status = parts_.api.Call("STREAM.PURGE." + stream, ended).status();
  if (!status.ok()) return status;
  status = parts_.api.Call("CONSUMER.DELETE." + stream + "." + lane.consumer, nullptr).status();
  return absl::IsNotFound(status) ? absl::OkStatus() : status;
}

absl::StatusOr<Lanes::Depth> Lanes::DepthOf(const std::map<std::string, int64_t>& messages_by_subject) {
  // By consumer, since the owners of alone standing jobs share one.
  std::map<std::string, int64_t> messages;
  for (const auto& [subject, count] : messages_by_subject) {
    const Lane lane = LaneOf(subject);
    if (!lane.consumer.starts_with("named-")) messages[lane.consumer] += count;
  }
  std::vector<std::pair<std::string, json>> calls;
  for (const auto& [consumer, count] : messages) {
    calls.emplace_back("CONSUMER.INFO." + parts_.names.queue_stream() + "." + consumer, nullptr);
  }
  Depth depth;
  auto lane = messages.begin();
  for (const absl::StatusOr<json>& info : parts_.api.CallAll(calls)) {
    const int64_t all = (lane++)->second;
    if (absl::IsNotFound(info.status())) {
      // Nobody has ever asked.
      depth.waiting += all;
      continue;
    }
    if (!info.ok()) return info.status();
    depth.waiting += info->value("num_pending", int64_t{0});
    depth.handed += info->value("num_ack_pending", int64_t{0});
  }
  return depth;
}

}  // namespace flair::orchestrator
