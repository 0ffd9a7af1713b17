// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/stream_reader.h"

#include <nlohmann/json.hpp>

#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

// Consumers that nobody removed, because their process died, go after this.
constexpr absl::Duration kConsumerLife = absl::Seconds(30);
// A message on its way from the server.
constexpr absl::Duration kOneMessage = absl::Seconds(2);

json ConsumerOf(const std::string& stream, const std::string& filter, uint64_t first_sequence, bool with_content) {
  json config = {{"ack_policy", "none"},
                 {"replay_policy", "instant"},
                 {"filter_subject", filter},
                 {"inactive_threshold", absl::ToInt64Nanoseconds(kConsumerLife)},
                 {"num_replicas", 1},
                 {"mem_storage", true},
                 {"headers_only", !with_content},
                 {"deliver_policy", first_sequence <= 1 ? "all" : "by_start_sequence"}};
  if (first_sequence > 1) config["opt_start_seq"] = first_sequence;
  return {{"stream_name", stream}, {"config", config}};
}

}  // namespace

Delivery ParseDelivery(std::string_view reply_subject) {
  const std::vector<absl::string_view> tokens =
      absl::StrSplit(absl::string_view(reply_subject.data(), reply_subject.size()), '.');
  // $JS.ACK.[DOMAIN.ACCOUNT.]STREAM.CONSUMER.DELIVERIES.SEQUENCE.ORDER.TIME.PENDING[.MORE]
  Delivery delivery;
  if (tokens.size() < 9 || tokens[0] != "$JS" || tokens[1] != "ACK") return delivery;
  const size_t first = tokens.size() == 9 ? 4 : 6;
  if (!absl::SimpleAtoi(tokens[first], &delivery.delivery_count) ||
      !absl::SimpleAtoi(tokens[first + 1], &delivery.sequence)) {
    return {};
  }
  return delivery;
}

absl::StatusOr<std::vector<int64_t>> StreamReader::Count(const std::string& stream,
                                                         std::span<const std::string> filters) {
  std::vector<std::pair<std::string, json>> calls;
  for (const std::string& filter : filters) {
    calls.emplace_back("CONSUMER.CREATE." + stream, ConsumerOf(stream, filter, 1, false));
  }
  return api_.WithinLimit([&]() -> absl::StatusOr<std::vector<int64_t>> {
    std::vector<int64_t> counts;
    absl::Status failed;
    for (const absl::StatusOr<json>& made : api_.CallAll(calls)) {
      failed.Update(made.status());
      if (!made.ok()) continue;
      counts.push_back(made->value("num_pending", int64_t{0}));
      Forget(stream, made->value("name", ""));
    }
    if (!failed.ok()) return failed;
    return counts;
  });
}

void StreamReader::Forget(const std::string& stream, const std::string& consumer) {
  (void)api_.connection().Publish({"$JS.API.CONSUMER.DELETE." + stream + "." + consumer, "", {}});
}

absl::StatusOr<std::vector<StreamReader::Message>> StreamReader::Read(const std::string& stream, const Range& range) {
  return api_.WithinLimit([&] { return ReadOnce(stream, range); });
}

absl::StatusOr<std::vector<StreamReader::Message>> StreamReader::ReadOnce(const std::string& stream,
                                                                          const Range& range) {
  const absl::StatusOr<json> made = api_.Call(
      "CONSUMER.CREATE." + stream, ConsumerOf(stream, range.filter, range.first_sequence, range.with_content));
  if (!made.ok()) return made.status();
  const std::string consumer = made->value("name", "");
  absl::StatusOr<std::unique_ptr<NatsInbox>> inbox = api_.connection().OpenInbox();
  if (!inbox.ok()) return inbox.status();
  const json next = {{"batch", range.limit}, {"no_wait", true}};
  if (absl::Status status = api_.connection().Publish(
          {"$JS.API.CONSUMER.MSG.NEXT." + stream + "." + consumer, next.dump(), {}}, (*inbox)->subject() + ".0");
      !status.ok()) {
    return status;
  }
  std::vector<Message> read;
  const int64_t there = made->value("num_pending", int64_t{0});
  while (static_cast<int64_t>(read.size()) < std::min<int64_t>(range.limit, there)) {
    absl::StatusOr<NatsMessage> message = (*inbox)->Next(kOneMessage);
    if (!message.ok()) return absl::UnavailableError("the queue's servers stopped while they were read");
    if (message->status != 0) break;
    read.push_back({std::move(message->subject), std::move(message->content), ParseDelivery(message->reply).sequence});
  }
  Forget(stream, consumer);
  return read;
}

absl::StatusOr<uint64_t> StreamReader::LastSequence(const std::string& stream) {
  const absl::StatusOr<json> info = api_.Call("STREAM.INFO." + stream, nullptr);
  if (!info.ok()) return info.status();
  return info->value("state", json::object()).value("last_seq", uint64_t{0});
}

}  // namespace flair::orchestrator
